// Energy lost in each touch, of a world that can be written down: a block bounces flat on a table, and each touch takes the share
// 1 - e^2 of the energy of its fall.
#include "harness/validation/touches.h"

#include "harness/validation/score.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace cylon::validation {
namespace {

using core::BodyState, measured::Experiment;

constexpr double g = 9.81, half = 0.05, table = 0.2, top = 0.5, along = 0.7;  // [m/s^2], [m], [m/s]

// What is left of the energy of the motion along the normal after touch k: e^2k.
double energy_after(int touches, double e) {
  return g * half + along * along / 2 + g * top * std::pow(e, 2 * touches);
}

// Falls from rest, from `top` above where it touches.
core::Recording bounces(const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
  const double e = scene.materials[0].restitution;
  core::Recording r;
  r.dt = dt;
  for (std::int64_t i = 0; i <= steps; i += every) {
    const double t = static_cast<double>(i) * dt;
    double begun = 0, up = 0, height = top, lasts = std::sqrt(2 * top / g), fall = std::sqrt(2 * g * top);
    while (t > begun + lasts && fall > 1e-6)
      begun += lasts, up = fall = e * fall, height = 0, lasts = 2 * up / g;
    const bool flies = fall > 1e-6;
    const double s = t - begun;
    BodyState now = scene.bodies[0].initial;
    now.position.x() += along * t;
    now.position.y() = table + half + (flies ? height + up * s - g * s * s / 2 : 0);
    now.velocity = {along, flies ? up - g * s : 0, 0};
    r.steps.push_back(i), r.states.push_back({now});
  }
  return r;
}

Experiment measured_with(double restitution, double rate = 250) {
  Experiment e;
  e.rate = rate, e.bodies = {0};
  e.start = Eigen::MatrixXd::Zero(12, 12);
  e.model.step = 0.001;
  core::Scene& scene = e.model.scene;
  core::Body block;
  block.name = "block", block.mass = 0.4, block.collide = true;
  block.shape = core::Box{core::Vector3::Constant(half)};
  block.initial.position = {0, table + half + top, 0}, block.initial.velocity = {along, 0, 0};
  scene.bodies = {block};
  scene.planes = {core::Plane{.name = "table", .normal = core::Vector3::UnitY(), .offset = table}};
  scene.forces = {core::UniformGravity{}};
  scene.materials = {core::Material{{"block", "table"}, restitution, 0}};
  const auto every = static_cast<std::int64_t>(std::lround(1 / (rate * e.model.step)));
  e.runs = {{"0", bounces(scene, e.model.step, 1500, every).states}};
  return e;
}

TEST(Touches, LoseWhatTheRestitutionTakes) {
  const Experiment e = measured_with(0.6);
  const std::vector<double> losses = losses_of_touches(e, e.runs[0].states);
  ASSERT_GE(losses.size(), 3u);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(losses[static_cast<std::size_t>(k)], 1 - energy_after(k + 1, 0.6) / energy_after(k, 0.6),
                1e-9)
        << k;
}

TEST(Touches, AreComparedOneByOne) {
  Experiment e = measured_with(0.6);
  for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(score(e, 0, bounces, {.members = 0}).touch_losses.at(k), 0);
  e.model.scene.materials[0].restitution = 0.5;
  const std::vector<double> off = score(e, 0, bounces, {.members = 0}).touch_losses;
  ASSERT_GE(off.size(), 2u);
  for (int k = 0; k < 2; ++k)
    EXPECT_NEAR(
        off[static_cast<std::size_t>(k)],
        energy_after(k + 1, 0.6) / energy_after(k, 0.6) - energy_after(k + 1, 0.5) / energy_after(k, 0.5),
        1e-9)
        << k;
}

// The prediction has no flight after its first touch, so that it says nothing of the loss in it.
TEST(Touches, WithoutAFlightAfterThemAreNotCompared) {
  Experiment e = measured_with(0.6);
  EXPECT_EQ(touch_counts(e)[0].known, 1u);
  e.model.scene.materials[0].restitution = 0;
  EXPECT_TRUE(score(e, 0, bounces, {.members = 0}).touch_losses.empty());
  EXPECT_TRUE(touch_counts(measured_with(0)).empty());
}

// A flight too short for its energy is counted, and its loss is not known: of a small bounce, or at 25 frames a second.
TEST(Touches, OfShortFlightsTellNoLoss) {
  for (const Experiment& e : {measured_with(0.105), measured_with(0.3, 25)}) {
    const auto counts = touch_counts(e);
    ASSERT_FALSE(counts.empty());
    EXPECT_EQ(counts[0].flights, 1u);
    EXPECT_EQ(counts[0].known, 0u);
    EXPECT_TRUE(std::isnan(losses_of_touches(e, e.runs[0].states)[0]));
  }
}

// Smoothing spreads a touch over the frames beside it, which do not count: two on each side, and no more.
TEST(Touches, DoNotSeeTheFramesBesideThem) {
  const Experiment e = measured_with(0.6);
  const double clear = losses_of_touches(e, e.runs[0].states)[0];
  const auto first = static_cast<std::size_t>(std::ceil(first_touch(e, e.runs[0].states)->time * e.rate));
  const auto shaken = [&](std::size_t frames) {
    std::vector<core::State> states = e.runs[0].states;
    for (std::size_t i = first - frames; i < first; ++i) states[i][0].velocity *= 0.8;
    return losses_of_touches(e, states)[0];
  };
  EXPECT_EQ(shaken(2), clear);
  EXPECT_NE(shaken(3), clear);
}

// The median over the runs that have one, touch by touch.
TEST(Touches, AreSummedUpByTheirPlaceInARun) {
  std::vector<RunScore> runs(3);
  runs[0].touch_losses = {0.1, not_known};
  runs[1].touch_losses = {0.3, 0.5};
  runs[2].touch_losses = {0.2};
  const Summary s = summary(runs);
  ASSERT_EQ(s.touch_losses.size(), 2u);
  EXPECT_EQ(s.touch_losses[0].value, 0.2);
  EXPECT_EQ(s.touch_losses[0].runs, 3u);
  EXPECT_EQ(s.touch_losses[1].value, 0.5);
  EXPECT_EQ(s.touch_losses[1].runs, 1u);
}

}  // namespace
}  // namespace cylon::validation
