// Synthetic experiments, of which the truth is known: what the scores say of a right model, and of wrong ones.
#include "harness/validation/score.h"

#include "harness/core/input_error.h"
#include "harness/validation/length_scale.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

namespace cylon::validation {
namespace {

using core::BodyState, core::Vector3, measured::Experiment;

// A world that can be written down: a cube falls without turning, stays down where it meets the table, and slides there with
// Coulomb friction.  With t' the time since the touch, s = v t' - mu g t'^2/2 until t' = v/(mu g).
core::Recording ran(const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
  const core::Body& body = scene.bodies[0];
  const double g = 9.81, mu = scene.materials[0].friction;
  const double floor = scene.planes[0].offset + std::get<core::Box>(body.shape).half_extents.y();
  const BodyState& start = body.initial;
  const double up = start.velocity.y(),
               touch = (up + std::sqrt(up * up + 2 * g * (start.position.y() - floor))) / g;
  const Vector3 along(start.velocity.x(), 0, start.velocity.z());
  core::Recording r;
  r.dt = dt;
  for (std::int64_t i = 0; i <= steps; i += every) {
    const double t = static_cast<double>(i) * dt, free = std::min(t, touch);
    const double slid = std::min(t - free, along.norm() / (mu * g + 1e-300));
    BodyState now = start;
    now.position += along * free + along.normalized() * (along.norm() * slid - mu * g * slid * slid / 2);
    now.position.y() = t < touch ? start.position.y() + up * t - g * t * t / 2 : floor;
    now.velocity = along.normalized() * (along.norm() - mu * g * slid);
    if (t < touch) now.velocity.y() = up - g * t;
    r.steps.push_back(i), r.states.push_back({now});
  }
  return r;
}

constexpr double side = 0.1;

// Tosses of a cube onto a table, in frames of 10 ms.
Experiment tosses(int count, double friction, std::uint64_t seed, double noise = 0) {
  Experiment e;
  e.rate = 100;
  e.bodies = {0};
  e.start = Eigen::MatrixXd::Zero(12, 12);
  e.model.step = 0.002;
  core::Scene& scene = e.model.scene;
  core::Body cube;
  cube.name = "cube", cube.mass = 0.4, cube.collide = true;
  cube.shape = core::Box{Vector3::Constant(side / 2)};
  scene.bodies = {cube};
  scene.planes = {core::Plane{.name = "table", .normal = Vector3::UnitY(), .offset = 0.2}};
  scene.forces = {core::UniformGravity{}};
  scene.materials = {core::Material{{"cube", "table"}, 0, friction}};
  std::mt19937_64 bits(seed);
  std::normal_distribution<double> normal(0, 1);
  const auto vector = [&](double size) -> Vector3 {
    const double x = normal(bits), y = normal(bits), z = normal(bits);
    return size * Vector3(x, y, z);
  };
  for (int i = 0; i < count; ++i) {
    core::Scene thrown = scene;
    BodyState& s = thrown.bodies[0].initial;
    s.position = {0, 0.6, 0}, s.velocity = Vector3(1, 0, 0.5) + vector(0.1);
    const core::Recording r = ran(thrown, 0.002, 500, 5);
    measured::Run run{std::to_string(i), {}};
    for (const core::State& state : r.states) {
      run.states.push_back(state);
      if (run.states.size() > 1) run.states.back()[0].position += vector(noise);
    }
    e.runs.push_back(run);
  }
  e.noise = noise;
  return e;
}

void err_in_velocity(Experiment& e, double deviation) {
  for (const Eigen::Index i : {6, 7, 8}) e.start(i, i) = deviation;
}

std::vector<RunScore> scored(const Experiment& e, const Band& band) {
  std::vector<RunScore> all;
  for (std::size_t i = 0; i < e.runs.size(); ++i) all.push_back(score(e, i, ran, band));
  return all;
}

TEST(Score, ARightModelIsExactAndAWrongOneIsNot) {
  Experiment e = tosses(6, 0.3, 1);
  for (const RunScore& run : scored(e, {.members = 0})) {
    EXPECT_EQ(run.distance, 0);
    EXPECT_LT(run.angle, 1e-7);
    EXPECT_TRUE(run.same_side);
    EXPECT_EQ(run.impact, 0);
    EXPECT_EQ(run.place, 0);
    EXPECT_EQ(run.loss, 0);
    EXPECT_TRUE(std::isnan(run.covered));
  }
  e.model.scene.materials[0].friction = 0.6;
  const Summary wrong = summary(scored(e, {.members = 0}));
  EXPECT_GT(wrong.distance.value, 0.01);
}

// What was measured lies 20 mm to the side from its second frame on, and 3 mm higher: it touches later, on its way along the table.
TEST(Score, KnowsThePlaceOfTheFirstTouch) {
  Experiment e = tosses(1, 0.3, 1);
  const BodyState start = e.runs[0].states[0][0];
  for (std::size_t i = 1; i < e.runs[0].states.size(); ++i) e.runs[0].states[i][0].position.z() += 0.02;
  EXPECT_NEAR(score(e, 0, ran, {.members = 0}).place, 0.02, 1e-12);
  EXPECT_EQ(score(e, 0, ran, {.members = 0}).impact, 0);
  for (std::size_t i = 1; i < e.runs[0].states.size(); ++i) e.runs[0].states[i][0].position.y() += 0.003;
  const RunScore higher = score(e, 0, ran, {.members = 0});
  const Vector3 way =
      -higher.impact * Vector3(start.velocity.x(), 0, start.velocity.z()) + Vector3(0, 0, 0.02);
  EXPECT_LT(higher.impact, -5e-4);
  EXPECT_NEAR(higher.place, way.norm(), 1e-3 * way.norm());
  EXPECT_EQ(summary({higher}).place.value, higher.place);
}

// The cube loses what it falls with at the touch, and friction takes the rest: with more of it, more is gone 0.1 s later.
TEST(Score, KnowsTheEnergyThatATouchTakes) {
  Experiment e = tosses(1, 0.3, 1);
  const auto kinetic = [&](double mu) {
    const BodyState& s = e.runs[0].states[0][0];
    const double g = 9.81,
                 touch = (s.velocity.y() + std::sqrt(std::pow(s.velocity.y(), 2) + 2 * g * 0.35)) / g;
    // The frame is the first after 0.1 s; 5 mm above the table counts as touching.
    const double touched = (s.velocity.y() + std::sqrt(std::pow(s.velocity.y(), 2) + 2 * g * 0.345)) / g;
    const double frame = std::ceil((touched + 0.1) * 100) / 100;
    const double along = std::hypot(s.velocity.x(), s.velocity.z());
    return std::pow(along - mu * g * (frame - touch), 2) / 2;
  };
  const double start = e.runs[0].states[0][0].velocity.squaredNorm() / 2 + 9.81 * 0.4;  // the plane is at 0.2
  e.model.scene.materials[0].friction = 0.6;
  EXPECT_NEAR(score(e, 0, ran, {.members = 0}).loss, (kinetic(0.3) - kinetic(0.6)) / start, 0.01);
}

TEST(Score, SaysWhyThereIsNoPrediction) {
  const Experiment e = tosses(3, 0.2, 1);
  const study::Runner breaks = [](const auto&...) -> core::Recording {
    process::RunOutcome outcome;
    outcome.reason = "it fell asleep";
    throw study::RunFailed{outcome};
  };
  const study::Runner lost = [](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    core::Recording r = ran(scene, dt, steps, every);
    r.states.back()[0].position.x() = std::nan("");
    return r;
  };
  EXPECT_EQ(score(e, 0, breaks, {}).failure, "it fell asleep");
  EXPECT_EQ(score(e, 0, lost, {}).failure, "the prediction is not finite");
  std::vector<RunScore> all = scored(e, {.members = 0});
  all.push_back(score(e, 0, breaks, {}));
  const Summary s = summary(all);
  EXPECT_EQ(s.failed, 1u);
  EXPECT_EQ(s.distance.runs, 3u);
  EXPECT_EQ(s.first_failure, "it fell asleep");
}

// Data whose start, friction and noise err as stated lie in the band as often as it says; those of a band that leaves friction
// out, or of a model with another one, do not.
TEST(Band, HoldsWhatItSaysOfARightModelAndNotOfAWrongOne) {
  constexpr double speed = 0.01, spread = 0.04, noise = 0.0005;
  std::mt19937_64 bits(5);
  std::normal_distribution<double> normal(0, 1);
  Experiment e;
  for (int i = 0; i < 400; ++i) {
    Experiment one = tosses(1, 0.3 + spread * normal(bits), 100 + static_cast<std::uint64_t>(i), noise);
    // What is seen of the start errs; the motion began otherwise.
    for (double& v : one.runs[0].states[0][0].velocity) v += speed * normal(bits);
    if (i == 0)
      e = one;
    else
      e.runs.push_back(one.runs[0]);
  }
  e.model.scene.materials[0].friction = 0.3;
  err_in_velocity(e, speed), e.material.friction = spread, e.noise = noise;
  const Summary right = summary(scored(e, {.members = 39}));
  EXPECT_LT(right.covered.interval.low, 0.95);
  EXPECT_GT(right.covered.interval.high, 0.95);
  EXPECT_EQ(right.band, Answer::inside) << right.covered.interval.low << " " << right.covered.interval.high;

  Experiment sure = e;
  sure.material.friction = 0;
  EXPECT_EQ(summary(scored(sure, {.members = 39})).band, Answer::outside);
  Experiment wrong = e;
  wrong.model.scene.materials[0].friction = 0.45;
  EXPECT_EQ(summary(scored(wrong, {.members = 39})).band, Answer::outside);
  Experiment timid = e;
  err_in_velocity(timid, 0.2), timid.material.friction = 0.3, timid.noise = 0.005;
  EXPECT_EQ(summary(scored(timid, {.members = 39})).band, Answer::outside);
}

// The level of the interval: of 100 such experiments of 30 tosses, it holds 95 % in 95, three standard errors down.
TEST(Band, ItsIntervalHoldsTheLevelAsOftenAsItSays) {
  constexpr double spread = 0.04;
  std::mt19937_64 bits(8);
  std::normal_distribution<double> normal(0, 1);
  int held = 0;
  for (int k = 0; k < 100; ++k) {
    Experiment e;
    for (int i = 0; i < 30; ++i) {
      const Experiment one = tosses(1, 0.3 + spread * normal(bits), bits(), 0.0005);
      if (i == 0)
        e = one;
      else
        e.runs.push_back(one.runs[0]);
    }
    e.model.scene.materials[0].friction = 0.3;
    e.material.friction = spread;
    const Summary s = summary(scored(e, {.members = 39, .seed = static_cast<std::uint64_t>(k)}));
    held += s.covered.interval.low <= 0.95 && 0.95 <= s.covered.interval.high;
  }
  EXPECT_GE(held, 87);
}

TEST(Band, IsTheSameForTheSameSeed) {
  Experiment e = tosses(2, 0.2, 9);
  err_in_velocity(e, 0.05);
  const double a = score(e, 1, ran, {.members = 7}).covered, b = score(e, 1, ran, {.members = 7}).covered;
  EXPECT_EQ(a, b);
  EXPECT_EQ(level(39), 0.95);
}

TEST(Answers, AreThree) {
  EXPECT_EQ(answer({0.91, 0.97}, 0.9, 0.98), Answer::inside);
  EXPECT_EQ(answer({0.2, 0.89}, 0.9, 0.98), Answer::outside);
  EXPECT_EQ(answer({0.985, 1}, 0.9, 0.98), Answer::outside);
  EXPECT_EQ(answer({0.85, 0.95}, 0.9, 0.98), Answer::undecided);
  EXPECT_EQ(answer({}, 0.9, 0.98), Answer::undecided);
}

TEST(Nearness, IsDecidedByTheSignTestAndHolm) {
  const auto engine = [](int runs, int worse, int failed) {
    std::vector<RunScore> all;
    for (int i = 0; i < runs; ++i) {
      RunScore run{.run = "", .failure = i < failed ? "crash" : ""};
      run.distance = i % 10 < worse ? 2 : 0.5;
      all.push_back(run);
    }
    return all;
  };
  std::vector<RunScore> first = engine(40, 0, 0);
  for (RunScore& run : first) run.distance = 1;
  const auto pairs =
      nearer({first, engine(40, 10, 0), engine(40, 5, 0), engine(40, 0, 0), engine(40, 0, 38)});
  ASSERT_EQ(pairs.size(), 4u);
  EXPECT_EQ(pairs[0].answer, Answer::inside);
  EXPECT_EQ(pairs[1].answer, Answer::undecided);
  EXPECT_EQ(pairs[2].answer, Answer::outside);
  EXPECT_EQ(pairs[3].answer, Answer::undecided);  // two runs decide nothing
  EXPECT_EQ(pairs[3].one + pairs[3].other, 2u);
  EXPECT_TRUE(nearer({first}).empty());
}

// A run without a number says nothing, and neither do runs that an engine has no number of at all.
TEST(Nearness, IsOfAnyNumberOfWhichLessIsBetter) {
  const std::vector<double> first(20, -3.0), more(20, -2.5);
  std::vector<double> few(20, not_known);
  few[0] = few[1] = -7;
  const auto pairs = better({first, more, few, {}});
  ASSERT_EQ(pairs.size(), 3u);
  EXPECT_EQ(pairs[0].answer, Answer::inside);
  EXPECT_EQ(pairs[1].answer, Answer::undecided);
  EXPECT_EQ(pairs[1].other, 2u);
  EXPECT_EQ(pairs[2].one + pairs[2].other, 0u);
}

// Lengths that are made two percent short are found by both signs; lengths that are right are not accused.
TEST(Lengths, AreFoundShortFromFlightAndFromRestSeparately) {
  for (const double scale : {1.0, 0.98}) {
    Experiment e = tosses(12, 0.3, 3);
    for (measured::Run& run : e.runs)
      for (core::State& state : run.states) {
        BodyState& s = state[0];
        s.position = Vector3(0, 0.2, 0) + scale * (s.position - Vector3(0, 0.2, 0));
        s.velocity *= scale;
      }
    const LengthScale found = length_scale(e);
    for (const Estimate& one : {found.flight, found.rest}) {
      EXPECT_GE(one.runs, 6u);
      EXPECT_NEAR(one.value, scale, 1e-3);
      EXPECT_EQ(one.interval.low <= 1 + 1e-3 && 1 - 1e-3 <= one.interval.high, scale == 1) << one.value;
    }
  }
  Experiment none = tosses(2, 0.3, 3);
  none.model.scene.planes.clear();
  EXPECT_THROW(length_scale(none), core::InputError);
}

}  // namespace
}  // namespace cylon::validation
