// Observables, reductions and judging on motions whose numbers are known by hand.
#include "harness/core/measure.h"
#include "harness/results/verdict.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace {

using namespace cylon::core;
using namespace cylon::results;
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

Body rigid(const std::string& name, double mass, const Vector3& moments) {
  Body body;
  body.name = name;
  body.mass = mass;
  body.inertia = moments.asDiagonal();
  return body;
}

// Two general bodies, a spring between their anchors, gravity.
Scene general_scene() {
  Scene scene;
  scene.bodies = {rigid("a", 1.3, {0.2, 0.3, 0.4}), rigid("b", 2.1, {0.5, 0.5, 0.7})};
  BodyState& a = scene.bodies[0].initial;
  a.position = {0.3, 1.1, -0.4};
  a.orientation = Quaternion(Eigen::AngleAxisd(0.7, Vector3(1, 2, -1).normalized()));
  a.velocity = {0.5, -0.2, 0.9};
  a.angular_velocity = {1.5, -0.7, 0.4};
  BodyState& b = scene.bodies[1].initial;
  b.position = {-0.8, 0.2, 0.6};
  b.velocity = {-0.1, 0.3, 0.2};
  b.angular_velocity = {0.2, 0.9, -1.1};
  scene.forces = {UniformGravity{{0.1, -9.81, 0.2}}, Spring{.body = 0,
                                                            .anchor = {0.1, 0.2, 0.3},
                                                            .to = 1,
                                                            .to_anchor = {0, -0.1, 0.2},
                                                            .stiffness = 40,
                                                            .rest_length = 0.5}};
  return scene;
}

double value(const Observable& q, const Scene& scene, const State& state) {
  Values values;
  evaluate(q, scene, state, values);
  return values.at(0).x();
}

TEST(Observable, EnergyIsTheSumOfItsTerms) {
  const Scene scene = general_scene();
  const State state = initial_state(scene);
  double expected = 0;
  for (std::size_t i = 0; i < 2; ++i) {
    const Body& body = scene.bodies[i];
    const BodyState& s = state[i];
    const Matrix3 inertia = world_inertia(body, s.orientation);
    expected += 0.5 * body.mass * s.velocity.squaredNorm() +
                0.5 * s.angular_velocity.dot(inertia * s.angular_velocity);
    expected -= body.mass * Vector3(0.1, -9.81, 0.2).dot(s.position);
  }
  const Vector3 from = state[0].position + state[0].orientation * Vector3(0.1, 0.2, 0.3);
  const Vector3 to = state[1].position + state[1].orientation * Vector3(0, -0.1, 0.2);
  expected += 20 * std::pow((to - from).norm() - 0.5, 2);
  EXPECT_NEAR(value({.quantity = Quantity::energy}, scene, state), expected, 1e-12);
}

TEST(Observable, AngularMomentumDependsOnItsPoint) {
  const Scene scene = general_scene();
  const State state = initial_state(scene);
  Values origin, shifted, momentum;
  const Vector3 about(0.4, -1.2, 2.2);
  evaluate({.quantity = Quantity::angular_momentum}, scene, state, origin);
  evaluate({.quantity = Quantity::angular_momentum, .about = about}, scene, state, shifted);
  evaluate({.quantity = Quantity::linear_momentum}, scene, state, momentum);
  const Vector3 difference = (origin[0] - shifted[0]).head<3>();
  EXPECT_LT((difference - about.cross(Vector3(momentum[0].head<3>()))).norm(), 1e-13);
}

TEST(Distance, OrientationDistanceIgnoresSign) {
  const Observable q{.quantity = Quantity::orientation};
  const auto of = [](const Quaternion& r) { return Values{{r.w(), r.x(), r.y(), r.z()}}; };
  const Quaternion r(Eigen::AngleAxisd(1.1, Vector3(1, 2, 3).normalized()));
  for (const double angle : {1e-9, 0.3, 2.0, 3.1}) {
    Quaternion s = Quaternion(Eigen::AngleAxisd(angle, Vector3(-2, 1, 1).normalized())) * r;
    EXPECT_NEAR(distance(q, of(r), of(s)), angle, 1e-14 + 1e-7 * (angle > 3)) << angle;
    s.coeffs() = -s.coeffs();
    EXPECT_NEAR(distance(q, of(r), of(s)), angle, 1e-14 + 1e-7 * (angle > 3)) << angle;
  }
}

TEST(Distance, PropagatesNaN) {
  for (const Quantity quantity :
       {Quantity::position, Quantity::orientation, Quantity::axis, Quantity::energy}) {
    const Observable q{.quantity = quantity};
    const Values good = {{1, 0, 0, 0}, {0, 1, 0, 0}}, first = {{nan, 0, 0, 0}, {0, 1, 0, 0}},
                 last = {{1, 0, 0, 0}, {0, nan, 0, 0}};
    EXPECT_EQ(distance(q, good, good), 0);
    EXPECT_TRUE(std::isnan(distance(q, first, good))) << name(quantity);
    EXPECT_TRUE(std::isnan(distance(q, last, good))) << name(quantity);
  }
}

TEST(SymmetryAxis, IsThatOfTheDistinctMoment) {
  EXPECT_EQ(*symmetry_axis(rigid("", 1, {2, 1, 2})), Vector3::UnitY());
  EXPECT_EQ(*symmetry_axis(rigid("", 1, {1, 1, 2})), Vector3::UnitZ());
  EXPECT_FALSE(symmetry_axis(rigid("", 1, {1, 2, 3})));
  EXPECT_FALSE(symmetry_axis(rigid("", 1, {2, 2, 2})));
}

TEST(Gap, OfEveryShapeToTiltedPlane) {
  const Vector3 normal = Vector3(1, 2, -0.5).normalized();
  struct Row {
    const char* what;
    Shape shape;
    double reach;  // of the turned shape towards -normal, by brute force below where 0
  };
  const Quaternion turn(Eigen::AngleAxisd(0.8, Vector3(-1, 0.4, 2).normalized()));
  const auto brute = [&](auto points) {
    double reach = 0;
    for (const Vector3& p : points) reach = std::max(reach, -normal.dot(turn * p));
    return reach;
  };
  std::vector<Vector3> box, cylinder, cone;
  for (int i = 0; i < 8; ++i) box.emplace_back(i & 1 ? 0.3 : -0.3, i & 2 ? 0.5 : -0.5, i & 4 ? 0.2 : -0.2);
  for (int i = 0; i < 20000; ++i) {
    const double t = i * 2 * M_PI / 20000, c = std::cos(t), s = std::sin(t);
    cylinder.emplace_back(0.4 * c, 0.6, 0.4 * s);
    cylinder.emplace_back(0.4 * c, -0.6, 0.4 * s);
    cone.emplace_back(0.4 * c, -0.3, 0.4 * s);
  }
  cone.emplace_back(0, 0.9, 0);
  const std::vector<Row> rows = {
      {"sphere", Sphere{0.7}, 0.7},
      {"box", Box{{0.3, 0.5, 0.2}}, brute(box)},
      {"hull", Hull{box}, brute(box)},
      {"cylinder", Cylinder{0.4, 1.2}, brute(cylinder)},
      {"cone", Cone{0.4, 1.2}, brute(cone)},
      {"capsule", Capsule{0.4, 1.2}, 0.4 + brute(std::vector<Vector3>{{0, 0.6, 0}, {0, -0.6, 0}})},
      {"rod", Rod{1.2}, brute(std::vector<Vector3>{{0, 0.6, 0}, {0, -0.6, 0}})}};
  for (const Row& row : rows) {
    Scene scene;
    scene.bodies.resize(1);
    scene.bodies[0].shape = row.shape;
    scene.planes = {{.name = "p", .normal = normal, .offset = 0.25}};
    State state = initial_state(scene);
    state[0].position = {1, 2, 3};
    state[0].orientation = turn;
    EXPECT_NEAR(gap(scene, {0, world, 0}, state), normal.dot(Vector3(1, 2, 3)) - 0.25 - row.reach, 1e-7)
        << row.what;
  }
}

// ---- Reductions --------------------------------------------------------------------------------

// x(t) = 1 + t^2 recorded every 0.5 s, judged against x = 1: deviation t^2.
struct Parabola {
  Scene scene;
  Recording recording;
  Claim claim;
  Parabola() {
    scene.bodies = {rigid("a", 1, {1, 1, 1})};
    scene.bodies[0].initial.position = {1, 0, 0};
    recording.dt = 0.5;
    for (int n = 0; n <= 4; ++n) {
      State state = initial_state(scene);
      state[0].position.x() += 0.25 * n * n;
      recording.steps.push_back(n);
      recording.states.push_back(state);
    }
    claim.tolerance = {.absolute = 1, .reason = "test"};
  }
  Measured measured() const { return measure(claim, scene, {&recording, 1}, 2); }
};

TEST(Measure, EachReductionOfAKnownSeries) {
  struct Row {
    Reduction reduction;
    double expected;
  };
  // Deviations 0, .25, 1, 2.25, 4 at 0, .5, 1, 1.5, 2.
  for (const Row& row :
       {Row{Reduction::max, 4}, Row{Reduction::end, 4},
        Row{Reduction::mean_square, (0 + 0.0625 + 1 + 5.0625) * 0.5 / 2}, Row{Reduction::rate, 2}}) {
    Parabola p;
    p.claim.reduction = row.reduction;
    EXPECT_NEAR(p.measured().value, row.expected, 1e-14) << name(row.reduction);
  }
}

// What is missing of the least change, and by when: |x - 1| is 1 at 1 s and 4 at 2 s.
TEST(Measure, LeastChangeMeasuresWhatIsMissing) {
  struct Row {
    double at_least, until, missing;
  };
  for (const Row& row : {Row{4, 2, 0}, Row{5, 2, 1}, Row{1, 1, 0}, Row{1.25, 1, 0.25}, Row{1, 0.9, 0},
                         Row{0.25, 0.1, 0}, Row{0.5, 0.1, 0.25}}) {
    Parabola p;
    p.claim.at_least = row.at_least;
    p.claim.reduction = Reduction::end;
    p.claim.until = row.until;
    EXPECT_NEAR(p.measured().value, row.missing, 1e-15) << row.at_least << " by " << row.until;
  }
}

TEST(Measure, LeastChangeKeepsTheLargestOne) {
  Parabola p;
  p.claim.at_least = 3;
  p.claim.reduction = Reduction::end;
  p.recording.states[4] = p.recording.states[0];  // it comes back
  EXPECT_NEAR(p.measured().value, 0.75, 1e-15);
  p.recording.states[2][0].position.x() = nan;
  EXPECT_TRUE(std::isnan(p.measured().value));
}

// x = 1, 1.25, 2, 3.25, 5, and then as the row says.
TEST(Measure, OneSidedClaimsSeeOneDirection) {
  struct Row {
    double third, last, rise, fall;
  };
  for (const Row& row : {Row{2, 5, 4, 0}, Row{0.5, 0.75, 2.25, 0.5}, Row{2, 3, 2.25, 0},
                         Row{3.5, 1.5, 2.5, 1.75}, Row{-1, -2, 2.25, 3}, Row{nan, 5, nan, nan}}) {
    Parabola p;
    p.claim.observable.component = Component::x;
    p.recording.states[2][0].position.x() = row.third;
    p.recording.states[4][0].position.x() = row.last;
    p.claim.reduction = Reduction::increase;
    const double rise = p.measured().value;
    p.claim.reduction = Reduction::decrease;
    const double fall = p.measured().value;
    if (std::isnan(row.rise)) {
      EXPECT_TRUE(std::isnan(rise) && std::isnan(fall));
      continue;
    }
    EXPECT_NEAR(rise, row.rise, 1e-15) << row.third << ' ' << row.last;
    EXPECT_NEAR(fall, row.fall, 1e-15) << row.third << ' ' << row.last;
  }
}

// A blow that ends in one step and its rebound in the next: Havok was accused of energy from nowhere.
TEST(Measure, OneSidedClaimsLeaveOutWhatLastsOneStep) {
  struct Row {
    std::vector<double> x;
    double rise;
  };
  for (const Row& row :
       {Row{{1, 0, 1, 1, 1}, 0}, Row{{1, 0, 0, 1, 1}, 1}, Row{{1, 0, 1.5, 1, 1}, 0.5},
        Row{{1, 0, 0.7, 0, 0.7}, 0}, Row{{1, 0.6, 0.5, 0.8, 0.9}, 0.3}, Row{{1, 0.2, 0.4, 0.4, 0.9}, 0.5}}) {
    Parabola p;
    p.claim.observable.component = Component::x;
    p.claim.reduction = Reduction::increase;
    for (std::size_t i = 0; i < row.x.size(); ++i) p.recording.states[i][0].position.x() = row.x[i];
    EXPECT_NEAR(p.measured().value, row.rise, 1e-15) << testing::PrintToString(row.x);
  }
}

// Of samples ten steps apart nobody knows how long a value lasted: each counts.
TEST(Measure, OneSidedClaimsOfSparseSamplesCountEach) {
  Parabola p;
  p.claim.observable.component = Component::x;
  p.claim.reduction = Reduction::increase;
  const double x[] = {1, 0, 1, 1, 1};
  for (std::size_t i = 0; i < 5; ++i) {
    p.recording.steps[i] *= 10;
    p.recording.states[i][0].position.x() = x[i];
  }
  EXPECT_NEAR(p.measured().value, 1, 1e-15);
}

// The start counts, whatever the run says that it was.
TEST(Measure, OneSidedClaimsStartWithTheScene) {
  Parabola p;
  p.claim.observable.component = Component::x;
  p.claim.reduction = Reduction::increase;
  for (State& state : p.recording.states) state[0].position.x() = 1.5;
  EXPECT_NEAR(p.measured().value, 0.5, 1e-15);
}

TEST(Measure, CountsEvents) {
  Parabola p;
  p.claim.observable = {.quantity = Quantity::event, .event_quantity = EventQuantity::count};
  const auto events = [](int count) {
    std::vector<Event> result;
    for (int i = 1; i <= count; ++i) result.push_back({.pair = {0, world, 0}, .index = i, .time = 0.1 * i});
    return result;
  };
  p.claim.follows = "test";
  p.claim.truth = Truth{.events = events(3)};
  p.claim.tolerance = {.reason = "test"};
  for (const int came : {0, 2, 3, 7}) {
    p.recording.events = events(came);
    EXPECT_EQ(p.measured().value, std::abs(came - 3)) << came;
    EXPECT_EQ(p.measured().detail.empty(), came == 3);
  }
  p.claim.until = 0.25;  // two are expected by then
  EXPECT_EQ(p.measured().value, 0);
  p.recording.events = events(1);
  EXPECT_EQ(p.measured().value, 1);
}

TEST(Measure, HonoursHorizonAndSampling) {
  Parabola p;
  p.claim.until = 1.0;
  EXPECT_NEAR(p.measured().value, 1, 1e-15);
  p.claim.until = std::numeric_limits<double>::infinity();
  p.claim.sample = 1.0;
  EXPECT_EQ(deviation(p.claim, p.scene, p.recording).time, (std::vector<double>{0, 1, 2}));
}

TEST(Measure, AllowsAbsolutePlusRelativeOfTheScale) {
  Parabola p;
  p.claim.tolerance = {.absolute = 0.5, .relative = 0.25, .reason = "test"};
  EXPECT_NEAR(p.measured().allowed, 0.75, 1e-15);
}

TEST(Measure, ReportsFirstNonFiniteStep) {
  Parabola p;
  EXPECT_EQ(first_bad_step(p.recording), std::nullopt);
  p.recording.states[3][0].position.x() = 1e308;  // large is not broken
  p.recording.states[3][0].position.y() = 1e308;
  EXPECT_EQ(first_bad_step(p.recording), std::nullopt);
  p.recording.states[2][0].velocity.y() = nan;
  EXPECT_EQ(first_bad_step(p.recording), 2);
  p.recording.states[1][0].orientation.z() = std::numeric_limits<double>::infinity();
  EXPECT_EQ(first_bad_step(p.recording), 1);
  p.recording.states[1][0].position.y() = nan;
  EXPECT_TRUE(std::isnan(p.measured().value));
  EXPECT_EQ(judge(p.measured().value, 1), Status::non_finite);
}

// A tolerance C dt^p T checks the order too: errors that do not fall are caught though small.
TEST(Measure, ChecksValueAndOrderOfAnOrderTolerance) {
  struct Row {
    double exponent, constant;
    bool broken, within;
  };
  for (const Row& row : {Row{2, 1.1, false, true}, Row{2, 0.9, false, false}, Row{1, 1.1, true, false},
                         Row{0, 1.1, true, false}}) {
    std::vector<Recording> runs;
    Parabola p;
    p.claim.tolerance = {.order = true, .constant = row.constant, .reason = "test"};
    for (const double dt : {0.5, 0.25, 0.125}) {
      Recording run;
      run.dt = dt;
      run.terms.order = 2;
      run.steps = {0, static_cast<std::int64_t>(2 / dt)};
      run.states = {initial_state(p.scene), initial_state(p.scene)};
      run.states[1][0].position.x() += 2 * std::pow(dt, row.exponent);  // T = 2
      runs.push_back(run);
    }
    const Measured m = measure(p.claim, p.scene, runs, 2);
    EXPECT_EQ(m.broken, row.broken) << row.exponent << ' ' << m.detail;
    EXPECT_EQ(m.value <= m.allowed, row.within) << row.exponent << ' ' << row.constant;
  }
}

// Errors that do not fall are forgiven where rounding explains them: at 1e-9 in single precision, not in
// double.
TEST(Measure, KnowsTheRoundingFloorOfThePrecision) {
  for (const bool single : {false, true}) {
    std::vector<Recording> runs;
    Parabola p;
    p.claim.tolerance = {.order = true, .reason = "test", .constants = {{1, 1e-3}}};
    for (const double dt : {0.5, 0.25, 0.125}) {
      Recording run;
      run.dt = dt;
      run.engine.precision = single ? "float" : "double";
      run.terms.order = 2;
      run.steps = {0, static_cast<std::int64_t>(2 / dt)};
      run.states = {initial_state(p.scene), initial_state(p.scene)};
      run.states[1][0].position.x() += 1e-9;
      runs.push_back(run);
    }
    const Measured m = measure(p.claim, p.scene, runs, 2);
    EXPECT_EQ(m.broken, !single) << m.detail;
    EXPECT_EQ(m.detail.find("rounding floor") != std::string::npos, single) << m.detail;
    EXPECT_NE(m.detail.find("held to order 1"), std::string::npos) << m.detail;
    EXPECT_LE(m.value, m.allowed);
  }
}

// 100 eps of what is rounded: a given size, the largest value claimed, or a radian.
TEST(Measure, CountsRoundingsOfTheEnginesPrecision) {
  Parabola p;
  const auto allowed_for = [&](const char* precision) {
    p.recording.engine.precision = precision;
    return p.measured().allowed;
  };
  p.claim.tolerance = {.absolute = 1e-15, .reason = "test", .roundings = 100, .size = 6};
  EXPECT_DOUBLE_EQ(allowed_for("double"), 1e-15 + 600 * 0x1p-52);
  EXPECT_DOUBLE_EQ(allowed_for("float"), 1e-15 + 600 * 0x1p-23);
  p.scene.bodies[0].initial.velocity = {3, 0, -4}, p.scene.bodies[0].mass = 2;
  p.claim.observable.quantity = Quantity::linear_momentum;
  p.claim.tolerance = {.reason = "test", .roundings = 100};
  EXPECT_DOUBLE_EQ(allowed_for("double"), 1000 * 0x1p-52);
  EXPECT_DOUBLE_EQ(allowed_for("float"), 1000 * 0x1p-23);
  p.claim.observable.quantity = Quantity::orientation;
  EXPECT_DOUBLE_EQ(allowed_for("double"), 100 * 0x1p-52);
  EXPECT_DOUBLE_EQ(allowed_for("float"), 100 * 0x1p-23);
}

TEST(ObservedOrder, IsTheSlope) {
  const double dt[] = {0.1, 0.05, 0.025}, error[] = {3e-3, 3e-3 / 16, 3e-3 / 256};
  EXPECT_NEAR(observed_order(dt, error), 4, 1e-12);
}

TEST(Judge, AcceptsValuesUpToTheBound) {
  EXPECT_EQ(judge(1.0, 1.0), Status::pass);
  EXPECT_EQ(judge(std::nextafter(1.0, 2), 1.0), Status::low_quality);
  EXPECT_EQ(judge(10.0, 1.0), Status::low_quality);
  EXPECT_EQ(judge(10.1, 1.0), Status::fail);
  EXPECT_EQ(judge(nan, 1.0), Status::non_finite);
  EXPECT_EQ(judge(std::numeric_limits<double>::infinity(), 1.0), Status::non_finite);
  EXPECT_EQ(judge(0, 0), Status::pass);
  for (int i = 0; i <= static_cast<int>(Status::protocol); ++i)
    EXPECT_EQ(status_from(name(static_cast<Status>(i))), static_cast<Status>(i));
  EXPECT_FALSE(status_from("passed"));
}

TEST(Judge, DecidesNothingWhereAnIntervalHoldsTheBound) {
  const auto of = [](double low, double high) { return judge(Bounds{low, high}, 1.0); };
  EXPECT_EQ(of(0, 1.0), Status::pass);
  EXPECT_EQ(of(0.9, std::nextafter(1.0, 2)), Status::undecided);
  EXPECT_EQ(of(1.0, 50), Status::undecided);
  EXPECT_EQ(of(std::nextafter(1.0, 2), 1.1), Status::fail) << "never low-quality";
  EXPECT_EQ(of(0, std::numeric_limits<double>::infinity()), Status::non_finite);
  EXPECT_EQ(of(nan, nan), Status::non_finite);
}

TEST(Steps, MustFillTheDuration) {
  EXPECT_EQ(whole_steps(0.8, 1.0 / 60), 48);
  EXPECT_EQ(whole_steps(60, 1e-4), 600000);
  EXPECT_THROW(whole_steps(1, 0.3), std::invalid_argument);
  EXPECT_THROW(whole_steps(1, 2), std::invalid_argument);
  EXPECT_THROW(whole_steps(1, 0), std::invalid_argument);
  EXPECT_THROW(whole_steps(1, -0.1), std::invalid_argument);
  EXPECT_THROW(whole_steps(1, nan), std::invalid_argument);
  EXPECT_EQ(sampling_stride(1, 1000000, 1e-3, 0), 1);
  EXPECT_EQ(sampling_stride(1000, 5000, 1e-3, 0), 25);
  EXPECT_EQ(sampling_stride(1, 600, 1.0 / 60, 0.1), 6);
}

}  // namespace
