// Final states with contact: rest after infinitely many bounces, jamming, impacts declared
// simultaneous.
#include "tests/engine/contact/contact_fixtures.h"

namespace cylon::engine {
namespace {

// A ball falls on an incline without friction: bounces end after t_1 (1 + e)/(1 - e), and it slides on as if
// it had slid from the start, for nothing acts along the plane but gravity.
TEST(EventRest, BouncesOnASmoothInclineEndInSliding) {
  const Real theta = 0.4, e = 0.5, r = 0.2, height = 0.3, g = 9.81;
  const Vector3 normal(std::sin(theta), std::cos(theta), 0), along(std::cos(theta), -std::sin(theta), 0);
  Model model = with_plane(normal, 0, {e, 0});
  add_sphere(model, 1.3, r, (r + height) * normal + Vector3(0, 0, 0.1), Vector3::Zero(), Vector3::Zero());
  Trial run(model, 0.01);
  const double first = std::sqrt(2 * 0.3 / (9.81 * std::cos(0.4))), last = first * (1 + 0.5) / (1 - 0.5);
  run.until(1.5);
  ASSERT_LT(last, 1.2);
  ASSERT_GT(run.impacts.size(), 10u);
  EXPECT_NEAR(run.impacts[0].time, first, 1e-12);
  EXPECT_NEAR(run.impacts.back().time, last, 1e-6);  // what is left of the bounces when they are cut off
  EXPECT_NEAR(run.motion(0).position.dot(along), g * std::sin(theta) * 1.5 * 1.5 / 2, 1e-11);
  EXPECT_NEAR(run.motion(0).position.dot(normal), r, 1e-14);
  EXPECT_EQ(run.stepper.held().size(), 1u);
}

// A slender rod that slides, leaning, digs itself in above a friction of 4/3 (P. Painleve 1895; F. Genot and
// B. Brogliato, Eur. J. Mech. A 18 (1999) 653); far below it, it just falls over.  The law has no force
// there: it must be said.
TEST(EventRest, ReportsJammedRod) {
  struct Case {
    Real mu, speed;
    bool jams;
  };
  for (const Case c : {Case{5, -3, true}, Case{0.5, -3, false}, Case{0.5, 3, false}}) {
    Model model = with_plane(Vector3::UnitY(), 0, {0, c.mu});
    const Vector3 half(0.001, 1, 0.001);
    const Quaternion q = exponential(Vector3(0, 0, -1));
    const Real low = (q * Vector3(half.x(), -half.y(), half.z())).y();
    add_box(model, 1, half, Vector3(0, -low, 0), q, {c.speed, 0, 0}, Vector3::Zero());
    Trial run(model, 0.01);
    const Real start = run.energy();
    run.until(1);
    EXPECT_EQ(!sentences(run.stepper.diagnostics()).empty(), c.jams) << c.mu << ' ' << c.speed;
    EXPECT_LT(run.energy(), start);
    EXPECT_NEAR(run.motion(0).position.y(), half.x(), 1e-12) << c.mu << ' ' << c.speed;  // it lies
    EXPECT_LT(run.velocity(0).norm(), 1e-12);
  }
}

// Three balls in a row, e = 1, declared simultaneous: A P = (2, 0) with A = [2 -1; -1 2], P = (4/3, 2/3).
TEST(EventRest, ImpactsDeclaredSimultaneousAreSolvedAtOnce) {
  Model model = without_plane({1, 0});
  model.impacts = Impacts::simultaneous;
  const Vector3 along = Vector3(0.3, -0.8, 0.5).normalized();
  for (int i = 0; i < 3; ++i) {
    const Real at = i == 0 ? Real(-0.35) : static_cast<Real>(i) * Real(0.5);
    add_sphere(model, 1, 0.25, at * along, i == 0 ? Vector3(along) : Vector3(Vector3::Zero()),
               Vector3::Zero());
  }
  Trial run(model, 0.05);
  const Vector3 k = run.momentum(), l = run.angular_momentum();
  const Real energy = run.energy();
  run.until(1);
  ASSERT_EQ(run.impacts.size(), 1u);
  EXPECT_NEAR(run.impacts[0].time, 0.35, 1e-12);
  const Real expected[] = {-1.0 / 3, 2.0 / 3, 2.0 / 3};
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(run.velocity(i).dot(along), expected[i], 1e-13) << i;
  EXPECT_LT((run.momentum() - k).norm(), 1e-15);
  EXPECT_LT((run.angular_momentum() - l).norm(), 1e-15);
  EXPECT_NEAR(run.energy(), energy, 1e-15);
}

}  // namespace
}  // namespace cylon::engine
