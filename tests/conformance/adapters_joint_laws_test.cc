// Sliders, screws, universal joints and what acts along them, on every engine that says that it knows them, against the
// certified solution of the scene, and limits and dry friction against closed forms.
#include "harness/core/joint_coordinates.h"
#include "harness/core/later_parts.h"
#include "harness/scenario/input.h"
#include "harness/scenario/scenario.h"
#include "reference/certified/truth.h"
#include "tests/conformance/adapters_fixture.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <string_view>

namespace cylon::conformance {
namespace {

using core::JointType;

const Vector3 axis = Vector3(1, -2, 0.5).normalized();
const Vector3 axis_2 = Vector3(0.3, 1, -0.2).cross(axis).normalized();
const Vector3 point(0.2, -0.1, 0.4);
const Vector3 gravity(0.4, -9.81, 0.2);

core::Joint joint_of(JointType type, int body = 0, int to = core::world, const Vector3& at = point) {
  core::Joint joint{.type = type, .body = body, .to = to, .point = at, .axis = axis};
  if (core::kind_of(type).has_second_axis()) joint.axis_2 = axis_2;
  if (core::kind_of(type).screws) joint.pitch = 0.15;
  return joint;
}

// Bodies at rest in general poses, no two alike.
core::Scene at_rest(int count) {
  core::Scene scene = three_bodies(29);
  scene.bodies.resize(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    core::BodyState& start = scene.bodies[static_cast<std::size_t>(i)].initial;
    start.position = point + Vector3(0.3, 0.2, -0.4) + i * Vector3(0.5, -0.3, 0.2);
    start.velocity = start.angular_velocity = Vector3::Zero();
  }
  scene.forces = {core::UniformGravity{gravity}};
  return scene;
}

struct Machine {
  const char* name;
  std::function<core::Scene()> scene;
};

core::Scene on_a_spring(JointType type) {
  core::Scene scene = at_rest(1);
  core::Joint joint = joint_of(type);
  const core::JointCoordinate acts{
      .start = 0.2, .force = 1.1, .stiffness = 30, .damping = 1.5, .target = -0.3};
  if (core::kind_of(type).displacements() > 0) joint.displacements.push_back({acts});
  if (core::kind_of(type).displacements() > 1)
    joint.displacements.push_back({{.which = core::Ordinal::second, .stiffness = 20}});
  if (core::kind_of(type).angles() > 0) joint.angles.push_back({acts});
  if (core::kind_of(type).angles() > 1)
    joint.angles.push_back({{.which = core::Ordinal::second, .damping = 0.7}});
  scene.joints = {joint};
  return scene;
}

const Machine machines[] = {
    {"slider", [] { return on_a_spring(JointType::slider); }},
    {"hinge", [] { return on_a_spring(JointType::hinge); }},
    {"cylindrical", [] { return on_a_spring(JointType::cylindrical); }},
    {"planar", [] { return on_a_spring(JointType::planar); }},
    {"universal", [] { return on_a_spring(JointType::universal); }},
    {"screw", [] { return on_a_spring(JointType::screw); }},
};

class JointLaws : public EveryEngine {
 protected:
  // What the engine says that it knows of the scene, in the words of its adapter.
  bool knows(const core::Scene& scene) const {
    const core::Engine engine = process::describe(subject().choice(), limits);
    return !core::not_known(engine, scene);
  }
};
INSTANTIATE_TEST_SUITE_P(Adapters, JointLaws, testing::ValuesIn(subjects), test_name);

constexpr double end = 0.6;

TEST_P(JointLaws, MoveAsCertified) {
  int run = 0;
  for (const Machine& machine : machines) {
    const core::Scene scene = machine.scene();
    if (!knows(scene)) continue;
    ++run;
    const core::State exact = certified::solution(scene, end, 1e11).truth.state(end);
    ASSERT_GT(difference(exact, core::initial_state(scene)), 0.1) << machine.name << ": hardly a motion";
    const auto error = [&](std::int64_t steps) {
      return difference(last(subject().choice(), scene, end / static_cast<double>(steps), steps), exact);
    };
    const std::string what = fmt::format("{}, {}", machine.name, subject().id);
    const double coarse = error(1200), fine = error(2400);
    // First order: dt T |x'''|/2 with rates of up to 8 rad/s and velocities of up to 4 m/s.
    expect_within(what, coarse, subject().order > 1 ? 1e-7 + 1e5 * subject().unit() : 0.03);
    expect_within(what + ", half the step", fine, 0.6 * coarse + 1e5 * subject().unit());
  }
  const core::Engine engine = process::describe(subject().choice(), limits);
  if (std::ranges::find(engine.knows, "slider_joints") != engine.knows.end()) {
    EXPECT_GE(run, 4);
  }
}

// A machine is not what it is without a part of it: the test above sees each.
TEST(JointLawsAlone, EveryPartMatters) {
  const core::Scene whole = on_a_spring(JointType::slider);
  const core::State exact = certified::solution(whole, end, 1e11).truth.state(end);
  double core::JointCoordinate::*const parts[] = {
      &core::JointCoordinate::start, &core::JointCoordinate::force, &core::JointCoordinate::stiffness,
      &core::JointCoordinate::damping, &core::JointCoordinate::target};
  for (const auto part : parts) {
    core::Scene other = whole;
    other.joints[0].displacements[0].*part = 0;
    EXPECT_GT(difference(certified::solution(other, end, 1e11).truth.state(end), exact), 0.02);
  }
}

// ---- Limits and dry friction ----------------------------------------------------------------------

double along(const core::Scene& scene, const core::State& state) {
  return core::joint_displacement(core::held_joint(scene, scene.joints[0]), core::Ordinal::first, state);
}

// A body falls along a tilted rail onto a stop and rises again: with a = g . n and the way d to the stop it is there after
// t = sqrt(2 d/a), and at t + s  d - e v s + a s^2/2.
TEST_P(JointLaws, StopsGiveBackTheirPart) {
  for (const double restitution : {0.0, 0.6}) {
    core::Scene scene = at_rest(1);
    core::Joint joint = joint_of(JointType::slider);
    constexpr double start = -0.1, way = 0.35;
    joint.displacements.push_back(
        {{.start = start, .lower = start - 5, .upper = start + way, .restitution = restitution}});
    scene.joints = {joint};
    if (!knows(scene)) GTEST_SKIP() << "knows no limits of joints";
    if (restitution > 0 && !subject().bounces) continue;
    const double a = gravity.dot(axis);
    ASSERT_GT(a, 0);
    const double hit = std::sqrt(2 * way / a), s = 0.2, speed = a * hit;
    const std::int64_t steps = 4000;
    const double dt = (hit + s) / static_cast<double>(steps);
    const double expected = restitution > 0 ? way - restitution * speed * s + a * s * s / 2 : way;
    const double found = along(scene, last(subject().choice(), scene, dt, steps));
    // A step late at the stop: v dt, and a soft stop gives way for a while.
    expect_within(fmt::format("stop, e = {}, {}", restitution, subject().id), std::abs(found - expected),
                  subject().order > 1 && !subject().single ? 1e-6 : 0.02);
  }
}

// On a level rail a body that moves is braked by F/m until it stands, and then stands: x = v^2/(2 F/m).
TEST_P(JointLaws, DryFrictionBrakesAndHolds) {
  core::Scene scene = at_rest(1);
  scene.forces.clear();
  core::Joint joint = joint_of(JointType::slider);
  constexpr double speed = 1.3, friction = 2.1;
  joint.displacements.push_back({{.friction = friction}});
  scene.joints = {joint};
  if (!knows(scene)) GTEST_SKIP() << "knows no dry friction in joints";
  scene.bodies[0].initial.velocity = speed * axis;
  const double brake = friction / scene.bodies[0].mass, way = speed * speed / (2 * brake);
  const std::int64_t steps = 4000;
  const core::State state =
      last(subject().choice(), scene, 2 * speed / brake / static_cast<double>(steps), steps);
  expect_within(fmt::format("dry friction, {}", subject().id), std::abs(along(scene, state) - way),
                subject().order > 1 && !subject().single ? 1e-6 : 0.01);
  expect_within(fmt::format("stands, {}", subject().id), state[0].velocity.norm(),
                subject().order > 1 && !subject().single ? 1e-9 : 1e-3);
}

// ---- Mixes ------------------------------------------------------------------------------------------

scenario::Scenario mix(const std::string& name) {
  return scenario::load(std::filesystem::path(source_dir) / ("tests/data/mixes/" + name + ".toml"));
}

core::State end_of(const scenario::Scenario& scenario, const std::string& engine, std::int64_t per_second) {
  return last(process::parse_engine(engine, process::default_engines(binary_dir)), scenario.scene,
              1 / static_cast<double>(per_second),
              std::llround(scenario.duration * static_cast<double>(per_second)));
}

double apart(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) worst = std::max(worst, (a[i].position - b[i].position).norm());
  return worst;
}

// Stops, dry friction and springs of joints beside contacts that bounce and rub.  ODE sees an event a step late, which moves
// a body by v dt: of some ten events at 4 m/s.
TEST(JointLawsAlone, BesideContactsAgreeWithOde) {
  for (const char* name : {"piston_on_floor", "flap_of_puck"}) {
    const scenario::Scenario scenario = mix(name);
    const core::State here = end_of(scenario, "in-house", 1000);
    constexpr std::int64_t per_second = 20'000;
    EXPECT_LT(apart(end_of(scenario, "ode", per_second), here), 10 * 4.0 / per_second) << name;
    for (double core::JointCoordinate::*const part :
         {&core::JointCoordinate::friction, &core::JointCoordinate::restitution}) {
      scenario::Scenario other = scenario;  // a motion that tells each part from its absence
      for (core::Joint& joint : other.scene.joints) {
        for (auto& c : joint.displacements) c.*part = 0;
        for (auto& c : joint.angles) c.*part = 0;
      }
      EXPECT_GT(apart(end_of(other, "in-house", 1000), here), 2 * 10 * 4.0 / per_second) << name;
    }
  }
}

// A screw, a universal joint, damping, a target that moves, drag and thrust: error control against 12 000 steps of order 4.
TEST(JointLawsAlone, BesideForcesAgreeWithSmallSteps) {
  const scenario::Scenario scenario = mix("arm_on_screw");
  EXPECT_LT(apart(end_of(scenario, "in-house", 1000), end_of(scenario, "in-house/integrator=rk4", 8000)),
            1e-10);
}

}  // namespace
}  // namespace cylon::conformance
