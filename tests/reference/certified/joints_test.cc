// Joints and what acts along them, certified, against closed forms.
#include "harness/core/joint_coordinates.h"
#include "reference/certified/truth.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <numbers>

namespace cylon::certified {
namespace {

using core::JointType;
using core::Quaternion;
using core::Vector3;

const Vector3 axis = Vector3(1, -2, 0.5).normalized();
const Vector3 axis_2 = Vector3(0.3, 1, -0.2).cross(axis).normalized();
constexpr double mass = 1.7, gravity = 9.81;
const Vector3 point(0.2, -0.1, 0.4);

Quaternion turn(double angle, const Vector3& about) {
  return Quaternion(Eigen::AngleAxisd(angle, about.normalized()));
}

// A body in a general pose on a joint to the world, its centre `arm` from the point (world axes).
core::Scene body_on(const core::Joint& joint, const Vector3& arm = Vector3(0.3, 0.2, -0.4)) {
  core::Scene scene;
  core::Body body;
  body.name = "a", body.mass = mass;
  body.inertia = Vector3(0.5, 0.8, 0.6).asDiagonal();
  body.initial.orientation = turn(0.7, {1, 2, -1});
  body.initial.position = point + arm;
  scene.bodies = {body};
  scene.forces.emplace_back(core::UniformGravity{{0, -gravity, 0}});
  scene.joints = {joint};
  return scene;
}

core::Joint joint_of(JointType type) {
  core::Joint joint{.type = type, .body = 0, .to = core::world, .point = point, .axis = axis};
  if (core::kind_of(type).has_second_axis()) joint.axis_2 = axis_2;
  return joint;
}

struct End {
  double q, rate;
};
End displacement(const core::Scene& scene, double t, core::Ordinal which = core::Ordinal::first) {
  const core::State state = solution(scene, t, 1e11).truth.state(t);
  const core::HeldJoint held = core::held_joint(scene, scene.joints[0]);
  return {core::joint_displacement(held, which, state), core::joint_displacement_rate(held, which, state)};
}
End angle(const core::Scene& scene, double t, core::Ordinal which = core::Ordinal::first) {
  const core::State state = solution(scene, t, 1e11).truth.state(t);
  const core::HeldJoint held = core::held_joint(scene, scene.joints[0]);
  return {core::joint_angle(held, which, state), core::joint_angle_rate(held, which, state)};
}

// x(t) of  m x'' + c x' + k x = f  from rest at x = 0 (complex roots).
double oscillator(double m, double c, double k, double f, double t) {
  const double w = std::sqrt(k / m - std::pow(c / (2 * m), 2)), g = c / (2 * m);
  return f / k * (1 - std::exp(-g * t) * (std::cos(w * t) + g / w * std::sin(w * t)));
}

TEST(CertifiedJoints, SliderOnASpringWithADamper) {
  constexpr double k = 40, c = 1.3, start = 0.25, target = -0.4, force = 3, t = 1.4;
  core::Joint joint = joint_of(JointType::slider);
  joint.displacements.push_back(
      {{.start = start, .force = force, .stiffness = k, .damping = c, .target = target}});
  const double along = -gravity * axis.y() * mass;
  EXPECT_NEAR(displacement(body_on(joint), t).q,
              oscillator(mass, c, k, along + force - k * (start - target), t), 1e-13);
  // Without the damper it is elsewhere: the test sees it.
  EXPECT_GT(std::abs(displacement(body_on(joint), t).q -
                     oscillator(mass, 0, k, along + force - k * (start - target), t)),
            1e-3);
}

TEST(CertifiedJoints, CylinderFallsAndTurnsByItself) {
  core::Joint joint = joint_of(JointType::cylindrical);
  joint.angles.push_back({{.force = 0.9}});
  core::Scene scene = body_on(joint, Vector3(0.7 * axis));  // its centre on the axis
  const Vector3 body_axis = scene.bodies[0].initial.orientation.conjugate() * axis;
  const double moment = body_axis.dot(scene.bodies[0].inertia * body_axis), t = 0.8;
  EXPECT_NEAR(displacement(scene, t).q, -gravity * axis.y() * t * t / 2, 1e-13);
  EXPECT_NEAR(angle(scene, t).q, 0.9 / moment * t * t / 2, 1e-13);
}

//   (m p^2 + I) angle'' = p m g.n   where the centre is on the axis
TEST(CertifiedJoints, ScrewFallsSlowlyByItsInertia) {
  for (const double pitch : {0.2, -0.35}) {
    core::Joint joint = joint_of(JointType::screw);
    joint.pitch = pitch;
    core::Scene scene = body_on(joint, Vector3(-0.3 * axis));
    const Vector3 body_axis = scene.bodies[0].initial.orientation.conjugate() * axis;
    const double moment = body_axis.dot(scene.bodies[0].inertia * body_axis), t = 1.1;
    const double expected = pitch * mass * -gravity * axis.y() / (mass * pitch * pitch + moment) * t * t / 2;
    EXPECT_NEAR(angle(scene, t).q, std::remainder(expected, 2 * std::numbers::pi), 1e-12) << pitch;
    EXPECT_NEAR(displacement(scene, t).q, pitch * expected, 1e-12) << pitch;
  }
}

TEST(CertifiedJoints, PlanarBodySlidesInItsPlane) {
  core::Joint joint = joint_of(JointType::planar);
  joint.displacements.push_back({{.which = core::Ordinal::second, .stiffness = 30}});
  const core::Scene scene = body_on(joint, Vector3::Zero());  // its centre in the point
  const Vector3 third = axis.cross(axis_2), g(0, -gravity, 0);
  const double t = 0.9;
  EXPECT_NEAR(displacement(scene, t).q, g.dot(axis_2) * t * t / 2, 1e-13);
  EXPECT_NEAR(displacement(scene, t, core::Ordinal::second).q,
              oscillator(mass, 0, 30, mass * g.dot(third), t), 1e-13);
}

// A spring in a hinge through more than one turn: the angle is counted on.
TEST(CertifiedJoints, AngleCountsWholeTurns) {
  core::Joint joint = joint_of(JointType::hinge);
  constexpr double k = 0.05, t = 9;
  joint.angles.push_back({{.force = 0.6, .stiffness = k}});
  core::Scene scene = body_on(joint, Vector3(0.2 * axis));
  const Vector3 body_axis = scene.bodies[0].initial.orientation.conjugate() * axis;
  const double moment = body_axis.dot(scene.bodies[0].inertia * body_axis);
  const double expected = oscillator(moment, 0, k, 0.6, t);
  ASSERT_GT(expected, 2 * std::numbers::pi);
  EXPECT_NEAR(angle(scene, t).q, std::remainder(expected, 2 * std::numbers::pi), 1e-11);
}

// A servo:  m x'' = -k (x - A cos(f t + p)) - c (x' + A f sin(f t + p)), from rest.
TEST(CertifiedJoints, ServoFollowsATargetThatSwings) {
  constexpr double k = 25, c = 2, amplitude = 0.3, f = 4, phase = 0.6, t = 1.7;
  core::Joint joint = joint_of(JointType::slider);
  joint.displacements.push_back({{.stiffness = k,
                                  .damping = c,
                                  .target_amplitude = amplitude,
                                  .target_frequency = f,
                                  .target_phase = phase}});
  core::Scene scene = body_on(joint);
  scene.forces.clear();
  using Complex = std::complex<double>;
  // x = Re(X e^{i f t}) + the free part that makes it start at rest at 0.
  const Complex i(0, 1), drive = amplitude * std::exp(i * phase) * (k + i * f * c);
  const Complex x = drive / (k - mass * f * f + i * f * c);
  const double g = c / (2 * mass), w = std::sqrt(k / mass - g * g);
  const double x0 = -x.real(), v0 = -(i * f * x).real();
  const double free = std::exp(-g * t) * (x0 * std::cos(w * t) + (v0 + g * x0) / w * std::sin(w * t));
  EXPECT_NEAR(displacement(scene, t).q, (x * std::exp(i * f * t)).real() + free, 1e-13);
}

// A body with three equal moments, its centre in the joint:  T = I (first'^2 + second'^2)/2,  so that each angle moves by
// itself, the second one on a spring.  On a ball joint it would turn about one direction for ever.
TEST(CertifiedJoints, UniversalJointTurnsAboutItsTwoAxes) {
  constexpr double moment = 0.4, k = 3.7, first = 1.3, second = -0.8, t = 1.4;
  core::Joint joint = joint_of(JointType::universal);
  joint.angles.push_back({{.which = core::Ordinal::second, .stiffness = k}});
  core::Scene scene = body_on(joint, Vector3::Zero());
  scene.bodies[0].inertia = moment * core::Matrix3::Identity();
  scene.bodies[0].initial.angular_velocity = first * axis + second * axis_2;
  const double w = std::sqrt(k / moment);
  EXPECT_NEAR(angle(scene, t).q, first * t, 1e-13);
  EXPECT_NEAR(angle(scene, t).rate, first, 1e-13);
  EXPECT_NEAR(angle(scene, t, core::Ordinal::second).q, second / w * std::sin(w * t), 1e-13);
  EXPECT_NEAR(angle(scene, t, core::Ordinal::second).rate, second * std::cos(w * t), 1e-13);
}

// A slider and a hinge with a rotor:  (m + A) x'' = F,  (J + A) a'' = T  where the centre is on the axis.
TEST(CertifiedJoints, RotorsAddTheirInertia) {
  constexpr double rotor = 0.9, t = 1.1;
  core::Joint slider = joint_of(JointType::slider), hinge = joint_of(JointType::hinge);
  slider.displacements.push_back({{.force = 3, .armature = rotor}});
  hinge.angles.push_back({{.force = 0.6, .armature = rotor}});
  EXPECT_NEAR(displacement(body_on(slider), t).q,
              (3 - mass * gravity * axis.y()) / (mass + rotor) * t * t / 2, 1e-13);
  const core::Scene turning = body_on(hinge, Vector3(0.2 * axis));
  const Vector3 body_axis = turning.bodies[0].initial.orientation.conjugate() * axis;
  const double moment = body_axis.dot(turning.bodies[0].inertia * body_axis);
  EXPECT_NEAR(angle(turning, t).q, 0.6 / (moment + rotor) * t * t / 2, 1e-13);
}

// A universal joint whose angles have rotors, about a body with three equal moments: each angle moves by itself, and the
// second carries the first's bearing, not its rotor.
TEST(CertifiedJoints, RotorsOfAUniversalJointTurnWithTheirOwnAngles) {
  constexpr double moment = 0.4, k = 3.7, second = -0.8, t = 1.4, rotor = 0.25;
  core::Joint joint = joint_of(JointType::universal);
  joint.angles.push_back({{.which = core::Ordinal::first, .armature = 0.7}});
  joint.angles.push_back({{.which = core::Ordinal::second, .stiffness = k, .armature = rotor}});
  core::Scene scene = body_on(joint, Vector3::Zero());
  scene.bodies[0].inertia = moment * core::Matrix3::Identity();
  scene.bodies[0].initial.angular_velocity = 1.3 * axis + second * axis_2;
  const double w = std::sqrt(k / (moment + rotor));
  EXPECT_NEAR(angle(scene, t).q, 1.3 * t, 1e-13);
  EXPECT_NEAR(angle(scene, t, core::Ordinal::second).q, second / w * std::sin(w * t), 1e-13);
}

// Two hinges and a universal joint between them hold more than is free.
TEST(CertifiedJoints, RedundantJointsAreRefused) {
  core::Scene scene = body_on(joint_of(JointType::hinge));
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "b", scene.bodies[1].initial.position += Vector3(0.5, 0.2, -0.3);
  core::Joint other = joint_of(JointType::hinge), between = joint_of(JointType::universal);
  other.body = 1, other.point += Vector3(0.5, 0.2, -0.3), between.to = 1;
  scene.joints.push_back(other);
  scene.joints.push_back(between);
  EXPECT_THROW(solution(scene, 1, 1e11), core::OutOfDomain);
}

TEST(CertifiedJoints, WhatIsNotSmoothIsRefused) {
  struct Case {
    core::JointCoordinate acts;
    const char* reason;
  };
  const Case cases[] = {{{.lower = -1}, "limits"},
                        {{.friction = 1}, "dry friction"},
                        {{.quadratic_damping = 1}, "quadratic damping"},
                        {{.stiffness = 1, .target_times = {0, 1}, .target_values = {0, 1}}, "kinks"}};
  for (const Case& c : cases) {
    core::Joint joint = joint_of(JointType::slider);
    joint.displacements.push_back({c.acts});
    try {
      solution(body_on(joint), 1, 1e11);
      ADD_FAILURE() << c.reason;
    } catch (const core::OutOfDomain& refused) {
      EXPECT_NE(std::string(refused.what()).find(c.reason), std::string::npos) << refused.what();
    }
  }
}

}  // namespace
}  // namespace cylon::certified
