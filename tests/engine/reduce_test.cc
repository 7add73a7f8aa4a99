// Reduced coordinates are the same mechanics as joints kept as constraints, and are read as centres of mass.
#include "engine/reduce.h"

#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

namespace cylon::engine {
namespace {

using Type = Joint::Type;

// The same mechanism held by a locked body in place of the world: no joint is to the world, so that none is
// reduced and all are constraints.
Model by_constraints(Model model) {
  model.reduce_joints = false;
  return model;
}

struct Pinned {
  const char* name;
  Model model;
  int reduced;  // joints that go
};

// A body at an anchor of its own, that moves as the joint lets it.
void hang(Model& model, Type type, const Vector3& anchor, const Vector3& pivot, const Vector3& turn,
          const Vector3& w, const Matrix3& inertia, Real mass) {
  const Vector3 arm = exponential(turn) * -anchor;
  add_body(model, make_body(mass, inertia), pivot + arm, turn, w.cross(arm), w);
  const Vector3 axis = w.normalized();
  model.joints.push_back({.type = type,
                          .body = static_cast<int>(model.bodies.size()) - 1,
                          .anchor = anchor,
                          .to_anchor = pivot,
                          .axis = exponential(turn).conjugate() * axis,
                          .to_axis = axis});
}

std::vector<Pinned> pinned_models() {
  std::vector<Pinned> all;
  const Vector3 anchor = {0.3, -0.2, 0.1}, pivot = {0.1, 0.2, 0.3}, turn = {0.5, 1.1, -0.6},
                w = {1.2, -0.7, 0.9};
  const Vector3 g = {0.3, -9.81, 0.7};
  const Matrix3 inertia = general_inertia(0.05, 0.07, 0.1);
  for (const Type type : {joint_types::ball, joint_types::hinge}) {
    Model m;
    hang(m, type, anchor, pivot, turn, w, inertia, 1.3);
    m.forces.gravity = g;
    m.forces.springs.push_back({0, {0.2, 0.1, -0.3}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0.6});
    m.forces.drags.push_back({0, 0.3, 0.02, 0.1});
    m.forces.drives.push_back({0, {0.9, 0.4, -1.1}, 2.3});
    m.forces.thrusts.push_back({.body = 0, .force = {0.3, 0.2, 0.4}});
    all.push_back({type == joint_types::ball ? "ball" : "hinge", m, 1});
  }
  {  // a point on a rod
    Model m;
    const Vector3 arm = {0.4, -0.3, 0.5};
    add_body(m, make_body(1.3, Matrix3::Zero()), pivot + arm, {0, 0, 0}, w.cross(arm), {0, 0, 0});
    m.joints.push_back({.type = joint_types::distance, .body = 0, .to_anchor = pivot, .length = arm.norm()});
    m.forces.gravity = g;
    m.forces.drags.push_back({0, 0.3, 0, 0});
    m.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.6, 1.9, 0.4}, 25.0, 0.5, 0.6});
    all.push_back({"rod", m, 1});
  }
  {  // two pinned bodies, a spring and attraction between them
    Model m;
    hang(m, joint_types::ball, anchor, pivot, turn, w, inertia, 1.3);
    hang(m, joint_types::hinge, {0.1, 0.25, -0.2}, {0.9, 0.4, -0.2}, {-0.3, 0.6, 0.2}, {0.4, 0.9, -0.8},
         general_inertia(0.03, 0.05, 0.04), 0.8);
    m.forces.gravity = g;
    m.forces.springs.push_back({0, {0.2, 0.1, -0.3}, 1, {0.1, -0.2, 0.15}, 25.0, 0.5, 0.2});
    m.forces.attractions.push_back({0, 1, 0.8});
    all.push_back({"two", m, 2});
  }
  {  // a free body on a pinned one: one joint reduced, one kept
    Model m = linked_bodies(true);
    m.forces.gravity = g;
    all.push_back({"double pendulum", m, 1});
  }
  return all;
}

TEST(Reduced, AgreeWithConstraints) {
  for (const Pinned& p : pinned_models()) {
    const Model kept = by_constraints(p.model);
    EXPECT_EQ(reduce(p.model).pinned.size(), static_cast<std::size_t>(p.reduced)) << p.name;
    EXPECT_TRUE(reduce(kept).pinned.empty()) << p.name;
    const auto b = run(kept, "rk8", 1, 1000).motions;
    // rk8 at these steps is exact to rounding: of 1000 steps, in positions, momenta and turns of 1
    EXPECT_LT(distance(run(p.model, "rk8", 1, 1000).motions, b), 1e-12) << p.name;
  }
}

// The integrators agree to their truncation: the difference falls with their order.
TEST(Reduced, DifferFromConstraintsOnlyByTruncation) {
  for (const Pinned& p : pinned_models()) {
    const Model kept = by_constraints(p.model);
    const auto apart = [&](int steps) {
      const auto b = run(kept, "velocity-verlet", 1, steps).motions;
      return distance(run(p.model, "velocity-verlet", 1, steps).motions, b);
    };
    const Real slope = std::log2(apart(500) / apart(1000));
    EXPECT_NEAR(slope, 2, 0.1) << p.name;
  }
}

// p = x + R c, v = w x R c, spin about the centre of mass: before the first step what was given, at all times
// v and the numerical derivative of p.
TEST(Reduced, AreReadAsCentresOfMass) {
  for (const Pinned& p : pinned_models()) {
    const Reduced reduced = reduce(p.model);
    std::vector<Motion> start;
    read(reduced.model.bodies, reduced.readings, reduced.model.motions.data(), start);
    EXPECT_LT(distance(start, p.model.motions), 1e-14) << p.name;

    const Time h = 1e-3;
    std::vector<std::vector<Motion>> seen;
    run(p.model, with("rk8", h), 21, [&](const World& world) { seen.push_back(world.motions()); });
    for (std::size_t i = 0; i < p.model.bodies.size(); ++i) {
      const Body& body = p.model.bodies[i];
      const Motion &a = seen[18][i], &b = seen[19][i], &c = seen[20][i];
      // h^2/6 times the third derivative, about 100 m/s^3
      EXPECT_LT(((c.position - a.position) / (2 * h) - velocity(body, b)).norm(), 1e-4) << p.name;
      const Quaternion turn = c.orientation * a.orientation.conjugate();
      const Vector3 w = turn.vec() / h * (turn.w() < 0 ? -1 : 1);
      if (body.inertia.isZero(0)) continue;
      EXPECT_LT((w - angular_velocity(body, b)).norm(), 1e-3) << p.name;
    }
  }
}

TEST(Reduced, RodDoesNotRotatePoint) {
  Model m = pinned_models()[2].model;
  m.motions[0].orientation = exponential({0.4, 0.2, 0.9});
  const Outcome end = run(m, "rk4", 1, 200);
  EXPECT_EQ(end.motions[0].orientation.coeffs(), m.motions[0].orientation.coeffs());
  EXPECT_EQ(end.motions[0].angular_momentum, Vector3(Vector3::Zero()));
  EXPECT_NEAR((end.motions[0].position - m.joints[0].to_anchor).norm(), m.joints[0].length, 1e-14);
}

// What turns is the rod, not the body on it: drag on its rotation, or on its spin, changes nothing.
TEST(Reduced, RodIsNotBrakedByAngularDrag) {
  Model m = pinned_models()[2].model, braked = m;
  braked.forces.drags.push_back({0, 0, Real(0.05), Real(0.4)});
  EXPECT_EQ(reduce(braked).pinned.size(), 1u);
  EXPECT_LT(distance(run(m, "rk8", 1, 100).motions, run(braked, "rk8", 1, 100).motions), 1e-14);
  EXPECT_LT(
      distance(run(by_constraints(braked), "rk8", 1, 1000).motions, run(braked, "rk8", 1, 1000).motions),
      1e-12);
}

// What must stay a constraint, each for its reason.
TEST(Reduced, KeepsOtherBodies) {
  const Model base = heavy_top();
  EXPECT_EQ(reduce(base).pinned.size(), 1u);
  Model second = base;  // a body's second joint
  second.joints.push_back(
      {.body = 0, .anchor = {0, 0.1, 0}, .to_anchor = place(base.motions, 0, {0, 0.1, 0})});
  EXPECT_EQ(reduce(second).model.joints.size(), 1u);
  Model touching = base;
  touching.shapes[0] = Sphere{0.1};
  make_touchable(touching, 0.5);
  EXPECT_EQ(reduce(touching).model.joints.size(), 1u);
  Model turning = base;
  turning.frame = RotatingFrame{{0.1, 0.2, 0.3}};
  EXPECT_EQ(reduce(turning).model.joints.size(), 1u);
  Model fixed = base;
  fixed.joints[0].type = joint_types::fixed;
  EXPECT_EQ(reduce(fixed).model.joints.size(), 1u);
  Model off_centre = base;
  off_centre.joints[0].type = joint_types::distance;
  EXPECT_EQ(reduce(off_centre).model.joints.size(), 1u);
  Model losing = base;
  losing.bodies[0].mass_rate = -0.1;
  EXPECT_EQ(reduce(losing).model.joints.size(), 1u);
}

// A heavy top in reduced coordinates keeps E, the vertical angular momentum about its tip and L along its
// axis.
TEST(Reduced, AHeavyTopKeepsItsIntegrals) {
  const Model m = heavy_top();
  const Vector3 tip = m.joints[0].to_anchor;
  const auto integrals = [&](const std::vector<Motion>& motions) {
    const Vector3 about = angular_momentum(motions) - tip.cross(momentum(motions));
    return Vector3(energy(m, motions), about.y(), about.dot(motions[0].orientation * Vector3::UnitY()));
  };
  for (const char* integrator : {"rk8", "velocity-verlet", "bm6"}) {
    const Outcome end = run(m, integrator, 2, 4000);
    const Vector3 change = integrals(end.motions) - integrals(m.motions);
    const bool splitting = std::string(integrator) != "rk8";
    EXPECT_LT(std::abs(change[1]), 1e-12) << integrator;
    EXPECT_LT(std::abs(change[2]), 1e-11) << integrator;
    EXPECT_LT(std::abs(change[0]), splitting ? 1e-4 : 1e-10) << integrator;  // Verlet: h^2 x 100 J/s^2
  }
}

}  // namespace
}  // namespace cylon::engine
