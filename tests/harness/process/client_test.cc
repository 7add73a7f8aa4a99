// Answers of correct workers, including the documented example of a foreign engine.
#include "tests/harness/process/fixture.h"

#include "harness/core/input_error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

using core::Vector3;
using results::Status;

const Limits limits = {20, 30, std::size_t{2} << 30};

TEST(Client, KeepsFirstEveryNthRequestedAndLastState) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 107, 25);
  request.at = {60, 3, 0, 50, 3, 61};
  const RunOutcome outcome = run(scripted("good"), request, limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  const core::Recording& recording = *outcome.recording;
  EXPECT_EQ(recording.steps, (std::vector<std::int64_t>{0, 3, 25, 50, 60, 61, 75, 100, 107}));
  ASSERT_EQ(recording.states.size(), recording.steps.size());
  for (std::size_t i = 0; i < recording.steps.size(); ++i)
    for (std::size_t b = 0; b < 2; ++b) {
      const core::BodyState& start = scene.bodies[b].initial;
      const Vector3 exact = start.position + start.velocity * recording.time(i);
      // The script's own product of t and v, in doubles: a rounding or two.
      EXPECT_LE((recording.states[i][b].position - exact).norm(), 4e-15) << "step " << recording.steps[i];
      EXPECT_EQ(recording.states[i][b].velocity, start.velocity);
    }
  EXPECT_EQ(recording.engine.name, "scripted");
  EXPECT_EQ(recording.terms.integrator, "uniform");
  EXPECT_DOUBLE_EQ(recording.cpu_seconds, 107e-6);  // the script claims a microsecond per step
  EXPECT_TRUE(recording.events.empty());
}

TEST(Client, OnlyRepetitionsAreTimed) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 107, 25);
  const RunOutcome once = run(scripted("good"), request, limits);
  request.repetitions = 3;
  const RunOutcome thrice = run(scripted("good"), request, limits);
  ASSERT_EQ(thrice.status, Status::pass) << thrice.reason;
  EXPECT_TRUE(once.repetitions.empty());
  ASSERT_EQ(thrice.repetitions.size(), 3u);
  for (const Repetition& r : thrice.repetitions) {
    EXPECT_DOUBLE_EQ(r.step_seconds, 107e-6);  // the script claims a microsecond per step
    EXPECT_EQ(r.load_seconds, 0);              // and says nothing of its load
  }
  EXPECT_EQ(thrice.recording->steps, once.recording->steps);
  EXPECT_EQ(thrice.recording->states.back()[1].position, once.recording->states.back()[1].position);
}

TEST(Client, ZeroStepsGiveInitialStateOnly) {
  const core::Scene scene = two_bodies();
  const RunOutcome outcome = run(scripted("good"), request_of(scene, 0), limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  EXPECT_EQ(outcome.recording->steps, std::vector<std::int64_t>{0});
}

TEST(Client, ImpossibleSetupIsInputError) {
  const core::Scene scene = two_bodies();
  EngineChoice choice = scripted("good");
  choice.options["gyro"] = "none";
  try {
    run(choice, request_of(scene, 1), limits);
    FAIL();
  } catch (const core::InputError& error) {
    EXPECT_STREQ(error.what(), "engine 'test': unknown option 'gyro'");
  }
  EXPECT_FALSE(has_children());
}

TEST(Client, RejectsRequestsOutOfRange) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 10);
  request.at = {11};
  EXPECT_THROW(run(scripted("good"), request, limits), std::invalid_argument);
  EXPECT_THROW(run(scripted("good"), request_of(scene, 10, 0), limits), std::invalid_argument);
  EXPECT_THROW(run(scripted("good"), request_of(scene, -1), limits), std::invalid_argument);
}

TEST(Client, DescribesAnEngine) {
  EXPECT_EQ(describe(scripted("good"), limits).name, "scripted");
  const core::Engine example = describe(python("docs/examples/foreign_engine.py"), limits);
  ASSERT_EQ(example.integrators.size(), 1u);
  EXPECT_EQ(example.integrators[0].name, "verlet");
  EXPECT_EQ(example.integrators[0].order, 2);
  try {
    describe(scripted("abort_in_hello"), limits);
    FAIL();
  } catch (const Failure& failure) {
    EXPECT_EQ(failure.status, Status::crash);
  }
  EXPECT_FALSE(has_children());
}

// 20 MB of scene go down while the worker has not read a byte, and 2 MB states come up.
TEST(Client, LargeSceneDoesNotBlock) {
  core::Scene scene;
  for (int i = 0; i < 20000; ++i)
    scene.bodies.push_back(
        point("body" + std::to_string(i), {0.1 * i, 1.0 / (i + 1), 3}, {1.0 / 3, 0, -0.7}));
  const RunOutcome outcome = run(scripted("good"), request_of(scene, 2), limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  EXPECT_EQ(outcome.recording->states.back().size(), 20000u);
  EXPECT_EQ(outcome.recording->states[0][19999].position, scene.bodies[19999].initial.position);
}

// ---- The worked example of docs/protocol.md ------------------------------------------------------

const char* const example = "docs/examples/foreign_engine.py";

// x = x0 + v0 t + g t^2/2, on which velocity Verlet makes no error but rounding.
TEST(ForeignEngine, FliesTheParabola) {
  core::Scene scene;
  scene.bodies = {point("shot", {0.5, 2, -1}, {12, 9, -3.5})};
  const Vector3 g = {0.3, -9.81, 0.1};
  scene.forces.emplace_back(core::UniformGravity{g});
  const RunOutcome outcome = run(python(example), request_of(scene, 200, 10), limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason << outcome.stderr_tail;
  const core::Recording& recording = *outcome.recording;
  ASSERT_EQ(recording.steps.size(), 21u);
  double worst = 0;
  for (std::size_t i = 0; i < recording.steps.size(); ++i) {
    const double t = recording.time(i);
    const Vector3 exact =
        scene.bodies[0].initial.position + scene.bodies[0].initial.velocity * t + 0.5 * t * t * g;
    worst = std::max(worst, (recording.states[i][0].position - exact).norm());
  }
  EXPECT_LE(worst, 2e-13);  // rounding: 200 steps at 25 m, ulp 3.6e-15; measured 2.6e-14
  EXPECT_GT(recording.cpu_seconds, 0);
}

// A mass on a spring of length zero: x = x0 cos(w t) with w^2 = k/m; Verlet's error falls as dt^2.
TEST(ForeignEngine, SwingsWithOrderTwo) {
  core::Scene scene;
  scene.bodies = {point("bob", {1, 0, 0}, {0, 0, 0})};
  scene.bodies[0].mass = 2;
  scene.forces.emplace_back(core::Spring{0, Vector3::Zero(), core::world, Vector3::Zero(), 8.0, 0.0, 0.0});
  const auto error = [&](double dt, std::int64_t steps) {
    RunRequest request = request_of(scene, steps, steps);
    request.setup.dt = dt;
    const RunOutcome outcome = run(python(example), request, limits);
    EXPECT_EQ(outcome.status, Status::pass) << outcome.reason << outcome.stderr_tail;
    return std::abs(outcome.recording->states.back()[0].position.x() - std::cos(2.0 * 2.0));
  };
  const double order = std::log2(error(0.02, 100) / error(0.01, 200));
  EXPECT_NEAR(order, 2, 0.01);
}

// The harness watches where the worker cannot: a bounce of a body that turns round at a plane by a spring
// would not be one, so the scripted engine's uniform motion must give none, and the states asked for all the
// same.
TEST(ForeignEngine, HarnessFindsEventsForIt) {
  core::Scene scene = two_bodies();
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.1}, body.collide = true;
  scene.planes = {{"floor", Vector3::UnitY(), -10}};
  RunRequest request = request_of(scene, 90, 40);
  request.watch = {{0, core::world, 0}};
  const RunOutcome outcome = run(scripted("good"), request, limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  EXPECT_EQ(outcome.recording->steps, (std::vector<std::int64_t>{0, 40, 80, 90}));
  for (const core::Event& event : outcome.recording->events) EXPECT_NE(event.kind, core::EventKind::bounce);
}

TEST(ForeignEngine, ReportsUnsupportedScenes) {
  core::Scene scene = two_bodies();
  scene.bodies[1].collide = true;
  const RunOutcome outcome = run(python(example), request_of(scene, 1), limits);
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_EQ(outcome.reason, "no contacts, but 'b' collides");
  RunRequest request = request_of(scene, 1);
  request.setup.integrator = "rk4";
  EXPECT_THROW(run(python(example), request, limits), core::InputError);
}

}  // namespace
}  // namespace cylon::process
