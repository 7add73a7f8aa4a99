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

// The same of two hinges apart, which are a universal joint with an offset.
TEST(CertifiedJoints, OffsetUniversalIsTwoHingesWithoutARing) {
  constexpr double end = 0.8;
  const core::JointAngle first{
      {.start = 0.2, .stiffness = 6, .damping = 0.3, .armature = 0.4, .target = -0.3}};
  const core::JointAngle second{{.which = core::Ordinal::second, .force = 0.7, .armature = 0.2}};
  core::Joint joint = joint_of(JointType::offset_universal);
  joint.length = 0.3, joint.angles = {first, second};
  const Vector3 far = point + joint.length * axis.cross(axis_2);
  for (const bool reversed : {false, true}) {
    core::Joint stated = joint;
    core::Scene scene = body_on(joint);
    const Vector3 ring_spin = 0.9 * axis, spin = ring_spin + 0.5 * axis_2;
    core::BodyState& start = scene.bodies[0].initial;
    start.angular_velocity = spin;
    start.velocity = ring_spin.cross(far - point) + spin.cross(start.position - far);
    if (reversed) {  // told from the world: axes, angles and points change places
      stated.body = core::world, stated.to = 0, stated.point = far;
      stated.axis = axis_2, stated.axis_2 = axis;
      for (core::JointAngle& c : stated.angles) {
        core::reverse(c);
        c.which = c.which == core::Ordinal::first ? core::Ordinal::second : core::Ordinal::first;
      }
      scene.joints = {stated};
    }
    const core::BodyState exact = solution(scene, end, 1e11).truth.state(end)[0];
    ASSERT_GT((exact.position - start.position).norm(), 0.2) << "hardly a motion";
    const auto with_ring = [&](double part) {
      core::Scene rings = scene;
      rings.bodies.push_back(scene.bodies[0]);
      core::Body& ring = rings.bodies[1];
      ring.name = "ring", ring.mass = part, ring.inertia = part * core::Matrix3::Identity();
      ring.initial = {.position = point, .angular_velocity = ring_spin};
      core::Joint one{.type = JointType::hinge, .body = 1, .point = point, .axis = axis},
          two{.type = JointType::hinge, .body = 0, .to = 1, .point = far, .axis = axis_2};
      one.angles = {first}, two.angles = {second};
      two.angles[0].which = core::Ordinal::first;
      rings.joints = {one, two};
      const core::BodyState state = solution(rings, end, 1e11).truth.state(end)[0];
      return (state.position - exact.position).norm() +
             (state.angular_velocity - exact.angular_velocity).norm();
    };
    const double coarse = with_ring(1e-4), fine = with_ring(1e-5);
    EXPECT_LT(coarse, 1e-3) << reversed;
    EXPECT_NEAR(coarse / fine, 10, 0.1) << reversed;
  }
}

// Two hinges and a universal joint between them hold more than is free.
// Two hinges and a universal joint between them hold more than is free.
// A gimbal is three hinges with rings of no mass between them: with rings of 1e-4 and 1e-5 of the body's inertia, which bear
// the same springs, dampers, motors and rotors, the motion comes to the gimbal's as the inertia goes to nothing.
TEST(CertifiedJoints, GimbalIsThreeHingesWithoutRings) {
  const Vector3 tilted = (axis_2 + 0.5 * axis).normalized(), between = axis.cross(tilted).normalized();
  constexpr double end = 0.8;
  const core::JointAngle first{
      {.start = 0.2, .stiffness = 6, .damping = 0.3, .armature = 0.4, .target = -0.3}};
  const core::JointAngle second{{.which = core::Ordinal::second, .force = 0.7, .armature = 0.2}};
  const core::JointAngle third{{.which = core::Ordinal::third, .stiffness = 9, .armature = 0.3}};
  core::Joint gimbal = joint_of(JointType::gimbal);
  gimbal.axis_2 = tilted, gimbal.angles = {first, second, third};
  core::Scene scene = body_on(gimbal);
  const Vector3 spin = 0.9 * axis - 0.6 * between + 0.5 * tilted;
  const auto spun = [](core::Body& body, const Vector3& w) {
    body.initial.angular_velocity = w, body.initial.velocity = w.cross(body.initial.position - point);
  };
  spun(scene.bodies[0], spin);
  const core::BodyState exact = solution(scene, end, 1e11).truth.state(end)[0];
  ASSERT_GT((exact.position - scene.bodies[0].initial.position).norm(), 0.2) << "hardly a motion";
  const auto with_rings = [&](double part) {
    core::Scene rings = scene;
    rings.bodies.resize(3, scene.bodies[0]);
    for (std::size_t i : {1u, 2u}) {
      core::Body& ring = rings.bodies[i];
      ring.name = i == 1 ? "outer" : "inner", ring.mass = part,
      ring.inertia = part * core::Matrix3::Identity();
      ring.initial = {.position = point};
    }
    spun(rings.bodies[1], 0.9 * axis), spun(rings.bodies[2], 0.9 * axis - 0.6 * between);
    const auto hinge = [](int body, int to, const Vector3& about, core::JointAngle angle) {
      angle.which = core::Ordinal::first;
      core::Joint joint{.type = JointType::hinge, .body = body, .to = to, .point = point, .axis = about};
      joint.angles = {angle};
      return joint;
    };
    rings.joints = {hinge(1, core::world, axis, first), hinge(2, 1, between, third),
                    hinge(0, 2, tilted, second)};
    const core::BodyState state = solution(rings, end, 1e11).truth.state(end)[0];
    return (state.position - exact.position).norm() +
           (state.angular_velocity - exact.angular_velocity).norm();
  };
  const double coarse = with_rings(1e-4), fine = with_rings(1e-5);
  EXPECT_LT(coarse, 1e-3);
  EXPECT_NEAR(coarse / fine, 10, 0.1);
}

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
