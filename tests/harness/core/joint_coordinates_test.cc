// Coordinates of joints against motions that are built from them: every kind, axes and poses without luck.
#include "harness/core/joint_coordinates.h"

#include "harness/core/observable.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <vector>

namespace {

using namespace cylon::core;

const Vector3 axis = Vector3(1, -2, 0.5).normalized();
const Vector3 axis_2 = Vector3(0.3, 1, -0.2).cross(axis).normalized();
const Vector3 tilted = (axis_2 + 0.6 * axis).normalized();  // of a gimbal
const Vector3 point(0.2, 0.1, 0.4);
constexpr double pitch = -0.3;

Quaternion turn(double angle, const Vector3& about) {
  return Quaternion(Eigen::AngleAxisd(angle, about.normalized()));
}

// Two bodies in general positions and orientations, joined to each other, or the first to the world.
Scene scene_of(JointType type, int to) {
  Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].initial.orientation = turn(0.7, {1, 2, -1});
  scene.bodies[0].initial.position = {-0.4, 0.2, 0.1};
  scene.bodies[1].initial.orientation = turn(-1.9, {0.3, 0.1, 2});
  scene.bodies[1].initial.position = {0.5, -0.3, 1};
  Joint joint{.type = type, .body = 0, .to = to, .point = point, .axis = axis};
  if (kind_of(type).has_second_axis()) joint.axis_2 = kind_of(type).has_square_axes() ? axis_2 : tilted;
  if (kind_of(type).screws) joint.pitch = pitch;
  scene.joints = {joint};
  return scene;
}

// How far each free coordinate has gone.
struct Coordinates {
  double displacement[2] = {0, 0}, angle[3] = {0, 0, 0};
};

// The motion of `body` against `to` that coordinates stand for: a turn about the point, then a way, in the axes of the
// world at t = 0.
struct Relative {
  Quaternion rotation;
  Vector3 way;
};
Relative relative(JointType type, const Coordinates& q) {
  const JointKind& kind = kind_of(type);
  Relative r{Quaternion::Identity(), Vector3::Zero()};
  if (kind.turn == JointTurn::about_axis) r.rotation = turn(q.angle[0], axis);
  if (kind.turn == JointTurn::about_two_axes) r.rotation = turn(q.angle[0], axis) * turn(q.angle[1], axis_2);
  if (kind.turn == JointTurn::about_three_axes)
    r.rotation = turn(q.angle[0], axis) * turn(q.angle[2], axis.cross(tilted)) * turn(q.angle[1], tilted);
  if (kind.place == JointPlace::along_axis)
    r.way = (kind.screws ? pitch * q.angle[0] : q.displacement[0]) * axis;
  if (kind.place == JointPlace::in_plane)
    r.way = q.displacement[0] * axis_2 + q.displacement[1] * axis.cross(axis_2);
  return r;
}

// The state in which `to` has moved by itself and `body` by the coordinates against it.
State posed(const Scene& scene, const Coordinates& q, const Quaternion& carried, const Vector3& by) {
  State state = initial_state(scene);
  const bool free = scene.joints[0].to != world;
  const Quaternion all = free ? carried : Quaternion(Quaternion::Identity());
  const Vector3 move = free ? by : Vector3(Vector3::Zero());
  const auto carry = [&](BodyState& s) {
    s.position = all * s.position + move;
    s.orientation = all * s.orientation;
  };
  const Relative r = relative(scene.joints[0].type, q);
  state[0].position = r.rotation * (state[0].position - point) + point + r.way;
  state[0].orientation = r.rotation * state[0].orientation;
  carry(state[0]);
  carry(state[1]);
  return state;
}

const JointType kinds[] = {JointType::hinge,     JointType::slider, JointType::cylindrical, JointType::planar,
                           JointType::universal, JointType::screw,  JointType::gimbal};
const Coordinates some = {.displacement = {0.4, -0.7}, .angle = {1.1, -0.8, 0.7}};
const Ordinal ordinals[] = {Ordinal::first, Ordinal::second, Ordinal::third};

TEST(JointCoordinates, AreThoseThatMadeThePose) {
  for (const JointType type : kinds)
    for (const int to : {world, 1}) {
      SCOPED_TRACE(testing::Message() << kind_of(type).name << " to " << to);
      const Scene scene = scene_of(type, to);
      const State state = posed(scene, some, turn(2.3, {-0.4, 1, 0.6}), {3, -1, 2});
      const HeldJoint held = held_joint(scene, scene.joints[0]);
      for (int k = 0; k < kind_of(type).displacements(); ++k)
        EXPECT_NEAR(joint_displacement(held, ordinals[k], state), some.displacement[k], 1e-14) << k;
      for (int k = 0; k < kind_of(type).angles(); ++k)
        EXPECT_NEAR(joint_angle(held, ordinals[k], state), some.angle[k], 1e-14) << k;
      EXPECT_NEAR(open_by(scene, scene.joints[0], state), 0, 2e-15);
      EXPECT_NEAR(turned_by(scene, scene.joints[0], state), 0, 2e-15);
    }
}

TEST(JointCoordinates, GapsShowWhatAJointForbids) {
  struct Case {
    JointType type;
    Coordinates wrong;  // of another kind, whose freedom this one has not
    JointType freedom;
    double open, turned;
  };
  const Case cases[] = {
      {JointType::slider, {.angle = {0.3, 0}}, JointType::hinge, 0, 0.3},
      {JointType::slider, {.displacement = {0, 0.2}}, JointType::planar, 0.2, 0},
      {JointType::hinge, {.displacement = {0.25, 0}}, JointType::slider, 0.25, 0},
      {JointType::cylindrical, {.displacement = {0.1, 0}}, JointType::planar, 0.1, 0},
      {JointType::planar, {.displacement = {-0.3, 0}}, JointType::slider, 0.3, 0},
      {JointType::screw, {.displacement = {0.02, 0}}, JointType::slider, 0.02, 0},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(kind_of(c.type).name);
    Scene made = scene_of(c.freedom, 1);
    const State state = posed(made, c.wrong, turn(0.4, {1, 1, 0}), {1, 0, 0});
    const Scene scene = scene_of(c.type, 1);
    EXPECT_NEAR(std::abs(open_by(scene, scene.joints[0], state)), c.open, 1e-14);
    EXPECT_NEAR(turned_by(scene, scene.joints[0], state), c.turned, 1e-14);
  }
  const Scene scene = scene_of(JointType::universal, 1);
  State state = initial_state(scene);  // about the third axis, which it forbids
  state[0].orientation = turn(0.2, axis.cross(axis_2)) * state[0].orientation;
  EXPECT_NEAR(turned_by(scene, scene.joints[0], state), 0.2, 1e-14);
}

// Velocities of two states that are a short time apart.
State moving(const State& before, const State& now, const State& after, double h) {
  State state = now;
  for (std::size_t i = 0; i < now.size(); ++i) {
    state[i].velocity = (after[i].position - before[i].position) / (2 * h);
    Quaternion change = after[i].orientation * before[i].orientation.conjugate();
    if (change.w() < 0) change.coeffs() = -change.coeffs();
    state[i].angular_velocity = change.vec() / h;
  }
  return state;
}

TEST(JointCoordinates, RatesAreTheirDerivatives) {
  constexpr double h = 1e-5;
  const Coordinates rates = {.displacement = {0.9, -0.4}, .angle = {-1.3, 0.6, -0.9}};
  for (const JointType type : kinds)
    for (const int to : {world, 1}) {
      SCOPED_TRACE(testing::Message() << kind_of(type).name << " to " << to);
      const Scene scene = scene_of(type, to);
      const auto at = [&](double t) {
        Coordinates q = some;
        for (int k = 0; k < 2; ++k) q.displacement[k] += t * rates.displacement[k];
        for (int k = 0; k < 3; ++k) q.angle[k] += t * rates.angle[k];
        return posed(scene, q, turn(2.3 + 0.7 * t, {-0.4, 1, 0.6}),
                     Vector3(3, -1, 2) + t * Vector3(0.5, 0.2, -1));
      };
      const State state = moving(at(-h), at(0), at(h), h);
      const HeldJoint held = held_joint(scene, scene.joints[0]);
      for (int k = 0; k < kind_of(type).displacements(); ++k)
        EXPECT_NEAR(joint_displacement_rate(held, ordinals[k], state), rates.displacement[k], 1e-9) << k;
      for (int k = 0; k < kind_of(type).angles(); ++k)
        EXPECT_NEAR(joint_angle_rate(held, ordinals[k], state), rates.angle[k], 1e-9) << k;
      // The rows of the joint do not resist such a motion, and each sees one that is not allowed.
      std::vector<JointRow> rows;
      add_rows(held, state, rows);
      EXPECT_EQ(rows.size(),
                6u - static_cast<std::size_t>(kind_of(type).displacements() + kind_of(type).angles()));
      for (const JointRow& row : rows) {
        double rate = row.direction.dot(state[0].velocity) + row.spin.dot(state[0].angular_velocity);
        if (to != world)
          rate -= row.direction.dot(state[1].velocity) + row.to_spin.dot(state[1].angular_velocity);
        EXPECT_NEAR(rate, 0, 1e-9);
        EXPECT_NEAR(row.gap, 0, 2e-15);
      }
    }
}

// What a joint says of a motion at t = 0: nothing of one that it allows, all of one that it forbids.
TEST(JointCoordinates, ForbiddenMotionIsWhatTheRowsSee) {
  const RelativeMotion any{{0.3, -1.2, 0.8}, {0.5, 0.9, -0.4}};
  for (const JointType type : kinds) {
    SCOPED_TRACE(kind_of(type).name);
    const Scene scene = scene_of(type, world);
    const Joint& joint = scene.joints[0];
    const RelativeMotion forbidden = cylon::core::forbidden(joint, Vector3::Zero(), any);
    State state = initial_state(scene);
    const Vector3 arm = point - state[0].position;
    const auto residual = [&](const RelativeMotion& m) {
      std::vector<JointRow> rows;
      add_rows(held_joint(scene, joint), state, rows);
      double most = 0;
      for (const JointRow& row : rows)
        most = std::max(most,
                        std::abs(row.direction.dot(m.velocity - m.spin.cross(arm)) + row.spin.dot(m.spin)));
      return most;
    };
    EXPECT_GT(residual(any), 0.1);
    EXPECT_NEAR(residual({any.velocity - forbidden.velocity, any.spin - forbidden.spin}), 0, 1e-15);
  }
}

TEST(JointCoordinates, GoOnInASceneThatBeginsLater) {
  for (const JointType type : kinds) {
    SCOPED_TRACE(kind_of(type).name);
    Scene scene = scene_of(type, 1);
    Joint& joint = scene.joints[0];
    for (int k = 0; k < kind_of(type).displacements(); ++k)
      joint.displacements.push_back({{.which = ordinals[k], .start = 0.1, .stiffness = 2}});
    for (int k = 0; k < kind_of(type).angles(); ++k)
      joint.angles.push_back({{.which = ordinals[k], .start = -0.2, .stiffness = 3, .target = 0.4}});
    const Quaternion carried = turn(2.3, {-0.4, 1, 0.6});
    const State middle = posed(scene, some, carried, {3, -1, 2});
    Coordinates further = some;
    further.displacement[0] += 0.2, further.displacement[1] -= 0.1, further.angle[0] -= 0.9,
        further.angle[1] += 0.3;
    const State end = posed(scene, further, turn(-0.3, {1, 0, 0.2}), {0, 1, 0});

    Scene later = scene;
    later.joints = {joint_at(held_joint(scene, joint), middle)};
    for (std::size_t i = 0; i < middle.size(); ++i) later.bodies[i].initial = middle[i];
    EXPECT_NEAR(open_by(later, later.joints[0], end), 0, 4e-15);
    EXPECT_NEAR(turned_by(later, later.joints[0], end), 0, 4e-15);
    const double whole = joint_potential(held_joint(scene, joint), end),
                 parts = joint_potential(held_joint(later, later.joints[0]), end);
    if (type == JointType::universal)
      continue;  // its second angle begins anew from a turned first one, and both are others
    EXPECT_NEAR(parts, whole, 1e-13);
    EXPECT_GT(whole, 0.1);
  }
}

TEST(JointCoordinates, TargetsMoveAsTheSceneSays) {
  JointCoordinate swings{.target = 0.3, .target_amplitude = 0.2, .target_frequency = 5, .target_phase = 0.7};
  JointCoordinate table{.target_times = {0.5, 1, 3}, .target_values = {0.1, -0.4, 1}};
  constexpr double h = 1e-6;
  for (const double t : {0.0, 0.6, 0.9, 1.7, 2.99, 4.0}) {
    EXPECT_NEAR(target(swings, t), 0.3 + 0.2 * std::cos(5 * t + 0.7), 1e-15);
    for (const JointCoordinate* c : {&swings, &table})
      EXPECT_NEAR(target_rate(*c, t), (target(*c, t + h) - target(*c, t - h)) / (2 * h), 1e-9) << t;
  }
  EXPECT_EQ(target(table, 0.2), 0.1);
  EXPECT_EQ(target(table, 1), -0.4);
  EXPECT_NEAR(target(table, 2), 0.3, 1e-15);
  EXPECT_EQ(target(table, 7), 1);
  EXPECT_EQ(target_rate(table, 0.5), -1);  // from the right
  EXPECT_EQ(target_rate(table, 3), 0);
  EXPECT_TRUE(target_moves(swings) && target_moves(table));
  EXPECT_FALSE(target_moves({.target = 1, .target_amplitude = 2}));
}

TEST(JointCoordinates, AreObservables) {
  Scene scene = scene_of(JointType::cylindrical, 1);
  scene.joints[0].angles.push_back({{.start = 3}});
  const State state = posed(scene, some, turn(0.4, {1, 1, 0}), {1, 0, 0});
  const auto value = [&](Quantity quantity) {
    Values values;
    evaluate({.quantity = quantity}, scene, state, values);
    return values.size() == 1 ? values[0].x() : std::nan("");
  };
  EXPECT_NEAR(value(Quantity::joint_displacement), some.displacement[0], 1e-14);
  EXPECT_NEAR(value(Quantity::joint_angle), 3 + some.angle[0], 1e-14);
  const Observable angle{.quantity = Quantity::joint_angle};
  EXPECT_NEAR(distance(angle, {{3.1, 0, 0, 0}}, {{-3.1, 0, 0, 0}}), 2 * std::numbers::pi - 6.2, 1e-14);
  EXPECT_FALSE(undefined_in(angle, scene));
  EXPECT_TRUE(undefined_in({.quantity = Quantity::joint_angle, .which = Ordinal::second}, scene));
  EXPECT_TRUE(undefined_in({.quantity = Quantity::joint_displacement}, scene_of(JointType::universal, 1)));
}

}  // namespace
