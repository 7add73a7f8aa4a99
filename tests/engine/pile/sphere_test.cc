// Piles of spheres: impacts, friction, resting, penetration, and bits that do not depend on threads.
#include "engine/pile/sphere_pile.h"
#include "tests/engine/fixtures.h"
#include "tests/engine/pile/pile_fixtures.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <utility>

namespace cylon::engine {
namespace {

Model two_balls(Real restitution, Real friction) {
  Model model = pile_model(restitution, friction, false);
  model.forces.gravity.setZero();
  add_ball(model, Real(1.3), Real(0.5), Vector3(-3, Real(0.31), Real(0.2)), Vector3(4, Real(0.1), Real(-0.2)),
           Vector3(Real(0.7), Real(-2), Real(1.1)));
  add_ball(model, Real(3.1), Real(0.4), Vector3(Real(0.1), Real(-0.05), Real(0.03)),
           Vector3(Real(-0.3), Real(0.2), Real(0.1)), Vector3(1, Real(0.5), -3));
  return model;
}

class PileRestitution : public testing::TestWithParam<double> {};

TEST_P(PileRestitution, IsNewtonsAndKeepsBothMomenta) {
  const Real e = static_cast<Real>(GetParam());
  for (const Real friction : {Real(0), Real(0.3)}) {
    const Model model = two_balls(e, friction);
    const auto stepper = make_pile(model, 1. / 60);
    double approach = 0, separation = -1;
    std::vector<Motion> motions;
    for (int k = 0; k < 90; ++k) {
      stepper->step();
      for (const Impact& impact : stepper->impacts())
        approach = static_cast<double>(impact.approach), separation = static_cast<double>(impact.separation);
    }
    stepper->read(motions);
    ASSERT_GT(approach, 3);
    EXPECT_NEAR(separation, GetParam() * approach, 1e-15 + 4 * static_cast<double>(eps) * approach);
    // 90 steps of ten parts, each of a few roundings of numbers below 20
    const Real rounding = 20 * 64 * eps;
    EXPECT_LT((momentum(motions) - momentum(model.motions)).norm(), rounding);
    EXPECT_LT((angular_momentum(motions) - angular_momentum(model.motions)).norm(), rounding);
    // Without friction the energy lost is exactly (1 - e^2) mu_r u^2/2, mu_r the reduced mass.
    if (friction > 0) continue;
    const double reduced = 1.3 * 3.1 / 4.4;
    EXPECT_NEAR(mechanical_energy(model, motions) - mechanical_energy(model, model.motions),
                -(1 - GetParam() * GetParam()) * reduced * approach * approach / 2,
                1000 * static_cast<double>(eps));
  }
}

INSTANTIATE_TEST_SUITE_P(All, PileRestitution, testing::Values(0., .25, .5, .8, 1.));

// The impulse acts along the line of centres at the instant of contact, found on the broken path: the final
// velocities are exact whatever the step.
TEST(PileSphere, ObliqueImpactDoesNotDependOnTheStep) {
  std::vector<Vector3> momenta;
  for (const double dt : {1. / 30, 1. / 60, 1. / 240}) {
    const auto stepper = make_pile(two_balls(Real(0.7), Real(0.2)), dt);
    momenta.push_back(after(*stepper, static_cast<int>(1.5 / dt))[0].momentum);
  }
  EXPECT_LT((momenta[0] - momenta[2]).norm(), 4000 * eps);
  EXPECT_LT((momenta[1] - momenta[2]).norm(), 4000 * eps);
}

// At any step: impacts are met on the paths of free fall within it.  They took the velocity from before the step's gravity,
// so that an elastic ball lost a quarter of its energy in 6 s of steps of 4 ms, and turned all the step as after its impacts.
TEST(PileSphere, BouncesAreThoseOfFreeFall) {
  for (const Real restitution : {Real(1), Real(0.8)})
    for (const auto& [tilt, friction] : {std::pair(Real(0), Real(0)), std::pair(Real(0.3), Real(0.25))}) {
      Model model = pile_model(restitution, friction);
      model.planes[0].normal = Vector3(-std::sin(tilt), std::cos(tilt), 0);
      add_ball(model, 1, Real(0.5), Vector3(Real(0.2), Real(2.5), 0), Vector3(1, Real(-0.3), Real(0.4)),
               Vector3(2, 1, -9));
      const Outcome exact = run(model, with("auto", 0.1), 24);
      ASSERT_GE(exact.impacts.size(), 2u);
      for (const int steps : {144, 1000, 3000}) {
        const auto stepper = make_pile(model, 2.4 / steps);
        EXPECT_LT(distance(after(*stepper, steps), exact.motions), 1e5 * eps) << restitution << ' ' << steps;
      }
    }
}

// Flights of 2.3 steps, which pass their highest point in most of them.  What is met a little early, and what is taken to be
// pressed as it hardly moves, cost 4 % in 1 s.
TEST(PileSphere, LowBouncesKeepTheEnergy) {
  Model model = pile_model(1, 0);
  add_ball(model, 1, Real(0.1), Vector3(0, Real(0.101), 0));
  const auto stepper = make_pile(model, 0.0125);
  const double start = mechanical_energy(model, model.motions);
  for (int k = 0; k < 800; ++k)
    EXPECT_NEAR(mechanical_energy(model, after(*stepper, 1)), start, 1e5 * static_cast<double>(eps)) << k;
}

// The same on a locked ball, where gravity turns the direction in which they meet, and of two balls that fall at different
// rates.
TEST(PileSphere, BouncesOffOtherBallsAreThoseOfFreeFall) {
  Model model = pile_model(Real(0.8), Real(0.25));
  add_ball(model, Real(0.4), Real(0.3), Vector3(Real(0.9), Real(3.1), 0), Vector3(Real(-0.3), -1, 0),
           Vector3(-3, 0, 5));
  model.bodies[0].gravity = Vector3(Real(0.5), -14, Real(0.3));
  add_ball(model, 1, Real(0.5), Vector3(Real(0.2), Real(2.5), 0), Vector3(Real(0.1), Real(-0.3), Real(0.2)),
           Vector3(2, 1, -9));
  add_body(model, make_body(1, Matrix3::Identity(), true), Sphere{Real(0.4)},
           Vector3(Real(0.3), Real(0.4), Real(0.1)));
  const Outcome exact = run(model, with("auto", 0.01), 80);
  std::set<std::pair<int, int>> met;
  for (const Impact& impact : exact.impacts)
    if (impact.other != fixed_world) met.insert(std::minmax(impact.body, impact.other));
  EXPECT_EQ(met.size(), 2u) << "both kinds of meetings";
  for (const int steps : {48, 800, 8000}) {
    Options options = with("auto", 0.8 / steps);
    options.path = "stepping";
    EXPECT_LT(distance(run(model, options, steps).motions, exact.motions), 1e5 * eps) << steps;
  }
}

// Coulomb's cone is round: a ball that slides stops slipping after the same way in all directions.
TEST(PileSphere, FrictionIsIsotropic) {
  std::vector<double> ways;
  for (int k = 0; k < 16; ++k) {
    const double angle = 0.1 + k * 2 * std::acos(-1.) / 16;
    const Vector3 along(static_cast<Real>(std::cos(angle)), 0, static_cast<Real>(std::sin(angle)));
    Model model = pile_model(0, Real(0.3));
    add_ball(model, 1, Real(0.5), Vector3(0, Real(0.5), 0), 5 * along);
    const auto stepper = make_pile(model, 1. / 240);
    const Motion end = after(*stepper, 480)[0];
    ways.push_back(static_cast<double>(along.dot(end.position)));
    // Rolling: v = 5/7 v0 for a solid ball, whatever the friction; v = w r.
    EXPECT_NEAR(static_cast<double>(along.dot(end.momentum)), 25. / 7, 1e-3);
    // 480 steps of ten parts, each a rounding of up to 7.5 m
    EXPECT_LT(std::abs(static_cast<double>(end.position.cross(along).y())),
              4800 * 7.5 * static_cast<double>(eps));
  }
  for (const double way : ways) EXPECT_NEAR(way, ways[0], 4800 * 7.5 * static_cast<double>(eps));
  // S9: 2 v0/(7 mu g) of slipping, then 5/7 v0; first order in the step
  const double slip = 2 * 5 / (7 * 0.3 * 9.81);
  EXPECT_NEAR(ways[0], 5 * slip - 0.3 * 9.81 * slip * slip / 2 + 25. / 7 * (2 - slip), 0.01);
}

TEST(PileSphere, RestsWithoutCreep) {
  Model model = pile_model(0, Real(0.5));
  add_ball(model, 1, Real(0.5), Vector3(Real(0.3), Real(0.5), Real(-0.7)));
  const auto stepper = make_pile(model, 1. / 240);
  const Vector3 start = after(*stepper, 1000)[0].position;
  EXPECT_LT((after(*stepper, 20000)[0].position - start).norm(), Real(1e-9));
  EXPECT_LT((start - model.motions[0].position).norm(), 64 * eps);
}

TEST(PileSphere, RestsOnOthersWithinTheSlop) {
  const Model model = ball_pile(5, 4, 0, Real(0.5));
  const auto stepper = make_pile(model, 1. / 60);
  const auto end = after(*stepper, 600);
  // slop 2e-4 r, and what a step adds before a fifth of it goes
  EXPECT_LT(deepest(model, end), Real(2e-3));
  for (const Motion& m : end) EXPECT_LT(m.momentum.norm(), Real(0.05));
}

// Nothing feeds energy in but rounding, lifting what overlaps, and impulses of the part before that one sweep does not take
// back at once: in the mean over heights of the drop less than a thousandth of the energy of the fall.  At one height it is
// 2e-3, where the lowest layer lands early in a step; 1e-3 at one height alone was luck.  After 10 s all lie: at 5 s a ball may
// still fall off the heap, and lands with 1e-5 of it.
TEST(PileSphere, LosesEnergy) {
  constexpr int heights = 14;
  double sum = 0;
  for (int n = 0; n < heights; ++n) {
    Model model = ball_pile(4, 4, 0, Real(0.5));
    for (Motion& motion : model.motions) motion.position.y() += Real(0.004) * static_cast<Real>(n);
    const auto stepper = make_pile(model, 1. / 120);
    std::vector<Motion> motions;
    const double start = mechanical_energy(model, model.motions);
    double lowest = start, worst = 0, worst_settled = 0;
    for (int k = 0; k < 1800; ++k) {
      stepper->step();
      stepper->read(motions);
      const double now = mechanical_energy(model, motions);
      worst = std::max(worst, now - lowest);
      if (k >= 1200) worst_settled = std::max(worst_settled, now - lowest);
      lowest = std::min(lowest, now);
    }
    sum += worst / start;
    EXPECT_LT(worst, 2.5e-3 * start) << n;
    EXPECT_LT(worst_settled, 2e-6 * start) << n;
    EXPECT_LT(lowest, 0.9 * start) << n;
  }
  EXPECT_LT(sum / heights, 1e-3);
}

TEST(PileSphere, ElasticGasKeepsItsEnergy) {
  Model model = pile_model(1, 0, false);
  model.forces.gravity.setZero();
  for (const Vector3& n : {Vector3(1, 0, 0), Vector3(-1, 0, 0), Vector3(0, 1, 0), Vector3(0, -1, 0),
                           Vector3(0, 0, 1), Vector3(0, 0, -1)})
    model.planes.push_back({n, -1}), model.plane_surfaces.push_back(0);
  for (int i = 0; i < 125; ++i) {
    const int layer = i / 25, row = i / 5 % 5, place = i % 5;
    add_ball(model, 1, Real(0.05), Vector3(Real(place) - 2, Real(row) - 2, Real(layer) - 2) * Real(0.4),
             Vector3(Real(std::sin(i)), Real(std::cos(3 * i)), Real(std::sin(7 * i + 1))));
  }
  const auto stepper = make_pile(model, 1. / 240);
  const double start = mechanical_energy(model, model.motions),
               end = mechanical_energy(model, after(*stepper, 1200));
  EXPECT_NEAR(end / start, 1, 1e-2);
}

TEST(PileSphere, CradlePassesTheBlowOn) {
  Model model = pile_model(1, 0, false);
  model.forces.gravity.setZero();
  add_ball(model, 1, Real(0.5), Vector3(Real(-1.6), 0, 0), Vector3(1, 0, 0));
  for (int i = 0; i < 4; ++i) add_ball(model, 1, Real(0.5), Vector3(Real(i), 0, 0));
  const auto end = after(*make_pile(model, 1. / 60), 60);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(static_cast<double>(end[i].momentum.x()), i == 4 ? 1 : 0, 1e-5);
}

std::vector<Motion> run(const Model& model, int threads, int steps) {
  PileSettings settings;
  settings.threads = threads;
  return after(*make_pile(model, 1. / 60, settings), steps);
}

TEST(PileSphere, BitsDoNotDependOnThreads) {
  const Model model = ball_pile(12, 16, 0, Real(0.5));  // 2304 balls: three blocks
  const auto one = run(model, 1, 90), two = run(model, 2, 90), four = run(model, 4, 90);
  EXPECT_TRUE(same_bits(one, two));
  EXPECT_TRUE(same_bits(one, four));
  EXPECT_FALSE(same_bits(one, run(model, 1, 91)));
}

// Contacts are swept one after another, so another order of the bodies is another, equally good solution;
// bodies that touch nothing keep their bits.
TEST(PileSphere, OrderOfBodiesChangesOnlyWhatTouches) {
  Model model = ball_pile(3, 3, 0, Real(0.5));
  add_ball(model, 2, Real(0.3), Vector3(0, 50, 0), Vector3(Real(0.1), 3, Real(-0.2)));
  Model reversed = model;
  std::reverse(reversed.motions.begin(), reversed.motions.end());
  std::reverse(reversed.bodies.begin(), reversed.bodies.end());
  std::reverse(reversed.shapes.begin(), reversed.shapes.end());
  const auto a = run(model, 1, 60), b = run(reversed, 1, 60);
  EXPECT_TRUE(same_bits(a.back(), b.front()));
  EXPECT_LT(deepest(reversed, b), Real(0.02));
}

TEST(PileSphere, OverlapsSeparateWithoutEnergy) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 4; ++i) add_ball(model, 1, Real(0.5), Vector3(Real(0.1), Real(0.4), Real(0.2)));
  add_ball(model, 1, Real(0.5), Vector3(Real(0.3), Real(-0.3), Real(0.2)));
  const auto stepper = make_pile(model, 1. / 60);
  Real fastest = 0;
  std::vector<Motion> motions;
  for (int k = 0; k < 300; ++k) {
    stepper->step();
    stepper->read(motions);
    for (const Motion& m : motions) {
      ASSERT_TRUE(m.position.allFinite() && m.momentum.allFinite());
      fastest = std::max(fastest, m.momentum.norm());
    }
  }
  EXPECT_LT(fastest, 5);  // sqrt(2 g 1 m): a fall from where they were pushed to, no explosion
  EXPECT_LT(deepest(model, motions), Real(0.02));
}

// 20 m/s and 1/4 s: 5 m a step, against a ball of 0.1 m; sixteen parts of 0.31 m would be too long without
// the look along the path.
TEST(PileSphere, FastBallsMeet) {
  Model model = pile_model(1, 0, false);
  model.forces.gravity.setZero();
  add_ball(model, 1, Real(0.1), Vector3(-3, 0, 0), Vector3(20, 0, 0));
  add_ball(model, 1, Real(0.1), Vector3(Real(0.3), Real(0.05), 0));
  const auto stepper = make_pile(model, 0.25);
  EXPECT_LT(after(*stepper, 2)[0].momentum.x(), 10);
  EXPECT_FALSE(stepper->diagnostics().empty());
}

}  // namespace
}  // namespace cylon::engine
