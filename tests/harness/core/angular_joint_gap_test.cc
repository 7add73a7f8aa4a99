// The angle by which a joint's bodies are turned as it forbids, against bodies that are turned by known
// angles.
#include "harness/core/observable.h"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace cylon::core;

const Vector3 axis = Vector3(1, -2, 0.5).normalized();

Quaternion turn(double angle, const Vector3& about) {
  return Quaternion(Eigen::AngleAxisd(angle, about.normalized()));
}

// Two bodies in general positions, joined to each other, or the first one to the world.
Scene scene_of(JointType type, int to) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].initial.orientation = turn(0.7, {1, 2, -1});
  scene.bodies[1].initial.orientation = turn(-1.9, {0.3, 0.1, 2});
  scene.bodies[1].initial.position = {0.5, -0.3, 1};
  scene.joints = {{.type = type, .body = 0, .to = to, .point = {0.2, 0.1, 0.4}, .axis = axis}};
  return scene;
}

double gap_after(const Scene& scene, const Quaternion& first, const Quaternion& second) {
  State state = initial_state(scene);
  state[0].orientation = first * state[0].orientation;
  state[1].orientation = second * state[1].orientation;
  Values values;
  evaluate({.quantity = Quantity::angular_joint_gap}, scene, state, values);
  return values.at(0).x();
}

TEST(AngularJointGap, OfAHingeIsTheTiltOfItsAxis) {
  const Vector3 across = axis.unitOrthogonal();
  const Quaternion any = turn(2.3, {-0.4, 1, 0.6});
  for (const int to : {world, 1}) {
    const Scene scene = scene_of(JointType::hinge, to);
    const Quaternion with = to == world ? Quaternion(Quaternion::Identity()) : any;
    EXPECT_NEAR(gap_after(scene, with, with), 0, 1e-15);
    EXPECT_NEAR(gap_after(scene, with * turn(1.2, axis), with), 0, 1e-15) << "about the axis it may turn";
    for (const double tilt : {1e-9, 0.3, 2.8}) {
      EXPECT_NEAR(gap_after(scene, with * turn(tilt, across), with), tilt, 1e-14);
      EXPECT_NEAR(gap_after(scene, with * turn(tilt, across) * turn(0.8, axis), with), tilt, 1e-14);
    }
  }
}

TEST(AngularJointGap, OfAFixedJointIsAnyTurn) {
  const Quaternion any = turn(2.3, {-0.4, 1, 0.6});
  for (const int to : {world, 1}) {
    const Scene scene = scene_of(JointType::fixed, to);
    const Quaternion with = to == world ? Quaternion(Quaternion::Identity()) : any;
    EXPECT_NEAR(gap_after(scene, with, with), 0, 1e-15);
    for (const double angle : {1e-9, 0.3, 2.8})
      EXPECT_NEAR(gap_after(scene, with * turn(angle, {1, 1, -0.3}), with), angle, 1e-14);
  }
}

TEST(AngularJointGap, IsUndefinedWhereJointsLetBodiesTurn) {
  const Observable q{.quantity = Quantity::angular_joint_gap};
  EXPECT_TRUE(undefined_in(q, scene_of(JointType::ball, 1)));
  EXPECT_FALSE(undefined_in(q, scene_of(JointType::hinge, 1)));
  EXPECT_FALSE(undefined_in(q, scene_of(JointType::fixed, world)));
  const Observable other{.quantity = Quantity::angular_joint_gap, .body = 1};
  EXPECT_TRUE(undefined_in(other, scene_of(JointType::hinge, world))) << "the joint is not of that body";
}

}  // namespace
