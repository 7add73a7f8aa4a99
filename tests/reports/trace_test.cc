// What a trace keeps of a run: the ends, the worst of every stretch, the first violation.
#include "reports/trace.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace cylon::reports {
namespace {

using namespace core;

constexpr double dt = 0.01, speed = 1.75, duration = 12;

Scene thrown() {
  Scene scene;
  Body body;
  body.name = "stone";
  body.mass = 2.5;
  body.initial.position = {0.5, -0.25, 2};
  body.initial.velocity = {speed, 0.5, -0.25};
  scene.bodies = {body};
  return scene;
}

// Uniform motion, with a peak of 0.3 m in the x of one step.
Recording run(const Scene& scene, std::int64_t peak_at) {
  Recording recording;
  recording.dt = dt;
  for (std::int64_t step = 0; step <= std::llround(duration / dt); ++step) {
    State state = initial_state(scene);
    state[0].position += state[0].velocity * (static_cast<double>(step) * dt);
    if (step == peak_at) state[0].position.x() += 0.3;
    recording.steps.push_back(step);
    recording.states.push_back(state);
  }
  return recording;
}

Claim uniform_motion(const Scene& scene) {
  Claim claim;
  claim.label = "position follows uniform_motion";
  claim.follows = "uniform_motion";
  claim.truth = Truth{};
  claim.truth->state = [start = initial_state(scene)](double t) {
    State state = start;
    state[0].position += t * state[0].velocity;
    return state;
  };
  claim.truth->source = "Newton's first law";
  claim.tolerance = {.absolute = 0.125, .reason = "test"};
  return claim;
}

Claim momentum_is_kept() {
  Claim claim;
  claim.label = "linear_momentum";
  claim.observable.quantity = Quantity::linear_momentum;
  claim.tolerance = {.relative = 1e-9, .reason = "test"};
  return claim;
}

Trace traced(const Scene& scene, const std::vector<Claim>& claims, const Recording& recording,
             const TraceLimits& limits = {}) {
  std::vector<Reading> readings;
  for (const Claim& claim : claims) readings.push_back(read(claim, scene, recording, duration));
  return trace(scene, claims, readings, recording, limits);
}

TEST(Trace, KeepsBothEndsAndNoMoreThanAsked) {
  const Scene scene = thrown();
  const Recording recording = run(scene, -1);
  for (const std::size_t most : {2u, 7u, 300u, 5000u}) {
    const Trace got = traced(scene, {}, recording, {.frames = most, .points = most});
    const std::size_t n = std::min<std::size_t>(most, recording.steps.size());
    ASSERT_EQ(got.motion.time.size(), n);
    EXPECT_EQ(got.motion.states.size(), n);
    EXPECT_EQ(got.motion.time.front(), 0);
    EXPECT_EQ(got.motion.time.back(), duration);
    EXPECT_TRUE(std::is_sorted(got.motion.time.begin(), got.motion.time.end()));
    EXPECT_EQ(got.motion.states.back()[0].position, recording.states.back()[0].position);
    for (const TotalCurve& curve : got.totals) EXPECT_EQ(curve.time.size(), n) << curve.name;
  }
}

TEST(Trace, ManyBodiesGetFewerFrames) {
  Scene scene = thrown();
  scene.bodies.resize(40, scene.bodies[0]);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) scene.bodies[i].name += std::to_string(i);
  const Trace got = traced(scene, {}, run(scene, -1), {.frames_bodies = 1000});
  EXPECT_EQ(got.motion.states.size(), 25u);
}

// Thinning by a fixed stride would lose a violation of a single step.
TEST(Trace, ThinningKeepsSingleStepPeak) {
  const Scene scene = thrown();
  for (const std::int64_t peak : {1, 337, 1199}) {
    const Trace got = traced(scene, {uniform_motion(scene)}, run(scene, peak), {.points = 11});
    ASSERT_EQ(got.errors.size(), 1u);
    const ErrorCurve& curve = got.errors[0];
    EXPECT_EQ(curve.value.size(), 11u);
    const auto worst = std::max_element(curve.value.begin(), curve.value.end());
    EXPECT_NEAR(*worst, 0.3, 1e-12);
    EXPECT_EQ(curve.time[static_cast<std::size_t>(worst - curve.value.begin())],
              static_cast<double>(peak) * dt);
    ASSERT_TRUE(curve.first_violation);
    EXPECT_EQ(curve.first_violation->step, peak);
    EXPECT_NEAR(curve.first_violation->value, 0.3, 1e-12);
    EXPECT_EQ(curve.allowed, 0.125);
    EXPECT_EQ(curve.unit, "m");
  }
}

TEST(Trace, NoViolationWithinTolerance) {
  const Scene scene = thrown();
  const Trace got = traced(scene, {uniform_motion(scene), momentum_is_kept()}, run(scene, -1));
  ASSERT_EQ(got.errors.size(), 2u);
  for (const ErrorCurve& curve : got.errors) EXPECT_FALSE(curve.first_violation) << curve.claim;
}

// A NaN exceeds every tolerance, and the curve shows it.
TEST(Trace, ANumberThatIsNotFiniteIsAViolation) {
  const Scene scene = thrown();
  Recording recording = run(scene, -1);
  for (std::size_t i = 700; i < recording.states.size(); ++i) recording.states[i][0].position.y() = NAN;
  const Trace got = traced(scene, {uniform_motion(scene)}, recording, {.points = 20});
  ASSERT_TRUE(got.errors[0].first_violation);
  EXPECT_EQ(got.errors[0].first_violation->step, 700);
  EXPECT_TRUE(std::isnan(got.errors[0].value.back()));
  EXPECT_TRUE(std::isfinite(got.errors[0].value.front()));
}

TEST(Trace, OnlyTheEndCountsForAClaimAboutTheEnd) {
  const Scene scene = thrown();
  Claim claim = uniform_motion(scene);
  claim.reduction = Reduction::end;
  EXPECT_FALSE(traced(scene, {claim}, run(scene, 337)).errors[0].first_violation);
  const auto at_end = traced(scene, {claim}, run(scene, 1200)).errors[0].first_violation;
  ASSERT_TRUE(at_end);
  EXPECT_EQ(at_end->step, 1200);
}

TEST(Trace, TruthIsSampledAtFrames) {
  const Scene scene = thrown();
  const Trace got =
      traced(scene, {momentum_is_kept(), uniform_motion(scene)}, run(scene, 337), {.frames = 33});
  ASSERT_TRUE(got.ghost);
  EXPECT_EQ(got.ghost->follows, "uniform_motion");
  EXPECT_EQ(got.ghost->source, "Newton's first law");
  ASSERT_EQ(got.ghost->motion.time, got.motion.time);
  for (std::size_t i = 0; i < got.motion.time.size(); ++i)
    EXPECT_DOUBLE_EQ(got.ghost->motion.states[i][0].position.x(), 0.5 + speed * got.motion.time[i]);
  EXPECT_FALSE(traced(scene, {momentum_is_kept()}, run(scene, 337)).ghost);
}

// Beside a frame of another time the truth would seem to be off: recorded data are shown at frames of their
// times.
TEST(Trace, TruthFromRecordedDataIsAtItsTimes) {
  const Scene scene = thrown();
  Claim recorded = uniform_motion(scene);
  recorded.follows = "data";
  recorded.truth->times = {0, 0.13, 2.71, 7.77, 12};
  const Trace got = traced(scene, {recorded}, run(scene, -1), {.frames = 40});
  ASSERT_TRUE(got.ghost);
  EXPECT_EQ(got.ghost->motion.time.size(), 5u);
  EXPECT_LE(got.motion.time.size(), 40u);
  for (const double t : got.ghost->motion.time)
    EXPECT_NE(std::find(got.motion.time.begin(), got.motion.time.end(), t), got.motion.time.end()) << t;
  const Trace both = traced(scene, {recorded, uniform_motion(scene)}, run(scene, -1), {.frames = 40});
  EXPECT_EQ(both.ghost->follows, "uniform_motion") << "one that is known at any time is preferred";
  EXPECT_EQ(both.ghost->motion.time, both.motion.time);
}

// m v, and r x m v of uniform motion: both stay what they are at the start.
TEST(Trace, TotalsAgreeWithScene) {
  const Scene scene = thrown();
  const Body& body = scene.bodies[0];
  const Vector3 p = body.mass * body.initial.velocity, L = body.initial.position.cross(p);
  const Trace got = traced(scene, {}, run(scene, -1));
  std::size_t vectors = 0;
  for (const TotalCurve& curve : got.totals) {
    if (curve.component.empty()) continue;
    const int axis = curve.component[0] - 'x';
    const double want = curve.name == "momentum" ? p[axis] : L[axis];
    for (const double value : curve.value) EXPECT_NEAR(value, want, 1e-12 * L.norm()) << curve.name;
    ++vectors;
  }
  EXPECT_EQ(vectors, 6u);
}

TEST(Trace, EmptyRecordingGivesEmptyTrace) {
  const Trace got = traced(thrown(), {uniform_motion(thrown())}, Recording{});
  EXPECT_TRUE(got.motion.time.empty());
  EXPECT_FALSE(got.ghost);
  EXPECT_TRUE(got.errors[0].value.empty());
}

}  // namespace
}  // namespace cylon::reports
