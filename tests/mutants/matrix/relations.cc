// Judges without exact solutions: a transformed scene must have the transformed motion.
#include "harness/core/observable.h"
#include "tests/mutants/matrix/judge.h"
#include "tests/mutants/matrix/restated.h"
#include "tests/mutants/matrix/scenes.h"
#include "tests/paths.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace cylon::mutants {
namespace {

using core::Quaternion;
using core::Scene;
using core::State;
using core::Vector3;

using Findings = std::optional<std::vector<Finding>>;

constexpr double dt = 1.0 / 1024;
constexpr std::int64_t steps = 616;  // the box has landed
constexpr double duration = dt * steps;

Scene scene_of(const char* file) {
  return scenario::load(std::filesystem::path(source_dir) / "scenarios" / file).scene;
}

// Two bodies on a damped spring that ends off their centres; nothing acts from outside.
Scene damped_pair() {
  Scene scene = scene_of("two_body_spring.toml");
  std::get<core::Spring>(scene.forces.front()).damping = 2;
  return scene;
}

// The rod turns as it is struck, about no axis of its own.
Scene spinning_rod() {
  Scene scene = scene_of("rod_offcentre_hit.toml");
  scene.bodies[1].initial.angular_velocity = {0.4, 0, 0.3};
  return scene;
}

// The box turns as it lands.
Scene spinning_box() {
  Scene scene = scene_of("box_drop_edge.toml");
  scene.bodies[0].initial.angular_velocity = {0.5, 0.7, -0.4};
  return scene;
}

// One ball strikes two that lie beside each other, both at one instant: the order of the blows decides.
Scene break_shot() {
  Scene scene = scene_of("two_sphere_oblique.toml");
  scene.materials.front().between[0] = scene.materials.front().between[1] = "*";
  core::Body third = scene.bodies[1];
  third.name = "C";
  scene.bodies[0].initial.position = {-1, 0, 0};
  scene.bodies[1].initial.position = {0, 0, 0.5};
  third.initial.position = {0, 0, -0.5};
  scene.bodies.push_back(third);
  return scene;
}

class Runner {
 public:
  explicit Runner(const Subject& subject) : subject_(subject), simulator_(subject.make()) {}

  bool takes(const Scene& scene) const { return !simulator_->unsupported(scene, setup()).has_value(); }

  State end_of(const Scene& scene, std::int64_t count = steps) {
    terms_ = simulator_->load(scene, setup());
    for (std::int64_t i = 0; i < count; ++i) simulator_->step();
    State state(scene.bodies.size());
    simulator_->read(state);
    return state;
  }

  /// What two runs of one motion may part by that differ in nothing but rounding: of `auto` both keep 1e-10
  /// of scales up to 10, tenfold at worst; a fixed step rounds alike, some hundred operations a step.
  double rounding() const {
    return terms_.integrator == "auto" || terms_.integrator == "dop853" ? 2e-8 : 100 * steps * 2.3e-16 * 10;
  }
  /// Where the stages of a step depend on the axes: what they leave out, (Omega h)^p Omega T at 10 rad/s,
  /// tenfold.
  double truncation() const {
    return rounding() + (terms_.integrator == "auto" || terms_.integrator == "dop853"
                             ? 0
                             : 10 * std::expm1(std::pow(10 * dt, terms_.order) * 10 * duration));
  }

 private:
  core::Setup setup() const {
    core::Setup result = subject_.setup;
    result.dt = dt;
    return result;
  }
  const Subject& subject_;
  std::unique_ptr<core::Simulator> simulator_;
  core::Terms terms_;
};

Judge restating(const char* name, const char* asks, Scene scene, const Restated& change) {
  return {name, asks, false, [scene = std::move(scene), change](const Subject& subject) -> Findings {
            Runner run(subject);
            const Scene other = change(scene);
            if (!run.takes(scene) || !run.takes(other)) return std::nullopt;
            const double d = apart(run.end_of(other), change(run.end_of(scene), duration));
            return std::vector<Finding>{{"motion", d, run.truncation()}};
          }};
}

// `same` gives the motion once more, by another way; `exactly`: to the bit.
Judge again(const char* name, const char* asks, const Scene& scene,
            const std::function<State(Runner&, const Scene&)>& same, bool exactly = false) {
  return {name, asks, false, [=](const Subject& subject) -> Findings {
            Runner run(subject);
            if (!run.takes(scene)) return std::nullopt;
            const State once = run.end_of(scene);
            const double d = apart(same(run, scene), once);
            return std::vector<Finding>{{"motion", d, exactly ? 0 : run.rounding()}};
          }};
}

State with_far_body(Runner& run, const Scene& scene) {
  Scene larger = scene;
  core::Body far = scene.bodies.front();
  far.name = "far";
  far.initial = {};
  far.initial.position = {1e5, -2e5, 3e5};
  larger.bodies.push_back(far);
  State state = run.end_of(larger);
  state.pop_back();
  return state;
}

State reversed(Runner& run, const Scene& scene) {
  State state = run.end_of(in_reverse(scene));
  std::reverse(state.begin(), state.end());
  return state;
}

State in_moving_frame(Runner& run, Scene scene) {
  scene.frame = core::Frame{{0.7, -0.4, 1.1}, Vector3::Zero()};
  return run.end_of(scene);
}

State split(Runner& run, const Scene& scene) {
  return run.end_of(started_from(scene, run.end_of(scene, steps / 2)), steps / 2);
}

// Of the lowest corner of a box, upward [m/s].
double corner_speed(const core::Box& box, const core::BodyState& s) {
  Vector3 lowest = s.orientation * box.half_extents;
  for (int k = 0; k < 8; ++k) {
    const Vector3 sign(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1);
    const Vector3 arm = s.orientation * box.half_extents.cwiseProduct(sign);
    if (arm.y() < lowest.y()) lowest = arm;
  }
  return (s.velocity + s.angular_velocity.cross(lowest)).y();
}

// Newton's restitution holds of the contact point with friction as without: a box that falls h from rest onto
// an edge leaves the floor with e sqrt(2 g h) there.
Findings edge_leaves_as_newton_says(const Subject& subject) {
  Scene scene = scene_of("box_drop_edge.toml");
  scene.materials.front().friction = 0.4;
  scene.bodies.front().initial.velocity = {2, 0, 0};  // so that there is slip to rub against
  const auto simulator = subject.make();
  core::Setup setup = subject.setup;
  setup.dt = dt / 4;
  if (simulator->unsupported(scene, setup)) return std::nullopt;
  simulator->load(scene, setup);
  const auto& box = std::get<core::Box>(scene.bodies.front().shape);
  const double h = core::gap(scene, core::touching_pairs(scene).front(), core::initial_state(scene));
  const double want = scene.materials.front().restitution * std::sqrt(2 * 9.81 * h);
  double speed = 0;
  State state = core::initial_state(scene);
  for (int step = 0; step < 2400 && speed <= 0; ++step) {
    simulator->step();
    simulator->read(state);
    speed = corner_speed(box, state.front());
  }
  // Up to a step after the blow: (g + w^2 r) dt = (9.8 + 12^2 0.6) / 4096 = 0.02 m/s.
  return std::vector<Finding>{{"bounce speed", std::abs(speed - want), 0.03}};
}

}  // namespace

std::vector<Judge> relation_judges() {
  const Quaternion s = Quaternion(0.7, -0.2, 0.5, 0.3).normalized(),
                   c = Quaternion(0.4, 0.6, -0.3, 0.5).normalized();
  const Scene pair = damped_pair();
  return {
      restating("turned", "The whole scene turned", pair, turned(s)),
      restating("turned rod", "The same, of a turning rod that is struck", spinning_rod(), turned(s)),
      restating("turned box", "The same, of a turning box that lands", spinning_box(), turned(s)),
      restating("boost", "The whole scene in motion", pair, boosted({0.7, -0.4, 1.1})),
      restating("mirror", "The scene and its bodies mirrored", pair, mirrored()),
      restating("heavier", "All masses and stiffnesses alike", pair, heavier(3.7)),
      restating("body axes", "Other axes in the bodies", pair, other_body_axes(c)),
      again("moving frame", "A frame that moves and does not turn", pair, in_moving_frame),
      again("far body", "One more body, 370 km away, on which nothing acts", pair, with_far_body),
      again("body order", "The bodies in the opposite order", pair, reversed),
      again("split run", "Stopped half-way and started again from what was read", pair, split),
      again(
          "same again", "Three balls at one instant, twice: the same bits", break_shot(),
          [](Runner& run, const Scene& scene) { return run.end_of(scene); }, true),
      {"rough edge", "A blow's normal and tangent know of each other", false, edge_leaves_as_newton_says},
  };
}

}  // namespace cylon::mutants
