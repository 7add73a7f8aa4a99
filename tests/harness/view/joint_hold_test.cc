// Poses and velocities that joints allow, for scenes that begin anew.
#include "harness/process/joint_hold.h"

#include "harness/core/observable.h"
#include "harness/process/resume.h"
#include "tests/harness/view/fixture.h"

#include <cmath>

namespace cylon::view {
namespace {

using core::HeldJoint;
using core::JointType;
using core::Vector3;

Vector3 velocity_at(const core::BodyState& s, const Vector3& point) {
  return s.velocity + s.angular_velocity.cross(point - s.position);
}

/// The largest velocity that a joint forbids.
double broken(const std::vector<HeldJoint>& joints, const core::State& state) {
  double worst = 0;
  for (const HeldJoint& j : joints) {
    const core::BodyState& a = state[static_cast<std::size_t>(j.body)];
    const core::BodyState none, &b = j.to == core::world ? none : state[static_cast<std::size_t>(j.to)];
    const Vector3 at_a = a.position + a.orientation * j.anchor,
                  at_b = b.position + b.orientation * j.to_anchor;
    const Vector3 apart = velocity_at(a, at_a) - velocity_at(b, at_b),
                  turning = a.angular_velocity - b.angular_velocity;
    if (j.type == JointType::distance) {
      worst = std::max(worst, std::abs(apart.dot((at_a - at_b).normalized())));
      continue;
    }
    worst = std::max(worst, apart.norm());
    if (j.type == JointType::fixed) worst = std::max(worst, turning.norm());
    if (j.type == JointType::hinge) worst = std::max(worst, turning.cross(a.orientation * j.axis).norm());
  }
  return worst;
}

/// hinged_pair() with other joints between the same bodies.
core::Scene joined_by(JointType type) {
  core::Scene scene = hinged_pair();
  for (core::Body& body : scene.bodies)
    body.initial.velocity = body.initial.angular_velocity = Vector3::Zero();
  for (core::Joint& joint : scene.joints) joint.type = type;
  if (type == JointType::distance) {
    scene.joints[0].length = (scene.bodies[0].initial.position - scene.joints[0].point).norm();
    scene.joints[1].length = (scene.bodies[0].initial.position - scene.bodies[1].initial.position).norm();
  }
  return scene;
}

TEST(JointHold, KickOfFreeBodyIsUnchanged) {
  core::Scene scene = hinged_pair();
  scene.joints.clear();
  core::State state = core::initial_state(scene);
  const Vector3 impulse(0.3, -1.1, 0.7), before = momentum(scene, state);
  process::kick(scene, {}, state, 1, impulse);
  EXPECT_LE((momentum(scene, state) - before - impulse).norm(), 4e-16);
  EXPECT_EQ(state[1].angular_velocity, scene.bodies[1].initial.angular_velocity);
  EXPECT_EQ(state[0].velocity, scene.bodies[0].initial.velocity);
}

// L = I w jumps by the angular impulse, whatever the inertia, and the momentum by the impulse; nothing else changes.
TEST(JointHold, SpinKickOfFreeBodyAddsItsAngularMomentum) {
  core::Scene scene = hinged_pair();
  scene.joints.clear();
  scene.bodies[1].inertia << 0.5, 0.1, -0.05, 0.1, 0.7, 0.02, -0.05, 0.02, 1.0;
  scene.bodies[1].initial.angular_velocity = {1.2, -0.7, 0.9};
  scene.bodies[1].initial.orientation = Eigen::AngleAxisd(0.8, Vector3(0.6, -0.48, 0.64));
  core::State state = core::initial_state(scene);
  const auto spin = [&] {
    return Vector3(core::world_inertia(scene.bodies[1], state[1].orientation) * state[1].angular_velocity);
  };
  const Vector3 impulse(0.3, -1.1, 0.7), angular(-0.4, 0.9, 0.2), before = momentum(scene, state),
                                                                  was = spin();
  process::kick(scene, {}, state, 1, impulse, angular);
  EXPECT_LE((spin() - was - angular).norm(), 2e-15);
  EXPECT_LE((momentum(scene, state) - before - impulse).norm(), 4e-16);
  EXPECT_EQ(state[1].orientation.coeffs(), scene.bodies[1].initial.orientation.coeffs());
  EXPECT_EQ(state[0].angular_velocity, scene.bodies[0].initial.angular_velocity);
  // About an axis without inertia nothing turns.
  scene.bodies[1].inertia = Vector3(0.4, 0, 0.4).asDiagonal();
  state = core::initial_state(scene);
  process::kick(scene, {}, state, 1, {0, 0, 0}, state[1].orientation * Vector3(0, 3, 0));
  EXPECT_LE((state[1].angular_velocity - scene.bodies[1].initial.angular_velocity).norm(), 1e-14);
}

// The velocities fit to rounding, and the energy is least among those that do: what the joints add does no
// work on any motion that they allow (Gauss).  For the two bodies joined to each other alone momentum is the
// kick.
TEST(JointHold, KickSatisfiesJoints) {
  const Vector3 impulse(0.3, -1.1, 0.7);
  for (const JointType type : {JointType::ball, JointType::hinge, JointType::distance, JointType::fixed})
    for (const bool free : {false, true}) {
      core::Scene scene = joined_by(type);
      if (free) scene.joints.erase(scene.joints.begin());
      const auto joints = core::held_joints(scene);
      core::State state = core::initial_state(scene);
      process::kick(scene, joints, state, 1, impulse);
      EXPECT_LE(broken(joints, state), 1e-14) << static_cast<int>(type);
      const Vector3 taken = free ? Vector3(impulse - momentum(scene, state)) : Vector3(Vector3::Zero());
      EXPECT_LE(taken.norm(), 1e-14) << static_cast<int>(type);
      // From rest 2 T = impulse . v: the joints' impulses do no work.
      double twice = 0;
      for (std::size_t i = 0; i < 2; ++i)
        twice += scene.bodies[i].mass * state[i].velocity.squaredNorm() +
                 state[i].angular_velocity.dot(core::world_inertia(scene.bodies[i], state[i].orientation) *
                                               state[i].angular_velocity);
      EXPECT_NEAR(twice, impulse.dot(state[1].velocity), 1e-14) << static_cast<int>(type);
      EXPECT_EQ(state[1].velocity.isZero(1e-3), type == JointType::fixed && !free) << static_cast<int>(type);
    }
}

// Two joints that say the same make the equations singular.
TEST(JointHold, DuplicateJointChangesNothing) {
  core::Scene once = hinged_pair(), twice = once;
  twice.joints.push_back(twice.joints[1]);
  core::State a = core::initial_state(once), b = a;
  process::kick(once, core::held_joints(once), a, 1, {0.3, -1.1, 0.7});
  process::kick(twice, core::held_joints(twice), b, 1, {0.3, -1.1, 0.7});
  for (std::size_t i = 0; i < 2; ++i) EXPECT_LE((a[i].velocity - b[i].velocity).norm(), 1e-13);
}

TEST(JointHold, GapsCloseAndHingesAlign) {
  for (const JointType type : {JointType::ball, JointType::hinge, JointType::distance, JointType::fixed}) {
    const core::Scene scene = joined_by(type);
    const auto joints = core::held_joints(scene);
    core::State state = core::initial_state(scene);
    state[0].position += Vector3(0.01, -0.02, 0.005);
    state[1].orientation =
        core::Quaternion(Eigen::AngleAxisd(0.03, Vector3(1, 1, -2).normalized())) * state[1].orientation;
    process::fit(scene, joints, state);
    core::Values gaps;
    core::evaluate({.quantity = core::Quantity::joint_gap}, scene, state, gaps);
    for (const Eigen::Vector4d& gap : gaps) EXPECT_LE(std::abs(gap.x()), 1e-14) << static_cast<int>(type);
    if (type != JointType::hinge) continue;
    EXPECT_LE((state[0].orientation * joints[0].axis).cross(joints[0].to_axis).norm(), 1e-14);
    EXPECT_LE((state[1].orientation * joints[1].axis).cross(state[0].orientation * joints[1].to_axis).norm(),
              1e-14);
  }
}

// A scene that is begun anew a hundred times has the joints that it had.
TEST(Resume, JointsDoNotDrift) {
  const core::Scene given = hinged_pair();
  const auto joints = core::held_joints(given);
  process::LiveRun live(engine("ode"), limits);
  core::State state = core::initial_state(given);
  for (int i = 0; i < 100; ++i) {
    const core::Scene scene = process::resumed(given, joints, state, 0.01 * i);
    EXPECT_EQ(scene.joints[0].point, given.joints[0].point);
    EXPECT_LE(broken(joints, core::initial_state(scene)), 1e-13);
    live.load(scene, setup(0.01));
    state = live.advance(1).state;
  }
  process::fit(given, joints, state);
  const Vector3 elbow = state[1].position + state[1].orientation * joints[1].anchor;
  EXPECT_NEAR((elbow - given.joints[0].point).norm(), (given.joints[1].point - given.joints[0].point).norm(),
              1e-14);
}

TEST(Resume, KeepsCurrentMasses) {
  core::Scene rocket = process::two_bodies();
  rocket.forces = {core::Thrust{.body = 0, .mass_rate = -0.125, .exhaust_velocity = Vector3(0, -3, 0)}};
  const core::Scene later = process::resumed(rocket, {}, core::initial_state(rocket), 2);
  EXPECT_EQ(later.bodies[0].mass, rocket.bodies[0].mass - 0.25);
  EXPECT_EQ(later.bodies[1].mass, rocket.bodies[1].mass);
}

TEST(Resume, TimeDependentForcesCannotResume) {
  core::Scene scene = process::two_bodies();
  const std::pair<core::Force, bool> rows[] = {{core::Drive{0, {1, 0, 0}, 2}, true},
                                               {core::Drive{0, {1, 0, 0}, 0}, false},
                                               {core::Water{0, 0.1, 2, 1000, 1, "volume"}, true},
                                               {core::Water{0, 0.1, 0, 1000, 1, "volume"}, false},
                                               {core::PluginForce{.bodies = {0}}, true},
                                               {core::UniformGravity{}, false}};
  for (const auto& [force, refused] : rows) {
    scene.forces = {force};
    EXPECT_EQ(process::not_resumable(scene).has_value(), refused) << force.index();
  }
}

}  // namespace
}  // namespace cylon::view
