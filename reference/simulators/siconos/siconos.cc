// The adapter of Siconos: a Scene in, motion out.
// Sees the simulator interface and the border to Siconos; never Siconos's headers, a scenario, a claim or another adapter.
#include "harness/core/simulator.h"
#include "reference/applied/blas_threads.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/simulators/siconos/siconos_limits.h"
#include "reference/simulators/siconos/siconos_scene.h"
#include "reference/simulators/siconos/siconos_settings.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdint>
#include <exception>
#include <limits>
#include <optional>

namespace cylon::simulators {
namespace {

using core::Quaternion;
using core::Scene;
using core::Setup;
using core::State;
using core::Vector3;

core::BodyState state(const siconos_border::Motion& motion) {
  const auto& q = motion.orientation;
  const Quaternion turn(q[0], q[1], q[2], q[3]);
  return {from_siconos(motion.position), turn, from_siconos(motion.velocity),
          turn * from_siconos(motion.spin)};
}

class Siconos final : public core::Simulator {
 public:
  const core::Engine& engine() const override { return engine_; }

  std::optional<std::string> unsupported(const Scene& scene, const Setup& setup) const override {
    if (auto reason = applied::without_step("Siconos", setup)) return reason;
    if (auto reason = siconos_limit(scene)) return reason;
    siconos_settings(engine_, setup, SiconosKind());  // throws where the setup is impossible
    return std::nullopt;
  }

  core::Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;
  std::vector<std::string> remarks() const override;
  std::vector<core::Contact> contacts() const override;

 private:
  std::size_t index(std::size_t body) const { return static_cast<std::size_t>(translated_.index[body]); }
  void apply_forces();

  // Siconos tells no version, and its CMake files name that of the next release.
  core::Engine engine_ = siconos_engine(CYLON_PACKAGE_VERSION);
  Scene scene_;
  double dt_ = 0, theta_ = 0.5;
  std::int64_t steps_ = 0;
  SiconosScene translated_;
  std::unique_ptr<siconos_border::World> world_;
  std::optional<applied::Forces> forces_;
  State state_;
  std::int64_t first_of_solver_ = 0, first_of_newton_ = 0;  // steps
  std::optional<std::string> lost_;
};

core::Terms Siconos::load(const Scene& scene, const Setup& setup) {
  forces_.emplace(scene);
  const bool touches = core::any_touching_pair(scene, [](const core::Pair&) { return true; });
  translated_ = siconos_scene(scene);
  const bool rough = std::ranges::any_of(translated_.contacts,
                                         [](const siconos_border::Contact& one) { return one.friction > 0; });
  const SiconosKind kind{touches, forces_->any(), rough};
  const applied::Settings settings = siconos_settings(engine_, setup, kind);
  scene_ = scene, dt_ = setup.dt, steps_ = 0;
  first_of_solver_ = first_of_newton_ = 0, lost_.reset();
  const siconos_border::Settings own = siconos_border_settings(settings, dt_);
  theta_ = own.theta;
  applied::use_one_blas_thread();
  world_ = std::make_unique<siconos_border::World>(translated_.bodies, translated_.contacts, own);
  return siconos_terms(settings, kind);
}

// ---- A step -----------------------------------------------------------------------------------------

// Gravity is a force here, as all others are.  The step is
//   v' = v + dt F/m,   x' = x + dt (theta v' + (1 - theta) v);
// with F at x + (1 - theta) dt v it is the midpoint rule for theta = 1/2, and symplectic Euler for 1: both keep the area of
// phase space.  With F at x the midpoint would gain (w dt)^2/2 of it in each step.
void Siconos::apply_forces() {
  read(state_);
  const double ahead = (1 - theta_) * dt_;
  for (core::BodyState& body : state_) {
    body.position += ahead * body.velocity;
    const double spin = body.angular_velocity.norm();
    if (spin > 0)
      body.orientation =
          Quaternion(Eigen::AngleAxisd(ahead * spin, body.angular_velocity / spin)) * body.orientation;
  }
  const std::vector<applied::Wrench>& wrenches =
      forces_->at(static_cast<double>(steps_) * dt_ + ahead, state_);
  for (const std::size_t i : forces_->changing())
    if (!scene_.bodies[i].locked) world_->set_mass(index(i), forces_->mass(i));
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    const core::Body& body = scene_.bodies[i];
    if (body.locked) continue;
    const Vector3 weight = forces_->mass(i) * core::gravity_of(scene_, body);
    world_->push(index(i), to_siconos(wrenches[i].force + weight),
                 to_siconos(state_[i].orientation.conjugate() * wrenches[i].torque));
  }
}

void Siconos::step() {
  if (!lost_) apply_forces();
  ++steps_;
  if (lost_) return;
  try {
    world_->step();
  } catch (const std::exception& error) {
    lost_ = error.what();
  }
  const siconos_border::Complaints& complaints = world_->complaints();
  if (complaints.of_solver > 0 && first_of_solver_ == 0) first_of_solver_ = steps_;
  if (complaints.of_newton > 0 && first_of_newton_ == 0) first_of_newton_ = steps_;
}

// ---- Reading ----------------------------------------------------------------------------------------

void Siconos::read(State& out) const {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Vector3 none = Vector3::Constant(nan);
  out.resize(scene_.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const core::BodyState& start = scene_.bodies[i].initial;
    if (scene_.bodies[i].locked)
      out[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
    else if (lost_)
      out[i] = {none, Quaternion(nan, nan, nan, nan), none, none};
    else
      out[i] = state(world_->motion(index(i)));
  }
}

std::vector<std::string> Siconos::remarks() const {
  std::vector<std::string> all;
  const siconos_border::Complaints complaints = world_ ? world_->complaints() : siconos_border::Complaints();
  if (complaints.of_solver > 0)
    all.push_back(
        fmt::format("Siconos's solver of contacts failed {} times in {} steps, first in step {}; it goes on "
                    "with what it has",
                    complaints.of_solver, steps_, first_of_solver_));
  if (complaints.of_newton > 0)
    all.push_back(
        fmt::format("Newton's iteration did not end in {} of {} steps, first in step {}; Siconos goes on "
                    "with what it has",
                    complaints.of_newton, steps_, first_of_newton_));
  if (lost_)
    all.push_back(fmt::format("Siconos gave up: {}; all states since then are shown as not finite", *lost_));
  return all;
}

std::vector<core::Contact> Siconos::contacts() const {
  std::vector<core::Contact> told;
  if (lost_) return told;
  for (const siconos_border::Pressed& pressed : world_->pressed())
    told.push_back({translated_.pairs[static_cast<std::size_t>(pressed.contact)], from_siconos(pressed.point),
                    from_siconos(pressed.normal), pressed.along, from_siconos(pressed.across)});
  return told;
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Siconos>(); }

}  // namespace cylon::core
