// Ten million steps: a spring, a top on its tip and a box at rest drift no more than theory predicts.
#include "tests/engine/fixtures.h"

#include "engine/pile/pile.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <vector>

namespace cylon::engine {
namespace {

constexpr std::int64_t steps = 10'000'000;
constexpr double n = static_cast<double>(steps);
constexpr double eps = std::numeric_limits<Real>::epsilon();

// m = k = 1 about the origin, from rest at 1 m.
World oscillator(const char* integrator, double h) {
  Model model;
  add_body(model, make_body(1, Matrix3::Zero()), {1, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0, 0, 0}, 1, 0, 0});
  Options options;
  options.integrator = integrator, options.dt = h;
  return World(model, options);
}

double energy_of_oscillator(const World& world) {
  const Motion& m = world.motions()[0];
  return (m.momentum.squaredNorm() + m.position.squaredNorm()) / 2;
}

// Velocity Verlet: x_k = cos(k theta), cos theta = 1 - h^2/2 (Hairer, Lubich, Wanner, I.5); the energy is in
// [E0 (1 - h^2/4), E0] for ever.  Rounding walks: sqrt(n) in the energy, n^(3/2) in the phase.
TEST(LongRun, VerletsSpringKeepsEnergyAndPhase) {
  constexpr double h = 0.05;
  World world = oscillator("velocity-verlet", h);
  double least = 1, most = 0;
  constexpr std::int64_t stride = 10007;  // prime: all phases are seen
  for (std::int64_t k = 0; k < steps; k += stride) {
    world.advance(std::min(stride, steps - k));
    const double e = energy_of_oscillator(world);
    least = std::min(least, e), most = std::max(most, e);
  }
  const double walk = 10 * eps * std::sqrt(n);
  EXPECT_LE(most, 0.5 * (1 + walk));
  EXPECT_GE(least, 0.5 * (1 - h * h / 4 - walk));
  const double theta = std::acos(1 - h * h / 2);
  EXPECT_NEAR(world.motions()[0].position.x(), std::cos(std::fmod(n * theta, 2 * std::numbers::pi)),
              10 * eps * n * std::sqrt(n));
}

// RK4 loses by the step: |R(ih)|^2 = 1 - h^6/72 + h^8/576.
TEST(LongRun, RungeKuttaEnergyLossAgreesWithTheory) {
  constexpr double h = 0.05;
  World world = oscillator("rk4", h);
  world.advance(steps);
  const double per_step = std::log1p(-std::pow(h, 6) / 72 + std::pow(h, 8) / 576);
  const double lost = -std::expm1(n * per_step);
  EXPECT_NEAR(1 - 2 * energy_of_oscillator(world), lost, 1e-3 * lost);
}

double energy_of_top(const World& world, const Vector3& gravity) {
  const Body& body = world.bodies()[0];
  const Motion& m = world.motions()[0];
  return m.momentum.squaredNorm() / (2 * body.mass) + m.angular_momentum.dot(angular_velocity(body, m)) / 2 -
         body.mass * gravity.dot(m.position);
}

// A symplectic integrator follows a nearby Hamiltonian over times exponential in 1/h (Hairer, Lubich, Wanner,
// IX.8): the energy stays in a band of O(h^2) and its mean does not move; the vertical part of L is kept.
TEST(LongRun, VerletTopKeepsEnergyBounded) {
  const Model model = heavy_top();
  Options options;
  options.integrator = "velocity-verlet", options.dt = 1.0 / 512;
  World world(model, options);
  const Motion& m = world.motions()[0];
  const Vector3 tip = model.joints[0].to_anchor;
  const auto vertical = [&] { return ((m.position - tip).cross(m.momentum) + m.angular_momentum).y(); };
  struct Window {
    double least = 1e300, most = -1e300, sum = 0;
    int samples = 0;
    double mean() const { return sum / samples; }
    double band() const { return most - least; }
  };
  const auto look = [&](std::int64_t count) {
    Window w;
    for (std::int64_t k = 0; k < count; k += 10) {
      world.advance(10);
      const double e = energy_of_top(world, model.forces.gravity);
      w.least = std::min(w.least, e), w.most = std::max(w.most, e), w.sum += e, ++w.samples;
    }
    return w;
  };
  constexpr std::int64_t window = 200'000;
  const double vertical0 = vertical(), energy0 = energy_of_top(world, model.forces.gravity);
  const Window first = look(window);
  world.advance(steps - 2 * window);
  const Window last = look(window);
  const double walk = 100 * eps * std::sqrt(n) * std::abs(energy0);
  EXPECT_LT(std::abs(last.mean() - first.mean()), 0.02 * first.band() + walk);
  EXPECT_LT(last.band(), 1.02 * first.band() + walk);
  EXPECT_NEAR(vertical(), vertical0, 100 * eps * std::sqrt(n) * std::abs(vertical0));
}

// A box lies on a level floor: nothing pulls along it, and what moves the box is rounding.
TEST(LongRun, ABoxAtRestStaysWithinANanometre) {
  Model model;
  const Real h = Real(0.5);
  add_body(model, make_body(1, Matrix3::Identity() / 6), {Real(0.3), h, Real(-0.2)}, {0, 0, 0}, {0, 0, 0},
           {0, 0, 0}, Box{Vector3::Constant(h)});
  model.forces.gravity = {0, Real(-9.81), 0};
  model.planes.push_back({{0, 1, 0}, 0});
  make_touchable(model, 0, Real(0.5));
  const auto stepper = make_pile(model, 1. / 240);
  std::vector<Motion> start, end;
  for (int k = 0; k < 1000; ++k) stepper->step();  // settled
  stepper->read(start);
  for (std::int64_t k = 0; k < steps; ++k) stepper->step();
  stepper->read(end);
  EXPECT_LT((end[0].position - start[0].position).norm(), 1e-9);
}

}  // namespace
}  // namespace cylon::engine
