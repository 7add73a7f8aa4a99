// Integrator auto: its error bound holds against closed forms, and it reports where it cannot hold.
#include "engine/verified_stepper.h"
#include "tests/engine/fixtures.h"

#include <limits>
#include <memory>

namespace cylon::engine {
namespace {

Options automatic(Real tolerance, Time dt) {
  return {.integrator = "auto", .dt = dt, .tolerance = tolerance};
}

// With drag on the point: without, the plan knows a closed form.
constexpr double mass = 1.3, decay = 0.05;  // [kg], [1/s]

Model spring() {
  Model model;
  add_body(model, make_body(mass, Matrix3::Zero()), {1.2, 0.7, 0.1}, {0, 0, 0}, {-0.3, 1.1, 0.7}, {0, 0, 0});
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0, 0, 0}, 17.0, 0, 0});
  model.forces.drags.push_back({0, 2 * mass * decay, 0, 0});
  return model;
}

// A spinning body with drag on its spin alone: L = L0 e^-ct, and a turn that is the free one at another time.
Model dragged_top() {
  Model model = free_top();
  model.forces.drags.push_back({0, 0, 0, 0.7});
  return model;
}

class Bound : public testing::TestWithParam<double> {};

TEST_P(Bound, IsKeptOnASpring) {
  const Real tolerance = GetParam(), w = std::sqrt(17.0 / mass - decay * decay);
  const Vector3 p0 = {1.2, 0.7, 0.1}, v0 = {-0.3, 1.1, 0.7};
  const Real length = p0.norm(), speed = length * w;  // the scales, which the motion reaches and passes
  Real worst = 0;
  const Outcome end = run(spring(), automatic(tolerance, 0.1), 200, [&](const World& world) {
    const Real t = world.time();
    const Vector3 a = (v0 + decay * p0) / w;
    const Vector3 p = std::exp(-decay * t) * (p0 * std::cos(w * t) + a * std::sin(w * t)),
                  v = std::exp(-decay * t) * w * (a * std::cos(w * t) - p0 * std::sin(w * t)) - decay * p;
    const Motion& m = world.motions()[0];
    worst = std::max({worst, (m.position - p).norm() / length, (m.momentum / mass - v).norm() / speed});
  });
  // 20 s are 72 rad: rounding alone makes 72 x 1e-16 x a few dozen steps
  EXPECT_LT(worst, std::max(tolerance, 2e-13));
  // a step of 2e-14, the finest, a hundred times over is what 1e-12 may not always bear
  EXPECT_TRUE(end.remarks.empty() || tolerance < 1e-11);
}

TEST_P(Bound, IsKeptOnATopWhoseSpinDecays) {
  const Real tolerance = GetParam();
  const Model model = dragged_top();
  Real worst = 0;
  run(model, automatic(tolerance, 0.1), 40, [&](const World& world) {
    const Real t = world.time(), s = (1 - std::exp(-0.7 * t)) / 0.7;  // the free top's time
    const auto free = run(free_top(), with("auto", s), 1).motions[0];
    worst = std::max(
        {worst, angle(free.orientation, world.motions()[0].orientation),
         (world.motions()[0].angular_momentum - std::exp(-0.7 * t) * model.motions[0].angular_momentum)
                 .norm() /
             model.motions[0].angular_momentum.norm()});
  });
  EXPECT_LT(worst, std::max(tolerance, 1e-13));
}

INSTANTIATE_TEST_SUITE_P(Tolerances, Bound, testing::Values(1e-4, 1e-6, 1e-8, 1e-10, 1e-12));

// At what integrator and step the samples are taken changes nothing beyond the tolerance.
TEST(Auto, DoesNotDependOnTheSampleGrid) {
  for (const Model& model : {forced_bodies(), linked_bodies(true), heavy_top()}) {
    const auto coarse = run(model, automatic(1e-9, 0.5), 2).motions,
               fine = run(model, automatic(1e-9, 0.01), 100).motions;
    // both within 1e-9 of their scales: places 3, momenta 10, spins 30
    EXPECT_LT(distance(coarse, fine), 2 * 30 * 1e-9);
    EXPECT_LT(distance(fine, run(model, "rk8", 1, 4000).motions), 30 * 1e-9);
  }
}

// A tighter bound is a better motion.
TEST(Auto, ErrorFollowsTolerance) {
  const Model model = forced_bodies();
  const auto exact = run(model, "rk8", 2, 8000).motions;
  Real before = 1;
  for (const Real tolerance : {1e-4, 1e-7, 1e-10}) {
    const Real error = distance(run(model, automatic(tolerance, 0.1), 20).motions, exact);
    EXPECT_LT(error, 30 * tolerance);
    EXPECT_LT(error, before);
    before = error;
  }
}

// Chaos parts any two runs: in the end no tolerance holds, and a remark says from where on.
TEST(Auto, ReportsToleranceMissedThroughChaos) {
  Model model = linked_bodies(true);
  Options options = automatic(1e-10, 0.1);
  const Outcome early = run(model, options, 10), late = run(model, options, 1200);
  EXPECT_TRUE(early.remarks.empty());
  ASSERT_EQ(late.remarks.size(), 1u);
  EXPECT_NE(late.remarks[0].find("tolerance"), std::string::npos);
  for (const Motion& m : late.motions) EXPECT_TRUE(m.position.allFinite());
}

TEST(Auto, ReportsToleranceBelowRounding) {
  const Outcome end = run(forced_bodies(), automatic(1e-17, 0.1), 50);
  ASSERT_FALSE(end.remarks.empty());
  const auto exact = run(forced_bodies(), "rk8", 5, 20000).motions;
  EXPECT_LT(distance(end.motions, exact), 1e-9);  // and goes on at its best
}

TEST(Auto, GivesTheSameBitsTwice) {
  for (const Model& model : {forced_bodies(), linked_bodies(false), ball_over_plane(0.5, 0.8)}) {
    const auto a = run(model, automatic(1e-9, 0.05), 40).motions,
               b = run(model, automatic(1e-9, 0.05), 40).motions;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bits(a[i], b[i]));
  }
}

// A body that is locked, or at rest for ever, has no scale of its own and must not stop the others.
TEST(Auto, AcceptsBodiesAtRest) {
  Model model = spring();
  add_body(model, make_body(2, Matrix3::Identity(), true), {5, 5, 5}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  add_body(model, make_body(2, Matrix3::Identity()), {-5, 5, 5}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.forces.attractions.push_back({1, 0, 1e-3});
  const Outcome end = run(model, automatic(1e-9, 0.1), 20);
  EXPECT_TRUE(end.remarks.empty());
  EXPECT_LT(distance(end.motions, run(model, "rk8", 2, 2000).motions), 1e-8);
}

// A run that has no numbers from its second sample on, however small the tolerance.
class Ending final : public Stepper {
 public:
  void step() override { ++steps_; }
  void read(std::vector<Motion>& motions) const override {
    const Real x = steps_ < 2 ? Real(1) : std::numeric_limits<Real>::quiet_NaN();
    motions.assign(1, make_motion(body(), {x, 2, 3}, Quaternion::Identity(), {0, 0, 0}, {0, 0, 0}));
  }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  std::int64_t operations() const override { return steps_; }
  static Body body() { return make_body(1, Matrix3::Identity()); }

 private:
  int steps_ = 0;
};

// Finer runs were made down to rounding, each of which ended, too.
TEST(Auto, TriesNoFinerRunWhereBothEnd) {
  int runs = 0;
  VerifiedStepper stepper(
      [&](Real) {
        ++runs;
        return std::make_unique<Ending>();
      },
      Real(1e-10), 0.01, {Ending::body()});
  for (int i = 0; i < 5; ++i) stepper.step();
  EXPECT_EQ(runs, 2);
  const std::vector<Diagnostic> all = stepper.diagnostics();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, DiagnosticKind::tolerance_missed);
  EXPECT_NEAR(static_cast<double>(all[0].since), 0.02, 1e-12);
}

// A run that wants for operations after its third step where its tolerance is below 1e-8, and ends off by that tolerance.
class Wanting final : public Stepper {
 public:
  Wanting(Real tolerance, std::int64_t reserve) : tolerance_(tolerance), reserve_(reserve) {}
  void step() override { ++steps_; }
  void read(std::vector<Motion>& motions) const override {
    const Real x = 1 + (ran_out() ? Real(0.1) : tolerance_);
    motions.assign(1, make_motion(body(), {x, 2, 3}, Quaternion::Identity(), {0, 0, 0}, {0, 0, 0}));
  }
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  std::int64_t operations() const override { return steps_; }
  bool ran_out() const override { return steps_ > 2 && (tolerance_ < Real(1e-8) || reserve_ == 0); }
  bool gave_up() const override { return ran_out(); }
  static Body body() { return make_body(1, Matrix3::Identity()); }

 private:
  Real tolerance_;
  std::int64_t reserve_, steps_ = 0;
};

VerifiedStepper wanting(Real bound, const std::shared_ptr<std::int64_t>& reserve) {
  return {[reserve](Real tolerance) { return std::make_unique<Wanting>(tolerance, reserve ? *reserve : 1); },
          bound,
          0.01,
          {Wanting::body()},
          0,
          reserve};
}

// It went on by strides of first order, where a larger tolerance would have been kept with the same operations.
TEST(Auto, TakesALargerToleranceWhereOperationsEnd) {
  VerifiedStepper stepper = wanting(Real(1e-10), std::make_shared<std::int64_t>(0));
  std::int64_t before = 0;
  for (int i = 0; i < 6; ++i) {
    stepper.step();
    EXPECT_GT(stepper.operations(), before);
    before = stepper.operations();
  }
  std::vector<Motion> motions;
  stepper.read(motions);
  EXPECT_NEAR(motions[0].position.x(), 1, 1e-6);
  const std::vector<Diagnostic> all = stepper.diagnostics();
  ASSERT_EQ(all.size(), 1u);
  EXPECT_EQ(all[0].kind, DiagnosticKind::tolerance_missed);
  EXPECT_NE(sentence(all[0]).find("larger local tolerances"), std::string::npos);
  EXPECT_NEAR(static_cast<double>(all[0].since), 0.03, 1e-12);
  ASSERT_TRUE(all[0].reached);
  EXPECT_NEAR(*all[0].reached, 9e-7 / std::sqrt(14.),
              1e-9);  // of 1e-7 and 1e-6, over the distance from the origin
}

// Nothing larger goes on: the first run stays, of which nothing is known.
TEST(Auto, TakesNoLargerToleranceWhereItsOperationsEndToo) {
  for (const Real bound : {Real(1e-12), Real(1e-7)}) {
    VerifiedStepper stepper =
        wanting(bound, bound > Real(1e-10) ? nullptr : std::make_shared<std::int64_t>(0));
    for (int i = 0; i < 6; ++i) stepper.step();
    const std::vector<Diagnostic> all = stepper.diagnostics();
    ASSERT_EQ(all.size(), 1u) << bound;
    EXPECT_EQ(all[0].kind, DiagnosticKind::tolerance_unknown) << bound;
  }
}

}  // namespace
}  // namespace cylon::engine
