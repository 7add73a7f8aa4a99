// The bound on the error of an energy, against the changes that moved states make in it.
#include "harness/core/claim.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

namespace {

using namespace cylon::core;

const Observable energy{.quantity = Quantity::energy};

// Two bodies in general motion that attract each other.
Scene attracting() {
  Scene scene;
  scene.bodies.resize(2);
  Body &a = scene.bodies[0], &b = scene.bodies[1];
  a.mass = 1.3, b.mass = 2.1;
  a.inertia = Vector3(0.2, 0.3, 0.4).asDiagonal();
  b.inertia = Vector3(0.5, 0.6, 0.7).asDiagonal();
  a.initial.position = {0.3, 1.1, -0.4};
  a.initial.orientation = Quaternion(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  a.initial.velocity = {0.5, -0.2, 0.9};
  a.initial.angular_velocity = {1.5, -0.7, 0.4};
  b.initial.position = {-0.8, 0.2, 0.6};
  b.initial.velocity = {-0.1, 0.3, 0.2};
  b.initial.angular_velocity = {0.2, 0.9, -1.1};
  scene.forces = {Attraction{.body = 0, .to = 1, .strength = 3.7}};
  return scene;
}

double value(const Scene& scene, const State& state) {
  Values values;
  evaluate(energy, scene, state, values);
  return values.at(0).x();
}

double bound(const Scene& scene, const StateError& error) {
  Truth truth;
  truth.state = [&](double) { return initial_state(scene); };
  truth.error = error;
  return truth_error(energy, scene, truth, 1, 1);
}

// |E(x + dx) - E(x - dx)| / 2 where each body moves by e towards the other.
double change_on_approach(const Scene& scene, double e) {
  State plus = initial_state(scene), minus = plus;
  const Vector3 step = e * (plus[1].position - plus[0].position).normalized();
  plus[0].position += step, plus[1].position -= step;
  minus[0].position -= step, minus[1].position += step;
  return std::abs(value(scene, plus) - value(scene, minus)) / 2;
}

TEST(TruthError, OfAttractionIsReachedByBodiesThatApproach) {
  const Scene scene = attracting();
  const double e = 1e-5;
  const double change = change_on_approach(scene, e);  // error of the central difference: (e/d)^2
  EXPECT_NEAR(bound(scene, {.position = e}), change, 1e-8 * change);
}

TEST(TruthError, OfAttractionGrowsWithStrengthAndMassesAndFallsWithDistanceSquared) {
  const StateError e{.position = 1e-5};
  const double before = bound(attracting(), e);
  Scene stronger = attracting();
  std::get<Attraction>(stronger.forces[0]).strength *= 1.7;
  stronger.bodies[0].mass *= 1.4;
  stronger.bodies[1].mass *= 0.6;
  EXPECT_NEAR(bound(stronger, e), 1.7 * 1.4 * 0.6 * before, 1e-12 * before);
  Scene farther = attracting();
  for (Body& body : farther.bodies) body.initial.position *= 1.9;
  EXPECT_NEAR(bound(farther, e), before / (1.9 * 1.9), 1e-12 * before);
}

TEST(TruthError, WithoutAttractionDoesNotCoverItsEnergy) {
  Scene without = attracting();
  without.forces.clear();
  const double e = 1e-5;
  EXPECT_LT(bound(without, {.position = e}), change_on_approach(attracting(), e) / 2);
}

TEST(TruthError, OfEnergyCoversEveryMovedStateOfAllConservativeForces) {
  Scene scene = attracting();
  scene.forces.emplace_back(UniformGravity{{0.1, -9.81, 0.2}});
  scene.forces.emplace_back(Spring{.body = 0,
                                   .anchor = {0.1, 0.2, 0.3},
                                   .to = world,
                                   .to_anchor = {0.4, 1.5, 0.2},
                                   .stiffness = 40,
                                   .rest_length = 0.5});
  scene.forces.emplace_back(Spring{.body = 0,
                                   .anchor = {0.1, -0.2, 0.1},
                                   .to = 1,
                                   .to_anchor = {-0.3, 0.1, 0.2},
                                   .stiffness = 25,
                                   .rest_length = 0.2});
  const StateError error{.position = 2e-6, .velocity = 3e-6, .orientation = 1e-6, .angular_velocity = 4e-6};
  const double allowed = bound(scene, error), start = value(scene, initial_state(scene));
  std::mt19937 random(20240611);
  std::normal_distribution<double> normal;
  const auto step = [&](double size) {
    return Vector3(size * Vector3(normal(random), normal(random), normal(random)).normalized());
  };
  double largest = 0;
  for (int n = 0; n < 2000; ++n) {
    State moved = initial_state(scene);
    for (BodyState& s : moved) {
      s.position += step(error.position);
      s.velocity += step(error.velocity);
      s.angular_velocity += step(error.angular_velocity);
      const Vector3 turn = step(error.orientation);
      s.orientation = Quaternion(Eigen::AngleAxisd(turn.norm(), turn.normalized())) * s.orientation;
    }
    largest = std::max(largest, std::abs(value(scene, moved) - start));
  }
  EXPECT_LE(largest, allowed * (1 + 1e-5));
  EXPECT_GT(largest, allowed / 20) << "a bound that says nothing";
}

// Two bodies on one spring, far from the origin on the side of the second: the bound once forgot that end.
TEST(TruthError, OfSpringCountsBothBodies) {
  Scene scene = attracting();
  scene.bodies[0].initial.position = {0.02, -0.01, 0.03};
  scene.bodies[1].initial.position = {7, -4, 5};
  scene.forces = {Spring{.body = 0, .to = 1, .stiffness = 40, .rest_length = 0.5}};
  const double e = 1e-6;
  const double change = change_on_approach(scene, e);
  EXPECT_NEAR(bound(scene, {.position = e}), change, 1e-6 * change);
}

TEST(TruthError, OfSpringCountsTheLeverOfBothAnchors) {
  Scene scene = attracting();
  for (Body& body : scene.bodies) body.initial.orientation = Quaternion::Identity();
  scene.bodies[0].initial.position = {1, 0, 0}, scene.bodies[1].initial.position = {3, 0, 0};
  scene.bodies[0].initial.angular_velocity = scene.bodies[1].initial.angular_velocity = Vector3::Zero();
  scene.forces = {Spring{.body = 0,
                         .anchor = {0, 0.3, 0},
                         .to = 1,
                         .to_anchor = {0, 0.3, 0},
                         .stiffness = 40,
                         .rest_length = 0.5}};
  const double e = 1e-6;  // both turn about z, the anchors apart
  State plus = initial_state(scene), minus = plus;
  const auto turned = [](double angle) { return Quaternion(Eigen::AngleAxisd(angle, Vector3::UnitZ())); };
  plus[0].orientation = turned(e), plus[1].orientation = turned(-e);
  minus[0].orientation = turned(-e), minus[1].orientation = turned(e);
  const double change = std::abs(value(scene, plus) - value(scene, minus)) / 2;
  EXPECT_NEAR(bound(scene, {.orientation = e}), change, 1e-6 * change);
}

TEST(EventTypes, StandInTheOrderOfTheirKinds) {
  ASSERT_EQ(event_types().size(), static_cast<std::size_t>(EventKind::crossing) + 1);
  for (std::size_t i = 0; i < event_types().size(); ++i) {
    EXPECT_EQ(static_cast<std::size_t>(event_types()[i].kind), i);
    EXPECT_EQ(event_type(static_cast<EventKind>(i)).name, event_types()[i].name);
  }
}

}  // namespace
