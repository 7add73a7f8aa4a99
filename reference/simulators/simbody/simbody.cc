// The adapter of Simbody: a Scene in, motion out.
// Sees the simulator interface and Simbody's headers; never a scenario, a claim or another adapter.
#include "harness/core/simulator.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/simulators/simbody/simbody_limits.h"
#include "reference/simulators/simbody/simbody_settings.h"
#include "reference/simulators/simbody/simbody_world.h"

#include <fmt/format.h>

#include <cstdint>
#include <exception>
#include <limits>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cylon::simulators {
namespace {

using core::BodyState;
using core::Quaternion;
using core::Scene;
using core::Setup;
using core::State;
using core::Vector3;

static_assert(sizeof(SimTK::Real) == sizeof(double), "this adapter states double precision");

std::string version() {
  int major = 0, minor = 0, patch = 0;
  SimTK_version_simbody(&major, &minor, &patch);
  return fmt::format("{}.{}.{}", major, minor, patch);
}

std::unique_ptr<SimTK::Integrator> make_integrator(SimbodyMethod method, const SimTK::System& system,
                                                   double dt) {
  switch (method) {
    case SimbodyMethod::semi_explicit_euler:
      return std::make_unique<SimTK::SemiExplicitEulerIntegrator>(system, dt);
    case SimbodyMethod::semi_explicit_euler_2:
      return std::make_unique<SimTK::SemiExplicitEuler2Integrator>(system);
    case SimbodyMethod::verlet:
      return std::make_unique<SimTK::VerletIntegrator>(system);
    case SimbodyMethod::rk3:
      return std::make_unique<SimTK::RungeKutta3Integrator>(system);
    case SimbodyMethod::merson:
      return std::make_unique<SimTK::RungeKuttaMersonIntegrator>(system);
    case SimbodyMethod::feldberg:
      return std::make_unique<SimTK::RungeKuttaFeldbergIntegrator>(system);
  }
  throw std::logic_error("no such method");
}

class Simbody final : public core::Simulator {
 public:
  const core::Engine& engine() const override { return engine_; }

  std::optional<std::string> unsupported(const Scene& scene, const Setup& setup) const override {
    if (auto reason = applied::without_step("Simbody", setup)) return reason;
    if (auto reason = simbody_limit(scene)) return reason;
    simbody_settings(engine_, setup, SimbodyKind());  // throws where the setup is impossible
    return std::nullopt;
  }

  core::Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;
  std::vector<std::string> remarks() const override;

 private:
  void begin(const SimTK::State&);
  void set_masses();
  void advance_to(double time);
  void read_state(const SimTK::State&, State&) const;
  void apply(const SimTK::State&, SimTK::Vector_<SimTK::SpatialVec>&);

  core::Engine engine_ = simbody_engine(version());
  applied::Settings settings_;
  Scene scene_;
  applied::Forest forest_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  std::unique_ptr<SimbodyWorld> world_;
  std::unique_ptr<SimTK::Integrator> integrator_;
  std::optional<applied::Forces> forces_;
  State state_;
  std::exception_ptr thrown_;  // by a force: Simbody catches what a step throws
  std::optional<std::string> lost_;
  std::int64_t failed_ = 0, first_failed_ = 0;  // steps that did not converge
};

// ---- Loading ----------------------------------------------------------------------------------------

core::Terms Simbody::load(const Scene& scene, const Setup& setup) {
  forest_ = applied::forest_of(scene);
  forces_.emplace(scene);
  const SimbodyKind kind{!forest_.loops.empty(), !forces_->changing().empty()};
  settings_ = simbody_settings(engine_, setup, kind);
  scene_ = scene, dt_ = setup.dt, steps_ = 0;
  thrown_ = nullptr, lost_.reset(), failed_ = 0;
  integrator_.reset();
  SimbodyLaw law;
  if (forces_->any() || core::states_own_gravity(scene_))
    law = [this](const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on) { apply(state, on); };
  world_ = std::make_unique<SimbodyWorld>(scene_, forest_, std::move(law));
  begin(world_->start(scene_, forest_));
  return simbody_terms(settings_, kind);
}

// An integrator that starts from a state, which it projects onto the constraints.
void Simbody::begin(const SimTK::State& start) {
  const SimbodyIntegrator& scheme = simbody_integrator(settings_.integrator);
  integrator_ = make_integrator(scheme.method, world_->system(), dt_);
  if (!scheme.adaptive) integrator_->setFixedStepSize(dt_);
  integrator_->setAccuracy(settings_.at("accuracy"));
  if (settings_.reasons.contains("constraint-tolerance"))
    integrator_->setConstraintTolerance(settings_.at("constraint-tolerance"));
  integrator_->setProjectEveryStep(settings_.at("project") != 0);
  integrator_->setUseInfinityNorm(settings_.at("norm") != 0);
  integrator_->setAllowInterpolation(scheme.adaptive && settings_.at("interpolation") != 0);
  integrator_->initialize(start);
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

// ---- A step -----------------------------------------------------------------------------------------

void Simbody::step() {
  ++steps_;
  if (lost_) return;
  const bool changes = !forces_->changing().empty();
  if (changes) {  // outside, for what it throws is a force's sentence
    read(state_);
    forces_->at(static_cast<double>(steps_ - 1) * dt_, state_);
  }
  try {
    if (changes) set_masses();
    advance_to(static_cast<double>(steps_) * dt_);
  } catch (const std::exception& error) {
    if (!thrown_) lost_ = error.what();
  }
  if (thrown_) std::rethrow_exception(std::exchange(thrown_, nullptr));
}

// Simbody's first call after a start returns where it is, and a later one may return within a step.
void Simbody::advance_to(double time) {
  const int failures = integrator_->getNumConvergenceTestFailures();
  while (integrator_->getTime() < time) integrator_->stepTo(time);
  // A state that is not finite throws when it is realized: here, where it is caught, and not where it is read.
  world_->system().realize(integrator_->getState(), SimTK::Stage::Velocity);
  const bool fixed = !simbody_integrator(settings_.integrator).adaptive;
  if (!fixed || integrator_->getNumConvergenceTestFailures() == failures) return;
  if (failed_++ == 0) first_failed_ = steps_;
}

// For the whole step: masses are part of Simbody's model, and a new model is a new start.
void Simbody::set_masses() {
  const SimTK::State before = integrator_->getState();
  for (const std::size_t i : forces_->changing())
    if (!scene_.bodies[i].locked) world_->set_mass(i, forces_->mass(i));
  SimTK::State now = world_->moved(before);
  now.updTime() = static_cast<double>(steps_ - 1) * dt_;
  begin(now);
}

// Called in each evaluation of the acceleration, at its own time and state.
void Simbody::apply(const SimTK::State& state, SimTK::Vector_<SimTK::SpatialVec>& on) try {
  read_state(state, state_);
  const std::vector<applied::Wrench>& wrenches = forces_->at(state.getTime(), state_);
  for (std::size_t i = 0; i < wrenches.size(); ++i) {
    if (scene_.bodies[i].locked) continue;
    Vector3 force = wrenches[i].force;
    // A mass that changes is held for the step, and what falls falls with it.
    if (const auto& gravity = scene_.bodies[i].gravity)
      force += world_->mobilized(i).getBodyMass(state) * *gravity;
    const SimTK::SpatialVec wrench(to_simbody(wrenches[i].torque), to_simbody(force));
    on[world_->mobilized(i).getMobilizedBodyIndex()] += wrench;
  }
} catch (...) {
  if (!thrown_) thrown_ = std::current_exception();
}

// ---- Reading ----------------------------------------------------------------------------------------

void Simbody::read(State& out) const {
  if (!lost_) {
    const SimTK::State& state = integrator_->getState();
    world_->system().realize(state, SimTK::Stage::Velocity);
    return read_state(state, out);
  }
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 none = Vector3::Constant(nan);
  out.resize(scene_.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    out[i] = {none, Quaternion(nan, nan, nan, nan), none, none};
    if (scene_.bodies[i].locked) out[i] = core::initial_state(scene_)[i];
  }
}

// A free body is what Simbody integrates; of others the pose follows from the coordinates.
void Simbody::read_state(const SimTK::State& state, State& out) const {
  out.resize(scene_.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    if (scene_.bodies[i].locked) {
      const BodyState& start = scene_.bodies[i].initial;
      out[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
      continue;
    }
    const SimTK::MobilizedBody& body = world_->mobilized(i);
    if (forest_.nodes[i].joint < 0) {
      const auto q = [&](int k) { return body.getOneQ(state, k); };
      const auto u = [&](int k) { return body.getOneU(state, k); };
      out[i] = {{q(4), q(5), q(6)},
                Quaternion(q(0), q(1), q(2), q(3)).normalized(),
                {u(3), u(4), u(5)},
                {u(0), u(1), u(2)}};
    } else {
      const SimTK::Transform& pose = body.getBodyTransform(state);
      const SimTK::SpatialVec& speed = body.getBodyVelocity(state);
      const SimTK::Quaternion q = pose.R().convertRotationToQuaternion();
      out[i] = {from_simbody(pose.p()), Quaternion(q[0], q[1], q[2], q[3]), from_simbody(speed[1]),
                from_simbody(speed[0])};
    }
  }
}

std::vector<std::string> Simbody::remarks() const {
  std::vector<std::string> all;
  if (failed_ > 0)
    all.push_back(
        fmt::format("{} of {} steps, the first of them {}, did not converge in Simbody's iteration or "
                    "projection; at a fixed step it goes on with what it has",
                    failed_, steps_, first_failed_));
  if (lost_)
    all.push_back(fmt::format("Simbody gave up: {}; all states since then are shown as not finite", *lost_));
  return all;
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Simbody>(); }

}  // namespace cylon::core
