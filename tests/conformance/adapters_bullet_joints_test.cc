// Bullet's joints beyond what other engines share: between two bodies that move, stops and friction along each coordinate,
// and what a stop of Bullet's own settings does; against certified solutions and closed forms.
#include "reference/certified/truth.h"
#include "tests/conformance/adapters_joint_cases.h"

#include <cmath>
#include <string>
#include <utility>

namespace cylon::conformance {
namespace {

using core::JointType;
using core::Ordinal;

class BulletJoints : public EveryEngine {};
std::vector<Subject> of_bullet() {
  std::vector<Subject> all;
  for (const Subject& subject : subjects)
    if (std::string_view(subject.id).starts_with("bullet")) all.push_back(subject);
  return all;
}
INSTANTIATE_TEST_SUITE_P(Adapters, BulletJoints, testing::ValuesIn(of_bullet()), test_name);

// ---- Two bodies that move -----------------------------------------------------------------------------

// Two bodies that turn and move as one and slide or turn against each other along the joint, with a spring along it.
core::Scene pair(JointType type) {
  core::Scene scene = at_rest(2);
  const Vector3 spin(0.9, -0.6, 1.1), drift(0.3, 0.2, -0.1);
  for (core::Body& one : scene.bodies) {
    one.initial.angular_velocity = spin;
    one.initial.velocity = drift + spin.cross(one.initial.position - point);
  }
  core::Joint joint = joint_of(type, 0, 1);
  const core::JointKind& kind = core::kind_of(type);
  core::BodyState& first = scene.bodies[0].initial;
  const Vector3 arm = first.position - point;
  if (kind.displacements() > 0) {
    joint.displacements = {{{.stiffness = 15, .damping = 0.2, .target = 0.1}}};
    first.velocity += 0.8 * (kind.has_second_axis() ? *joint.axis_2 : axis);
  }
  if (kind.angles() > 0) {
    joint.angles = {{{.stiffness = 2, .target = 0.2}}};
    first.angular_velocity += 1.3 * axis, first.velocity += 1.3 * axis.cross(arm);
  }
  if (kind.angles() > 1) first.angular_velocity -= 0.7 * axis_2, first.velocity -= 0.7 * axis_2.cross(arm);
  scene.joints = {joint};
  return scene;
}

constexpr double duration = 0.4;

// First order in the step: the error falls by half, to what sweeps and roundings leave.
TEST_P(BulletJoints, BetweenMovingBodiesGoToTheCertifiedMotion) {
  const bool reduced = subject().reduced;
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  for (const JointType type : {JointType::slider, JointType::cylindrical, JointType::universal,
                               JointType::planar, JointType::hinge}) {
    const core::Scene scene = pair(type);
    if (refusal(engine, subject().choice(), scene)) continue;
    ++run;
    const core::State exact = certified::solution(scene, duration, 1e11).truth.state(duration);
    ASSERT_GT(difference(exact, core::initial_state(scene)), 0.1);
    process::EngineChoice choice = subject().choice();
    if (!reduced)
      choice = process::parse_engine(std::string(subject().id) + "/iterations=200",
                                     process::default_engines(binary_dir));
    const double coarse = difference(last(choice, scene, duration / 800, 800), exact),
                 fine = difference(last(choice, scene, duration / 1600, 1600), exact);
    const std::string what = fmt::format("two bodies on a {}, {}", core::kind_of(type).name, subject().id);
    expect_within(what, coarse, 2e-2);
    expect_within(what + ", half the step", fine, 0.6 * coarse + 2e4 * subject().unit());
  }
  EXPECT_EQ(run, reduced ? 3 : 4);
}

// ---- Stops along each coordinate ----------------------------------------------------------------------

// A freedom of a joint: one of its displacements or angles.
struct Freedom {
  JointType type;
  bool angle;
  Ordinal which = Ordinal::first;
  bool to_a_body = false;
};
const Freedom freedoms[] = {
    {JointType::hinge, true},
    {JointType::hinge, true, Ordinal::first, true},
    {JointType::slider, false},
    {JointType::slider, false, Ordinal::first, true},
    {JointType::cylindrical, false},
    {JointType::cylindrical, true},
    {JointType::planar, false},
    {JointType::planar, false, Ordinal::second},
    {JointType::planar, true},
    {JointType::universal, true},
    {JointType::universal, true, Ordinal::second},
    {JointType::universal, true, Ordinal::first, true},
};

std::string name_of(const Freedom& f) {
  return fmt::format("{} {} of a {} to {}", f.which == Ordinal::first ? "first" : "second",
                     f.angle ? "angle" : "displacement", core::kind_of(f.type).name,
                     f.to_a_body ? "a body" : "the world");
}

Vector3 direction(const Freedom& f) {
  const bool second = f.which == Ordinal::second;
  if (f.type == JointType::universal) return second ? axis_2 : axis;
  if (f.type == JointType::planar && !f.angle) return second ? Vector3(axis.cross(axis_2)) : axis_2;
  return axis;
}

// Round bodies whose centres of mass lie at the joint's point: a rate along one freedom stays along it.  The joint's body
// moves at v.
core::Scene at_rate(const Freedom& f, double v) {
  core::Scene scene = at_rest(f.to_a_body ? 2 : 1);
  scene.forces.clear();
  for (core::Body& one : scene.bodies)
    one.initial.position = point, one.inertia = 0.05 * core::Matrix3::Identity();
  (f.angle ? scene.bodies[0].initial.angular_velocity : scene.bodies[0].initial.velocity) = v * direction(f);
  scene.joints = {joint_of(f.type, 0, f.to_a_body ? 1 : core::world)};
  return scene;
}

void act(core::Scene& scene, const Freedom& f, core::JointCoordinate c) {
  c.which = f.which;
  if (f.angle)
    scene.joints[0].angles = {{c}};
  else
    scene.joints[0].displacements = {{c}};
}

double along(const core::Scene& scene, const Freedom& f, const core::State& state, bool rate) {
  const core::HeldJoint joint = core::held_joint(scene, scene.joints[0]);
  if (f.angle)
    return rate ? core::joint_angle_rate(joint, f.which, state) : core::joint_angle(joint, f.which, state);
  return rate ? core::joint_displacement_rate(joint, f.which, state)
              : core::joint_displacement(joint, f.which, state);
}

// The sum of the inverse masses or moments against which a freedom moves.
double inverse_inertia(const core::Scene& scene, const Freedom& f) {
  double sum = 0;
  for (const core::Body& one : scene.bodies) sum += f.angle ? 1 / one.inertia(0, 0) : 1 / one.mass;
  return sum;
}

constexpr double dt = 1. / 1024;

// Nothing presses: what comes to a stop at v leaves it at e v, and is there within a step.  Whichever part of a step the
// impact falls on.
TEST_P(BulletJoints, AStopGivesBackItsPartAndNoMore) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  for (const Freedom& f : freedoms)
    for (const double side : {1., -1.})
      for (const double e : {0., 0.1, 0.6, 1.})
        for (const double way : {0.1, 0.1004, 0.1007}) {
          constexpr double v = 1.5;
          core::Scene scene = at_rate(f, side * v);
          core::JointCoordinate c{.start = 0.3, .restitution = e};
          c.lower = 0.3 - (side < 0 ? way : 0.9), c.upper = 0.3 + (side > 0 ? way : 0.9);
          act(scene, f, c);
          if (refusal(engine, subject().choice(), scene)) continue;
          ++run;
          const std::int64_t steps = 128;
          const core::State end = last(subject().choice(), scene, dt, steps);
          const double t = steps * dt, exact = way - e * v * (t - way / v);
          const std::string what =
              fmt::format("{}, {}, e = {}, {}", name_of(f), side > 0 ? "upper" : "lower", e, subject().id);
          expect_within(what, std::abs(side * along(scene, f, end, false) - exact),
                        (1 + e) * v * dt + 1000 * subject().unit());
          expect_within(what + ", rate", std::abs(side * along(scene, f, end, true) + e * v),
                        1e4 * subject().unit());
        }
  EXPECT_EQ(run, subject().reduced ? 4 * 2 * 3 : 12 * 4 * 2 * 3);
}

// A coordinate that moves by itself at v is braked by a = Q w until it stands, and then stands: x = v^2/(2 a).
TEST_P(BulletJoints, DryFrictionBrakesAndHoldsEachCoordinate) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  for (const Freedom& f : freedoms) {
    constexpr double v = 1.3, a = 5.2;
    core::Scene scene = at_rate(f, v);
    act(scene, f, {.friction = a / inverse_inertia(scene, f)});
    if (refusal(engine, subject().choice(), scene)) continue;
    ++run;
    const core::State end = last(subject().choice(), scene, dt, 512);
    const std::string what = fmt::format("{}, friction, {}", name_of(f), subject().id);
    // Euler's v dt/2; the last step is exact or shorter.
    expect_within(what, std::abs(along(scene, f, end, false) - v * v / (2 * a)),
                  v * dt / 2 + 4000 * subject().unit());
    expect_within(what + ", stands", std::abs(along(scene, f, end, true)), 1e4 * subject().unit());
  }
  EXPECT_EQ(run, subject().reduced ? 4 : 12);
}

// ---- What joints exert --------------------------------------------------------------------------------

// To a thousandth, and four roundings of a place of about 1 m, of which a step takes back a fifth by a velocity.
// A body on a level slider, whichever end is named first: the joint bears its weight.  And one on a slider of a beam that is
// welded to the world, whose weld bears both.
TEST_P(BulletJoints, TellWhatTheyBear) {
  if (subject().reduced) GTEST_SKIP() << "Bullet's multibodies tell no forces of joints";
  for (const JointType type :
       {JointType::slider, JointType::cylindrical, JointType::planar, JointType::universal})
    for (const bool turned : {false, true}) {
      core::Scene scene = at_rest(3);
      scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
      scene.bodies[2].locked = true;
      const bool planar = type == JointType::planar, hangs = type == JointType::universal;
      core::Joint rail{.type = type,
                       .body = turned ? 1 : 0,
                       .to = turned ? 0 : 1,
                       .point = point,
                       .axis = Vector3::UnitX()};
      if (planar) rail.axis = Vector3::UnitY(), rail.to = turned ? 0 : 2, rail.body = turned ? 2 : 0;
      if (core::kind_of(type).has_second_axis()) rail.axis_2 = Vector3::UnitZ();
      // Below the point or on the axis: nothing turns.
      scene.bodies[0].initial.position = point + (hangs    ? Vector3(0, -0.4, 0)
                                                  : planar ? Vector3(0.3, 0.2, 0.1)
                                                           : Vector3(0.3, 0, 0));
      scene.joints = {rail, core::Joint{.type = JointType::fixed, .body = 1, .to = 2, .point = point}};
      process::RunRequest request;
      const process::EngineChoice choice = process::parse_engine(
          std::string(subject().id) + "/iterations=200", process::default_engines(binary_dir));
      request.scene = &scene, request.setup.dt = dt, request.steps = 64, request.every = 1,
      request.contacts = true;
      const process::RunOutcome outcome = process::run(choice, request, limits);
      ASSERT_TRUE(outcome.recording) << outcome.reason;
      ASSERT_TRUE(outcome.recording->reactions);
      for (const core::Reaction& r : *outcome.recording->reactions) {
        const double sign = r.joint == 0 && turned ? -1 : 1;
        const double carried = scene.bodies[0].mass * (r.joint == 0 ? 1
                                                       : planar     ? 0
                                                                    : 1) +
                               (r.joint == 0 ? 0 : scene.bodies[1].mass);
        expect_within(fmt::format("{} {}, joint {}, {}", turned ? "turned" : "straight",
                                  core::kind_of(type).name, r.joint, subject().id),
                      (sign * r.impulse - Vector3(0, 9.81 * carried * dt, 0)).norm(),
                      1e-3 * 9.81 * carried * dt + 4 * carried * 0.2 * subject().unit() / dt);
      }
    }
}

// The stop of a slider between two moving bodies is a constraint beside the joint, and told with it: a body stands on it, on a
// beam that is welded to the world.
TEST_P(BulletJoints, TellWhatAStopBetweenTwoMoversBears) {
  if (subject().reduced) GTEST_SKIP() << "Bullet's multibodies tell no forces of joints";
  for (const bool turned : {false, true}) {
    core::Scene scene = at_rest(3);
    scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
    scene.bodies[2].locked = true;
    for (core::Body& one : scene.bodies) one.initial.position = point;
    scene.bodies[0].initial.position.y() += 0.3;
    core::Joint rail{.type = JointType::slider,
                     .body = turned ? 1 : 0,
                     .to = turned ? 0 : 1,
                     .point = point,
                     .axis = Vector3::UnitY()};
    core::JointDisplacement stop{};
    (turned ? stop.upper : stop.lower) = 0;
    rail.displacements = {stop};
    scene.joints = {rail, core::Joint{.type = JointType::fixed, .body = 1, .to = 2, .point = point}};
    process::RunRequest request;
    request.scene = &scene, request.setup.dt = dt, request.steps = 64, request.every = 1,
    request.contacts = true;
    const process::RunOutcome outcome = process::run(subject().choice(), request, limits);
    ASSERT_TRUE(outcome.recording) << outcome.reason;
    ASSERT_TRUE(outcome.recording->reactions);
    const double weight = 9.81 * scene.bodies[0].mass * dt;
    for (const core::Reaction& r : *outcome.recording->reactions)
      if (r.joint == 0)
        expect_within(fmt::format("{}, {}", turned ? "turned" : "straight", subject().id),
                      ((turned ? -1 : 1) * r.impulse - Vector3(0, weight, 0)).norm(),
                      1e-3 * weight + 4 * scene.bodies[0].mass * subject().unit() / dt);
  }
}

// ---- What Bullet's own settings of a stop do ----------------------------------------------------------

double rate_after(const std::string& engine, const Freedom& f, const core::Scene& scene) {
  return along(scene, f,
               last(process::parse_engine(engine, process::default_engines(binary_dir)), scene, dt, 128),
               true);
}

// A body that hangs from the world with an arm across the axis, and turns at v to a stop of e = 0.8.
TEST(BulletStopsAlone, TakeTheMomentumOfAnArmWithTheFrameOffset) {
  const Freedom hinge{JointType::hinge, true};
  constexpr double v = 1.5, e = 0.8;
  core::Scene scene = at_rate(hinge, v);
  act(scene, hinge, {.lower = -0.5, .upper = 0.1, .restitution = e});
  scene.bodies[0].initial.position = point + 0.4 * axis_2;
  scene.bodies[0].initial.velocity = 0.4 * v * axis.cross(axis_2);
  EXPECT_NEAR(rate_after("bullet", hinge, scene), -e * v, 1e-3);
  EXPECT_GT(rate_after("bullet/path=as-shipped,iterations=200", hinge, scene), -0.6 * e * v);
}

TEST(BulletStopsAlone, DoNotBounceWhereTheyBrakeBefore) {
  const Freedom slider{JointType::slider, false};
  core::Scene scene = at_rate(slider, 1.5);
  act(scene, slider, {.lower = -0.5, .upper = 0.1, .restitution = 1});
  EXPECT_NEAR(rate_after("bullet", slider, scene), -1.5, 1e-9);
  EXPECT_NEAR(rate_after("bullet/path=as-shipped", slider, scene), 0, 0.01);
}

// Nothing presses: where a stop acts once it is passed, the correction of that stays.
TEST(BulletStopsAlone, GiveBackTheirCorrectionWhereTheyActTooLate) {
  const Freedom slider{JointType::slider, false, Ordinal::first, true}, hinge{JointType::hinge, true};
  for (const auto& [freedom, engine] :
       {std::pair{slider, "bullet/path=as-shipped"}, std::pair{hinge, "bullet/stops-ahead=off,stop-erp=0.2"},
        std::pair{hinge, "bullet-multibody/erp=0.2"}}) {
    core::Scene scene = at_rate(freedom, 1.5);
    act(scene, freedom, {.lower = -0.5, .upper = 0.1});
    EXPECT_LT(rate_after(engine, freedom, scene), -0.1) << engine;
  }
}

}  // namespace
}  // namespace cylon::conformance
