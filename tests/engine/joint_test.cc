// The rows of each joint against numerical derivatives, and mechanisms of all kinds in motion.
#include "engine/joint.h"

#include "engine/bodies.h"
#include "engine/free_rotation.h"
#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

namespace cylon::engine {
namespace {

using Type = Joint::Type;

// Two bodies that hold together exactly, moving as one rigid body, so that every joint's rates are zero or
// not as asked: `loose` gives them motions of their own.
struct Held {
  Model model;
  Joint joint;
};

Held held(Type type, bool to_world) {
  Held h;
  const Vector3 a = {0.3, -0.2, 0.1}, b = {-0.4, 0.1, 0.2}, turn_a = {0.5, 1.1, -0.6},
                turn_b = {-1.3, 0.2, 0.8};
  const Vector3 place_of_joint = {0.4, 0.9, -0.3}, p_a = place_of_joint - exponential(turn_a) * a;
  add_body(h.model, make_body(1.3, general_inertia(0.05, 0.07, 0.1)), p_a, turn_a, {0.3, 0.8, -0.5},
           {1.2, -0.7, 0.9});
  Joint& j = h.joint;
  j.type = type, j.body = 0, j.anchor = a, j.to_anchor = place_of_joint;
  const Vector3 axis = Vector3(0.3, -0.5, 0.8).normalized();  // world
  const Quaternion q_a = exponential(turn_a);
  Quaternion q_b = Quaternion::Identity();
  if (!to_world) {
    q_b = exponential(turn_b);
    add_body(h.model, make_body(0.8, general_inertia(0.02, 0.035, 0.04)), place_of_joint - q_b * b, turn_b,
             {-0.4, 0.1, 0.6}, {-0.8, 1.5, 0.4});
    j.to = 1, j.to_anchor = b;
  }
  j.axis = q_a.conjugate() * axis, j.to_axis = q_b.conjugate() * axis;
  j.relative = q_b.conjugate() * q_a;
  const Vector3 second = axis.unitOrthogonal(), third = axis.cross(second);
  if (type.turn == Joint::Turn::about_two_axes) j.axis = q_a.conjugate() * second;
  if (type.place == Joint::Place::along_axis) h.model.motions[0].position += 0.3 * axis;
  if (type.place == Joint::Place::along_normal)
    j.length = Real(0.25), h.model.motions[0].position += j.length * third;
  if (type.place == Joint::Place::in_plane) h.model.motions[0].position += 0.3 * second - 0.2 * third;
  if (type.couples) {
    j.pitch = -0.15;
    j.relative = exponential(Vector3(2 * j.to_axis)) * j.relative;  // it has turned by 0.3/-0.15 = -2
  }
  if (type == joint_types::distance) {
    h.model.motions[0].position += Vector3(0.2, -0.4, 0.3);
    j.length = Vector3(0.2, -0.4, 0.3).norm();
  }
  return h;
}

// Free motion over t: positions along lines, orientations by the free rotation.
std::vector<Motion> freely(const Model& model, Real t) {
  std::vector<Motion> moved = model.motions;
  for (std::size_t i = 0; i < moved.size(); ++i) {
    moved[i].position += t * velocity(model.bodies[i], moved[i]);
    moved[i].orientation = free_flow(model.bodies[i], moved[i].orientation, moved[i].angular_momentum, t);
  }
  return moved;
}

std::vector<Row> rows_of(const Held& h, const std::vector<Motion>& motions) {
  std::vector<Row> rows;
  add_rows(h.joint, h.model.bodies, motions.data(), rows);
  return rows;
}

class EveryJoint : public testing::TestWithParam<std::tuple<Type, bool>> {};

// c' = n.(v_a - v_b) + s_a.w_a - s_b.w_b  and  c'' = bias + s.alpha, along free motion.
TEST_P(EveryJoint, RowsAreTheDerivativesOfTheirOffsets) {
  const auto [type, to_world] = GetParam();
  const Held h = held(type, to_world);
  const Real e = 1e-4;  // truncation e^2 x 30 = 3e-7; rounding 1e-16/e^2 = 1e-8
  const auto before = rows_of(h, freely(h.model, -e)), now = rows_of(h, h.model.motions),
             after = rows_of(h, freely(h.model, e));
  ASSERT_EQ(static_cast<int>(now.size()), row_count(type));
  const auto rate = [&](int body, const Vector3& n, const Vector3& s) -> Real {
    if (body == fixed_world) return 0;
    const auto i = static_cast<std::size_t>(body);
    return n.dot(velocity(h.model.bodies[i], h.model.motions[i])) +
           s.dot(angular_velocity(h.model.bodies[i], h.model.motions[i]));
  };
  // s.alpha of a body that turns freely:  alpha = I^-1 (-w x L)
  const auto turning = [&](int body, const Vector3& s) -> Real {
    if (body == fixed_world) return 0;
    const auto i = static_cast<std::size_t>(body);
    const Motion& m = h.model.motions[i];
    const Vector3 w = angular_velocity(h.model.bodies[i], m);
    return -s.dot(inverse_inertia_times(h.model.bodies[i], m.orientation, w.cross(m.angular_momentum)));
  };
  for (std::size_t k = 0; k < now.size(); ++k) {
    const Row& r = now[k];
    EXPECT_NEAR(r.offset, 0, 1e-14);
    EXPECT_NEAR((after[k].offset - before[k].offset) / (2 * e),
                rate(r.body, r.direction, r.lever) - rate(r.to, r.direction, r.to_lever), 3e-6)
        << k;
    const bool of_turn = static_cast<int>(k) >= row_count({type.place, Joint::Turn::freely});
    if (type.turn == Joint::Turn::never && of_turn)
      continue;                            // zero where both spin alike, which is where it is solved
    if (type.couples && k >= 4) continue;  // the same where the spin is about the axis
    EXPECT_NEAR((after[k].offset - 2 * now[k].offset + before[k].offset) / (e * e),
                r.bias + turning(r.body, r.lever) - turning(r.to, r.to_lever), 3e-6)
        << k;
  }
}

INSTANTIATE_TEST_SUITE_P(
    Types, EveryJoint,
    testing::Combine(testing::Values(joint_types::ball, joint_types::hinge, joint_types::distance,
                                     joint_types::fixed, joint_types::slider, joint_types::cylindrical,
                                     joint_types::planar, joint_types::universal, joint_types::screw,
                                     joint_types::gimbal, joint_types::rectangular,
                                     joint_types::offset_universal),
                     testing::Bool()));

// ---- In motion -------------------------------------------------------------------------------------

// Sets the second body's velocities such that the joint's rates are zero: both move as one about the joint.
Model joined(Type type, bool off_centre = true) {
  Held h = held(type, false);
  Model& m = h.model;
  const Motion& a = m.motions[0];
  const Vector3 w = angular_velocity(m.bodies[0], a), v = velocity(m.bodies[0], a);
  if (!off_centre) h.joint.anchor.setZero();
  const Vector3 axis = a.orientation * h.joint.axis;
  Vector3 spin = w;
  if (type == joint_types::hinge) spin += 2.5 * axis;
  if (type == joint_types::ball || type == joint_types::distance) spin += Vector3(1.0, -2.0, 0.5);
  Motion& b = m.motions[1];
  const Vector3 at = place(m.motions, 1, h.joint.to_anchor);
  const Vector3 here = type == joint_types::distance ? at : place(m.motions, 0, h.joint.anchor);
  const Vector3 v_at = v + w.cross(here - a.position);  // both anchors move as points of the first body
  b = make_motion(m.bodies[1], b.position, b.orientation, v_at - spin.cross(at - b.position), spin);
  if (!off_centre) h.joint.length = (a.position - at).norm();
  m.joints.push_back(h.joint);
  return m;
}

TEST(Joined, FreeBodiesKeepMomentumAngularMomentumAndEnergy) {
  for (const Type type : {joint_types::ball, joint_types::hinge, joint_types::distance, joint_types::fixed}) {
    const Model model = joined(type);
    for (const char* integrator : {"rk8", "velocity-verlet", "yoshida4"}) {
      const Outcome end = run(model, integrator, 2, 2000);
      const int label = joint_types::label(type);
      // rk8: energy and L to h^8, here rounding; RATTLE: L to rounding, energy to h^2 x 100 J/s^2
      EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), 1e-12) << integrator << label;
      EXPECT_LT((angular_momentum(end.motions) - angular_momentum(model.motions)).norm(), 1e-12)
          << integrator << label;
      EXPECT_NEAR(energy(model, end.motions), energy(model, model.motions),
                  std::string(integrator) == "velocity-verlet" ? 1e-4 : 1e-9)
          << integrator << label;
      EXPECT_LT(joint_gap(end.motions, model.joints[0]), 2e-14) << integrator << label;
    }
  }
}

// Held fast, two bodies are one: the merged body moves as they do.
TEST(Joined, AFixedJointMakesOneBody) {
  const Model model = joined(joint_types::fixed);
  const Motion &a = model.motions[0], &b = model.motions[1];
  const Vector3 centre = (1.3 * a.position + 0.8 * b.position) / 2.1;
  Matrix3 inertia = Matrix3::Zero();  // in the axes of the first
  const Matrix3 r_a = a.orientation.toRotationMatrix();
  for (std::size_t i = 0; i < 2; ++i) {
    const Matrix3 r = model.motions[i].orientation.toRotationMatrix();
    const Vector3 d = model.motions[i].position - centre;
    inertia += r_a.transpose() *
               (r * model.bodies[i].inertia * r.transpose() +
                model.bodies[i].mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose())) *
               r_a;
  }
  const Vector3 w = angular_velocity(model.bodies[0], a), v = momentum(model.motions) / 2.1;
  Model one;
  add_body(one, make_body(2.1, (inertia + inertia.transpose()) / 2), centre, {0, 0, 0}, v, w);
  one.motions[0] = make_motion(one.bodies[0], centre, a.orientation, v, w);
  const Outcome two = run(model, "rk8", 2, 1000), whole = run(one, "rk8", 2, 1000);
  EXPECT_LT(angle(two.motions[0].orientation, whole.motions[0].orientation), 1e-11);
  EXPECT_LT(
      ((1.3 * two.motions[0].position + 0.8 * two.motions[1].position) / 2.1 - whole.motions[0].position)
          .norm(),
      1e-12);
}

// A chain that hangs on the world by three kinds of joints at once.
Model chain() {
  Model model = joined(joint_types::hinge);
  // A third body on a distance joint to the second, off centre at both ends.
  const Vector3 a = {0.1, 0.05, -0.1}, b = {0.05, -0.1, 0.08};
  const Vector3 from = place(model.motions, 1, a), v = [&] {
    const Motion& m = model.motions[1];
    return Vector3(velocity(model.bodies[1], m) +
                   angular_velocity(model.bodies[1], m).cross(from - m.position));
  }();
  const Vector3 rod = {0.2, -0.3, 0.1}, turn = {0.4, 0.3, -0.9};
  add_body(model, make_body(0.6, general_inertia(0.02, 0.03, 0.035)), from + rod - exponential(turn) * b,
           turn, v, {0, 0, 0});
  model.joints.push_back(
      {.type = joint_types::distance, .body = 1, .anchor = a, .to = 2, .to_anchor = b, .length = rod.norm()});
  model.forces.gravity = {0.2, -9.81, 0.4};
  // Forces that read velocities must not see momenta that the joints forbid.
  model.forces.drags.push_back({1, 0.4, 0.03, 0.2});
  model.forces.springs.push_back({2, {0.1, 0.2, 0}, fixed_world, {0.3, 0.2, 0.5}, 8, 0.4, 0.5});
  return model;
}

class Chains : public EveryIntegrator {};

// RATTLE has order 2, Yoshida's compositions of it 4 and 6, the Runge-Kutta integrators on accelerations
// theirs.
TEST_P(Chains, HaveOrderOfIntegrator) {
  const Model model = chain();
  if (!unsupported(model, with(GetParam().name, 0.01)).empty()) return;
  const int order = GetParam().order;
  const int n = order >= 8 ? 8 : order >= 6 ? 32 : order == 4 ? 256 : order == 2 ? 1024 : 16384;
  const auto exact = run(model, "rk8", 0.5, 2048).motions;
  const Real coarse = distance(run(model, GetParam().name, 0.5, n).motions, exact);
  const Real fine = distance(run(model, GetParam().name, 0.5, 2 * n).motions, exact);
  EXPECT_GT(fine, 1e-12);
  if (order >=
      8) {  // only steps of 1/16 and 1/32 s lie between the coarse and rounding: too few for its slope
    EXPECT_GT(std::log2(coarse / fine), order - 0.5);
  } else {
    EXPECT_NEAR(std::log2(coarse / fine), order, order > 4 ? 0.5 : 0.12);
  }
}

TEST_P(Chains, StayClosed) {
  const Model model = chain();
  if (!unsupported(model, with(GetParam().name, 0.01)).empty()) return;
  run(model, with(GetParam().name, 2e-3), 500, [&](const World& world) {
    for (const Joint& joint : model.joints)
      ASSERT_LT(joint_gap(world.motions(), joint), 2e-14) << world.time();
  });
}

CYLON_EVERY_SCHEME(Chains);

// Five ball joints between the same two bodies hold them as a fixed joint does; nothing overflows.
TEST(Redundant, ManyJointsAreOneFixed) {
  const Model fixed = joined(joint_types::fixed);
  Model many = fixed;
  many.joints.clear();
  for (const Vector3& at : {Vector3(0, 0, 0), Vector3(0.3, 0, 0.1), Vector3(0, 0.4, 0),
                            Vector3(0.1, 0.1, 0.5), Vector3(0.3, 0.2, 0.9)}) {
    const Motion& b = fixed.motions[1];
    const Vector3 x = place(fixed.motions, 0, at);
    many.joints.push_back(
        {.body = 0, .anchor = at, .to = 1, .to_anchor = b.orientation.conjugate() * (x - b.position)});
  }
  for (const char* integrator : {"rk8", "velocity-verlet"}) {
    const Outcome a = run(fixed, integrator, 1, 500), b = run(many, integrator, 1, 500);
    EXPECT_LT(distance(a.motions, b.motions), 1e-11) << integrator;
  }
}

}  // namespace
}  // namespace cylon::engine
