// The adapter of DART: a Scene in, motion out.
// Sees the simulator interface and the border to DART; never DART's headers, a scenario, a claim or another adapter.
#include "harness/core/simulator.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/simulators/dart/dart_limits.h"
#include "reference/simulators/dart/dart_scene.h"
#include "reference/simulators/dart/dart_settings.h"

#include <fmt/format.h>

#include <cstdint>
#include <optional>
#include <utility>

namespace cylon::simulators {
namespace {

using core::Scene;
using core::Setup;
using core::State;
using core::Vector3;

class Dart final : public core::Simulator {
 public:
  const core::Engine& engine() const override { return engine_; }

  std::optional<std::string> unsupported(const Scene& scene, const Setup& setup) const override {
    if (auto reason = applied::without_step("DART", setup)) return reason;
    if (auto reason = dart_limit(scene)) return reason;
    dart_settings(engine_, setup, DartKind());  // throws where the setup is impossible
    return std::nullopt;
  }

  core::Terms load(const Scene&, const Setup&) override;
  void step() override;
  void read(State&) const override;
  std::vector<std::string> remarks() const override;
  std::vector<core::Contact> contacts() const override;

 private:
  void apply_forces();
  void see_what_is_unsolved();
  void see_edges();

  core::Engine engine_ = dart_engine(dart_border::World::version());
  Scene scene_;
  double dt_ = 0;
  std::int64_t steps_ = 0;
  std::unique_ptr<DartSurfaces> surfaces_;  // before the world, whose filter asks them
  std::unique_ptr<dart_border::World> world_;
  std::optional<applied::Forces> forces_;
  State state_;
  std::int64_t first_given_up_ = 0, first_left_ = 0;  // steps
  std::optional<std::string> past_;                   // the first body past the edge of a box that is a plane
};

core::Terms Dart::load(const Scene& scene, const Setup& setup) {
  const applied::Forest forest = applied::forest_of(scene);
  const bool touches = core::any_touching_pair(scene, [](const core::Pair&) { return true; });
  const applied::Settings settings = dart_settings(engine_, setup, {touches, !forest.loops.empty()});
  scene_ = scene, dt_ = setup.dt, steps_ = 0;
  first_given_up_ = first_left_ = 0, past_.reset();
  forces_.emplace(scene_);
  world_.reset();
  surfaces_ = std::make_unique<DartSurfaces>(scene_);
  world_ = std::make_unique<dart_border::World>(
      dart_bodies(scene_, forest), surfaces_->shapes(), dart_loops(scene_, forest),
      dart_border_settings(settings, dt_, core::gravity(scene_)),
      [surfaces = surfaces_.get()](int shape, int other) { return surfaces->meet(shape, other); });
  return dart_terms(settings);
}

// ---- A step -----------------------------------------------------------------------------------------

// DART holds a force over the step and then clears it.  A body's own gravity is one.
void Dart::apply_forces() {
  const bool own = core::states_own_gravity(scene_);
  if (!forces_->any() && !own) return;
  read(state_);
  const std::vector<applied::Wrench>& wrenches = forces_->at(static_cast<double>(steps_) * dt_, state_);
  for (const std::size_t i : forces_->changing())
    if (!scene_.bodies[i].locked) world_->set_mass(i, forces_->mass(i));
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    if (scene_.bodies[i].locked) continue;
    Vector3 force = wrenches[i].force;
    if (const auto& gravity = scene_.bodies[i].gravity) force += forces_->mass(i) * *gravity;
    world_->push(i, to_dart(force), to_dart(wrenches[i].torque));
  }
}

void Dart::step() {
  apply_forces();
  ++steps_;
  world_->step();
  see_what_is_unsolved();
  see_edges();
}

void Dart::see_what_is_unsolved() {
  const dart_border::Unsolved unsolved = world_->unsolved();
  if (unsolved.given_up > 0 && first_given_up_ == 0) first_given_up_ = steps_;
  if (unsolved.left > 0 && first_left_ == 0) first_left_ = steps_;
}

// Past the edge of the box that stands for a plane there is no plane.
void Dart::see_edges() {
  if (scene_.planes.empty() || past_) return;
  for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
    const core::Body& body = scene_.bodies[i];
    if (body.locked || !core::collides(body)) continue;
    const Vector3 place = from_dart(world_->motion(i).position);
    for (const core::Plane& plane : scene_.planes) {
      const double reach = (place - plane.normal.dot(place) * plane.normal).norm();
      if (!(reach > dart_plane_reach)) continue;
      past_ = fmt::format("'{}' passed the edge of the box that stands for '{}' in step {}", body.name,
                          plane.name, steps_);
      return;
    }
  }
}

// ---- Reading ----------------------------------------------------------------------------------------

void Dart::read(State& out) const {
  out.resize(scene_.bodies.size());
  for (std::size_t i = 0; i < out.size(); ++i) {
    const core::BodyState& start = scene_.bodies[i].initial;
    out[i] = {start.position, start.orientation, Vector3::Zero(), Vector3::Zero()};
    if (scene_.bodies[i].locked) continue;
    const dart_border::Motion motion = world_->motion(i);
    const dart_border::Turn& q = motion.orientation;
    out[i] = {from_dart(motion.position), core::Quaternion(q[0], q[1], q[2], q[3]),
              from_dart(motion.velocity), from_dart(motion.spin)};
  }
}

std::vector<std::string> Dart::remarks() const {
  std::vector<std::string> all;
  const dart_border::Unsolved unsolved = world_ ? world_->unsolved() : dart_border::Unsolved();
  if (unsolved.given_up > 0)
    all.push_back(fmt::format(
        "Dantzig's method gave up {} times in {} steps, first in step {}; DART solved these by sweeps",
        unsolved.given_up, steps_, first_given_up_));
  if (unsolved.left > 0)
    all.push_back(fmt::format(
        "DART did not solve {} systems of contacts and loops in {} steps, the first in step {}; it went on "
        "with "
        "what it had{}",
        unsolved.left, steps_, first_left_,
        unsolved.not_finite > 0 ? fmt::format(", and without any impulse {} times", unsolved.not_finite)
                                : ""));
  if (past_) all.push_back(*past_);
  return all;
}

std::vector<core::Contact> Dart::contacts() const {
  std::vector<core::Contact> told;
  for (const dart_border::Contact& contact : world_->contacts()) {
    const DartSurface &first = surfaces_->of(contact.first), &second = surfaces_->of(contact.second);
    // The contact is of the body with the lower index, or of the body on a plane.
    const bool turned = first.plane >= 0 || (second.plane < 0 && second.body < first.body);
    const DartSurface &one = turned ? second : first, &other = turned ? first : second;
    const Vector3 normal = (turned ? -1.0 : 1.0) * from_dart(contact.normal);
    const Vector3 impulse = (turned ? -dt_ : dt_) * from_dart(contact.force);
    const double along = normal.dot(impulse);
    if (!(along > 0)) continue;
    core::Contact here;
    here.pair = {one.body, other.body, other.plane};
    here.point = from_dart(contact.point);
    here.normal = normal;
    here.impulse = along;
    here.friction = impulse - along * normal;
    told.push_back(here);
  }
  return told;
}

}  // namespace
}  // namespace cylon::simulators

namespace cylon::core {

std::unique_ptr<Simulator> make_simulator() { return std::make_unique<simulators::Dart>(); }

}  // namespace cylon::core
