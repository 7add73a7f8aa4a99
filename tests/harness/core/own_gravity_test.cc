// Energies, balances, laws and directions are those of each body's own gravity.
#include "harness/core/event_rows.h"
#include "harness/core/force_balance.h"
#include "harness/core/force_law.h"
#include "harness/core/observable.h"

#include <gtest/gtest.h>

namespace cylon::core {
namespace {

const Vector3 of_all(0.3, -9.81, 0.2), own(1.1, 2.3, -0.7);

Scene three() {
  Scene scene;
  scene.bodies.resize(3);
  for (std::size_t i = 0; i < 3; ++i) {
    const double x = static_cast<double>(i);
    scene.bodies[i].name = std::to_string(i), scene.bodies[i].mass = 1.5 + x;
    scene.bodies[i].initial.position = {0.2 + x, 1 - 0.3 * x, 0.7 * x - 0.1};
  }
  scene.bodies[1].gravity = own, scene.bodies[2].gravity = Vector3::Zero();
  scene.forces = {UniformGravity{of_all / 3}, UniformGravity{2 * of_all / 3}};
  return scene;
}

TEST(OwnGravity, ReplacesTheScenes) {
  const Scene scene = three();
  EXPECT_EQ(gravity(scene), Vector3(of_all / 3 + 2 * of_all / 3));
  EXPECT_EQ(gravity_of(scene, scene.bodies[0]), gravity(scene));
  EXPECT_EQ(gravity_of(scene, scene.bodies[1]), own);
  EXPECT_TRUE(gravity_of(scene, scene.bodies[2]).isZero(0));
  EXPECT_EQ(strongest_gravity(scene), gravity(scene).norm());
  EXPECT_TRUE(states_own_gravity(scene));
}

// U = -sum m g.x; its change is the work of the weights.
TEST(OwnGravity, HasItsPotential) {
  const Scene scene = three();
  const State state = initial_state(scene);
  const double u0 = -1.5 * of_all.dot(state[0].position), u1 = -2.5 * own.dot(state[1].position);
  EXPECT_NEAR(potential_total(scene, state), u0 + u1, 1e-13);
  EXPECT_NEAR(own_gravity_potential(scene, state), u1, 1e-13);
  Values values;
  evaluate({.quantity = Quantity::energy}, scene, state, values);
  EXPECT_NEAR(values.front().x(), u0 + u1, 1e-13);
  EXPECT_NEAR(energy_scale(scene, state),
              1.5 * (std::abs(of_all.dot(state[0].position)) / 3 * 3) + std::abs(u1), 1e-12);
  // An error dx of each place moves it by sum m |g| dx at most.
  EXPECT_NEAR(potential_error_total(scene, state, {.position = 1e-3}),
              1e-3 * (1.5 * of_all.norm() + 2.5 * own.norm()), 1e-12);
}

TEST(OwnGravity, ActsFromOutside) {
  Scene scene = three();
  scene.forces.clear();
  const auto outside = [](const Scene& s) {
    for (const Broken& broken : broken_by(s))
      if (broken.momentum) return true;
    return false;
  };
  EXPECT_TRUE(outside(scene));
  scene.bodies[1].gravity = Vector3::Zero();
  EXPECT_FALSE(outside(scene));
}

TEST(OwnGravity, SaysWhereUpIs) {
  const Scene scene = three();
  EXPECT_LT((event_up(scene, scene.bodies[0]) + of_all.normalized()).norm(), 1e-15);
  EXPECT_LT((event_up(scene, scene.bodies[1]) + own.normalized()).norm(), 1e-15);
  EXPECT_EQ(event_up(scene, scene.bodies[2]), Vector3::UnitY());
}

// v changes by g dt of the body's own, and by nothing that is missing.
TEST(OwnGravity, BalancesMomentum) {
  Scene scene = three();
  scene.joints = {{.body = 0, .to = 1}};
  Recording run;
  run.dt = 0.01, run.steps = {0, 1};
  State before = initial_state(scene), now = before;
  for (std::size_t i = 0; i < 3; ++i) now[i].velocity += 0.01 * gravity_of(scene, scene.bodies[i]);
  run.states = {before, now};
  run.reactions = std::vector<Reaction>{{.joint = 0}};
  EXPECT_NEAR(force_imbalance({.quantity = Quantity::momentum_balance}, scene, run), 0, 1e-13);
  scene.bodies[1].gravity.reset();
  EXPECT_GT(force_imbalance({.quantity = Quantity::momentum_balance}, scene, run), 1);
}

}  // namespace
}  // namespace cylon::core
