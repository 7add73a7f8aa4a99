// Sliders, cylindrical, planar and universal joints and screws: what they keep, and motions in closed form.
#include "tests/engine/joint_scenes.h"

namespace cylon::engine {
namespace {

// What rounding leaves of a joint; a screw turns the rounding of its displacement by 1/pitch.
Real rounding(Joint::Type type) { return type.couples ? 2e-13 : 2e-14; }

class Kinds : public testing::TestWithParam<JointKind> {};

TEST_P(Kinds, KeepMomentumAngularMomentumAndEnergy) {
  const JointScene scene = joint_scene(GetParam().type, false);
  const Model& model = scene.model;
  ASSERT_LT(opened(model.motions, scene.joint()), 1e-14);
  for (const char* integrator : {"rk8", "velocity-verlet", "yoshida4"}) {
    const Outcome end = run(model, integrator, 2, 2000);
    EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), 1e-12) << integrator;
    EXPECT_LT((angular_momentum(end.motions) - angular_momentum(model.motions)).norm(), 1e-12) << integrator;
    EXPECT_NEAR(energy(model, end.motions), energy(model, model.motions),
                std::string(integrator) == "velocity-verlet" ? 1e-4 : 1e-9)
        << integrator;
    EXPECT_LT(opened(end.motions, scene.joint()), rounding(GetParam().type)) << integrator;
    EXPECT_GT(distance(end.motions, model.motions), 0.1);
  }
}

// A law on every coordinate that a joint leaves free, gravity and drag besides.
Model forced(Joint::Type type, bool to_world) {
  JointScene s = joint_scene(type, to_world);
  s.model.forces.gravity = {0.2, -9.81, 0.4};
  s.model.forces.drags.push_back({0, 0.4, 0.03, 0.2});
  const auto act = [&](const Coordinate& at, Real stiffness, Real damping) {
    CoordinateLaw law;
    law.at = at;
    law.stiffness = stiffness, law.damping = damping, law.force = 0.3;
    law.target = harmonic(0.1, 0.2, 3, 0.4);
    s.model.forces.coordinate_laws.push_back(law);
  };
  if (type.place == Joint::Place::along_axis) act(s.displacement(s.axis), 40, 0.7);
  if (type.place == Joint::Place::in_plane) {
    act(s.displacement(s.second), 40, 0.7);
    act(s.displacement(s.axis.cross(s.second)), 30, 0.5);
  }
  if (type.turn == Joint::Turn::about_axis || type.turn == Joint::Turn::about_two_axes)
    act(s.angle(), 2, 0.05);
  if (type.turn == Joint::Turn::about_two_axes) act(s.angle(true), 1.5, 0.04);
  if (type == joint_types::gimbal)  // far from where its axes are parallel
    for (const Coordinate& q : gimbal_angles(s.model, s.joint()))
      act(q, q.kind == Coordinate::Kind::inclination ? 40 : 1.5, 0.04);
  return s.model;
}

using Case = std::tuple<JointKind, Integrator>;
class Schemes : public testing::TestWithParam<Case> {};

// Each scheme has its order, with laws on the coordinates, and stays closed to rounding.
TEST_P(Schemes, HaveTheirOrder) {
  const auto& [kind, integrator] = GetParam();
  for (const bool to_world : {false, true}) {
    const Model model = forced(kind.type, to_world);
    Options options = with(integrator.name, 0.01);
    options.constraints = true;
    if (!unsupported(model, options).empty()) continue;
    const int order = integrator.order;
    int n = order >= 8 ? 8 : order >= 6 ? 32 : order == 4 ? 256 : order == 2 ? 1024 : 16384;
    const auto after = [&](std::string_view name, int steps) {
      Options o = with(name, 0.5 / steps);
      o.constraints = true;
      return run(model, o, steps).motions;
    };
    const auto exact = after("rk8", 2048);
    // Between long steps, of which the next term of the error is a part, and rounding lies a factor of four.
    if (order >= 8) {
      for (const int finer : {12, 16})
        if (distance(after(integrator.name, 2 * finer), exact) > 1e-13) n = finer;
    }
    const auto near = after(integrator.name, n), nearer = after(integrator.name, 2 * n);
    const Real coarse = distance(near, exact), fine = distance(nearer, exact);
    if (order >= 8) {
      EXPECT_NEAR(std::log2(coarse / fine), order, 0.5) << to_world << n;  // measured: 7.79 to 8.27
    } else if (fine > 1e-12) {
      EXPECT_NEAR(std::log2(coarse / fine), order, order > 4 ? 0.5 : 0.1) << to_world;
    }
    EXPECT_LT(opened(near, model.joints[0]), rounding(kind.type)) << to_world;
    EXPECT_LT(opened(nearer, model.joints[0]), rounding(kind.type)) << to_world;
  }
}

INSTANTIATE_TEST_SUITE_P(
    All, Schemes, testing::Combine(testing::ValuesIn(joint_kinds), testing::ValuesIn(fixed_integrators())),
    [](const auto& row) {
      return std::get<0>(row.param).name + std::string("_") + test_name(std::get<1>(row.param).name);
    });

// In reduced coordinates and as constraints a joint to the world gives the same motion.
TEST_P(Kinds, MoveAlikeInBothForms) {
  const Model model = forced(GetParam().type, true);
  Options reduced = with("rk8", 1e-3), rows = reduced;
  rows.constraints = true;
  const Outcome a = run(model, reduced, 500), b = run(model, rows, 500);
  EXPECT_LT(distance(a.motions, b.motions), 1e-11);
  EXPECT_LT(opened(a.motions, model.joints[0]), 1e-13);
}

TEST_P(Kinds, AreKeptByAuto) {
  for (const bool to_world : {false, true}) {
    const Model model = forced(GetParam().type, to_world);
    const Outcome end = run(model, with("auto", 0.02), 50), fine = run(model, "rk8", 1, 4000);
    EXPECT_TRUE(end.remarks.empty());
    EXPECT_LT(distance(end.motions, fine.motions), 1e-9) << to_world;
    EXPECT_LT(opened(end.motions, model.joints[0]), 5 * rounding(GetParam().type)) << to_world;
  }
}

INSTANTIATE_TEST_SUITE_P(All, Kinds, testing::ValuesIn(joint_kinds),
                         [](const auto& row) { return std::string(row.param.name); });

// A screw that gravity drives: with the axis a through the centre of mass and I about it,
//   s'' = (g.a)/(1 + I/(m p^2))
TEST(Screw, FallsWithItsPitch) {
  const Vector3 axis = Vector3(0.3, -0.5, 0.8).normalized(), g = {0.2, -9.81, 0.4};
  const Real mass = 1.3, about = 0.02, pitch = -0.11;
  const Quaternion turn = Quaternion::FromTwoVectors(Vector3::UnitX(), axis);
  Model model;
  add_body(model, make_body(mass, Vector3(about, 0.05, 0.04).asDiagonal()), {0.1, 0.2, 0.3}, {0, 0, 0},
           {0, 0, 0}, {0, 0, 0});
  model.motions[0].orientation = turn;
  model.forces.gravity = g;
  model.joints.push_back({.type = joint_types::screw,
                          .body = 0,
                          .to_anchor = {0.1, 0.2, 0.3},
                          .axis = Vector3::UnitX(),
                          .to_axis = axis,
                          .relative = turn,
                          .pitch = pitch});
  const Real a = g.dot(axis) / (1 + about / (mass * pitch * pitch)), t = 3;
  for (const char* integrator : {"auto", "yoshida4"}) {
    const Outcome end = run(model, integrator, t, 3000);
    const Vector3 moved = end.motions[0].position - Vector3(0.1, 0.2, 0.3);
    EXPECT_NEAR(moved.dot(axis), a * t * t / 2, 1e-9) << integrator;
    EXPECT_LT(moved.cross(axis).norm(), 1e-12) << integrator;
    EXPECT_NEAR(angular_velocity(end.bodies[0], end.motions[0]).dot(axis), a * t / pitch, 1e-8) << integrator;
    EXPECT_LT(opened(end.motions, model.joints[0]), 2e-13) << integrator;
  }
}

// Two shafts at an angle b:  tan(out) = cos b tan(in),  out'/in' = cos b/(1 - sin^2 b sin^2 in),  `in` counted
// from where the first yoke is square to both shafts.
TEST(Universal, TurnsTwoShaftsUnevenly) {
  const Real b = 0.7, speed = 3;
  const Vector3 first = Vector3::UnitX(), second = {std::cos(b), std::sin(b), 0}, up = Vector3::UnitZ();
  const Matrix3 inertia = Vector3(0.02, 0.05, 0.05).asDiagonal();
  const Quaternion q = Quaternion::FromTwoVectors(first, second);
  Model model;
  add_body(model, make_body(1, inertia), {-1, 0, 0}, {0, 0, 0}, {0, 0, 0}, speed * first);
  add_body(model, make_body(1, inertia), second, {0, 0, b}, {0, 0, 0}, speed * std::cos(b) * second);
  ASSERT_LT(angle(model.motions[1].orientation, q), 1e-15);
  model.joints.push_back(
      {.type = joint_types::hinge, .body = 0, .to_anchor = {-1, 0, 0}, .axis = first, .to_axis = first});
  model.joints.push_back(
      {.type = joint_types::hinge, .body = 1, .to_anchor = second, .axis = first, .to_axis = second});
  model.joints.push_back({.type = joint_types::universal,
                          .body = 1,
                          .anchor = -first,
                          .to = 0,
                          .to_anchor = first,
                          .axis = Vector3::UnitY(),
                          .to_axis = up});
  for (const bool constraints : {false, true}) {
    Options options = with("auto", 0.01);
    options.constraints = constraints;
    Real slowest = 10, fastest = 0;
    run(model, options, 300, [&](const World& world) {
      const Motion &in = world.motions()[0], &out = world.motions()[1];
      const Vector3 yoke = in.orientation * up;
      const Real turned = std::atan2(yoke.dot(first.cross(up)), yoke.dot(up));
      const Real ratio = angular_velocity(world.bodies()[1], out).dot(second) /
                         angular_velocity(world.bodies()[0], in).dot(first);
      const Real sine = std::sin(b) * std::sin(turned);
      ASSERT_NEAR(ratio, std::cos(b) / (1 - sine * sine), 1e-9) << world.time();
      slowest = std::min(slowest, ratio), fastest = std::max(fastest, ratio);
      ASSERT_NEAR(kinetic_energy(world.bodies(), world.motions()),
                  kinetic_energy(model.bodies, model.motions), 1e-9);
    });
    EXPECT_NEAR(slowest, std::cos(b), 1e-3);
    EXPECT_NEAR(fastest, 1 / std::cos(b), 1e-3);
  }
}

// A slider between two bodies is in their plan as what it is, and a screw is no part of a tree.
TEST(Plans, NameTheNewKinds) {
  const Model model = joint_scene(joint_types::screw, false).model;
  EXPECT_NE(missing(Method::trees, model).find("screws"), std::string::npos);
  EXPECT_EQ(missing(Method::bodies, model), "");
  EXPECT_EQ(missing(Method::body_steps, model), "");
  const Model slider = joint_scene(joint_types::slider, true).model;
  const Plan plan = make_plan(slider, with("auto", 0.01));
  const auto row = std::ranges::find(plan.stages, std::string("reduced coordinates"), &Stage::name);
  EXPECT_EQ(row->reason, "body 0 moves along an axis");
}

}  // namespace
}  // namespace cylon::engine
