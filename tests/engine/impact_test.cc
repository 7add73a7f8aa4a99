// Impacts: their law, their times, their end.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

constexpr Real g = 9.81;  // m/s^2, as in ball_over_plane

Approach approach_of(const World& w, const Contact& c) { return approach(c, w.bodies(), w.motion()); }

void add_sphere(Start& start, Real mass, Real radius, const Vector3& position, const Vector3& v,
                bool locked = false) {
  add_body(start, make_body(mass, Matrix3::Identity() * (0.4 * mass * radius * radius), locked), position,
           {0.3, 0.1, 0.2}, v, {0.4, -1.1, 0.6});
}

void add_contact(Start& start, int body, Real radius, int other, Real other_radius, Real restitution) {
  start.model.contacts.push_back({body, radius, other, other_radius, Vector3::UnitY(), 0, restitution});
}

struct Bounces {
  std::vector<Impact> impacts;
  World end;
};

Bounces bounce(const Start& start, std::string_view scheme, Real duration, int steps) {
  Bounces all{{}, World(start.model, start.motion, *find_integrator(scheme), duration / steps)};
  for (int i = 0; i < steps; ++i) {
    all.end.step();
    all.impacts.insert(all.impacts.end(), all.end.impacts().begin(), all.end.impacts().end());
  }
  return all;
}

// ---- The law
// -----------------------------------------------------------------------------------------------------

class Restitution : public testing::TestWithParam<Real> {};

// Two unequal spheres, oblique: the normal speed is reversed times e, all else stays (errata 24, 25, 54, 55).
TEST_P(Restitution, OfTwoSpheresInAnObliqueImpact) {
  const Real e = GetParam();
  Start start;
  add_sphere(start, 1.3, 0.3, {0.1, 0.2, -0.4}, {1.1, 0.3, 0.2});
  add_sphere(start, 0.6, 0.2, {1.3, 0.5, -0.3}, {-0.7, -0.2, 0.1});
  add_contact(start, 0, 0.3, 1, 0.2, e);
  const Bounces all = bounce(start, "rk4", 1.0, 10);
  ASSERT_EQ(all.impacts.size(), 1u);

  // The time of contact from |d + v t| = r_a + r_b.
  const Vector3 d = start.motion[0].position - start.motion[1].position;
  const Vector3 v_a = velocity(start.model.bodies[0], start.motion[0]),
                v_b = velocity(start.model.bodies[1], start.motion[1]);
  const Vector3 v = v_a - v_b;
  const Real b = d.dot(v),
             t = (-b - std::sqrt(b * b - v.squaredNorm() * (d.squaredNorm() - 0.25))) / v.squaredNorm();
  EXPECT_NEAR(all.impacts[0].time, t, 1e-14);

  const Vector3 n = (d + t * v).normalized();
  const Vector3 impulse = -(1 + e) * v.dot(n) / (1 / 1.3 + 1 / 0.6) * n;
  const auto& bodies = all.end.bodies();
  const auto& after = all.end.motion();
  EXPECT_LT((velocity(bodies[0], after[0]) - (v_a + impulse / 1.3)).norm(), 1e-14);
  EXPECT_LT((velocity(bodies[1], after[1]) - (v_b - impulse / 0.6)).norm(), 1e-14);
  EXPECT_LT((momentum(after) - momentum(start.motion)).norm(), 1e-15);
  EXPECT_LT((angular_momentum(after) - angular_momentum(start.motion)).norm(), 1e-14);
  const Real loss = kinetic_energy(start.model.bodies, start.motion) - kinetic_energy(bodies, after);
  const Real reduced = 1 / (1 / 1.3 + 1 / 0.6);
  EXPECT_NEAR(loss, (1 - e * e) * reduced * std::pow(v.dot(n), 2) / 2, 1e-14);
}

TEST_P(Restitution, OfASphereOnAPlane) {
  const Start start = ball_over_plane(0.8, GetParam());
  const Bounces all = bounce(start, "rk4", 0.41, 41);  // t1 = 0.404 s
  ASSERT_GE(all.impacts.size(), 1u);
  const Real u = std::sqrt(2 * g * 0.8);
  EXPECT_NEAR(all.impacts[0].approach, u, 1e-13);
  EXPECT_NEAR(all.impacts[0].separation, GetParam() * u, 1e-13);
  const Vector3 n = start.model.contacts[0].normal, v = velocity(all.end.bodies()[0], all.end.motion()[0]);
  EXPECT_LT((v - v.dot(n) * n - velocity(start.model.bodies[0], start.motion[0])).norm(),
            1e-14);  // sideways kept
  EXPECT_EQ(all.end.motion()[0].angular_momentum, start.motion[0].angular_momentum);
}

INSTANTIATE_TEST_SUITE_P(Coefficients, Restitution, testing::Values(0.0, 0.8, 1.0));

// ---- The times
// ---------------------------------------------------------------------------------------------------

// t_1 = sqrt(2h/g), t_{n+1} = t_n + 2 e^n u_1/g: both schemes follow a parabola exactly, at any step.
TEST(ImpactTime, OfABouncingBallIsTheClosedForm) {
  for (const std::string_view scheme : {"rk4", "velocity-verlet"}) {
    for (const int steps : {50, 5000}) {
      const Bounces all = bounce(ball_over_plane(2.0, 0.8), scheme, 5.0, steps);
      ASSERT_GE(all.impacts.size(), 8u);
      Real t = std::sqrt(2 * 2.0 / g), u = g * t;
      for (std::size_t n = 0; n < 8; ++n) {
        EXPECT_NEAR(all.impacts[n].time, t, 1e-12) << scheme << ' ' << steps << " bounce " << n + 1;
        EXPECT_NEAR(all.impacts[n].separation, 0.8 * u, 1e-12) << scheme << " bounce " << n + 1;
        u *= 0.8;
        t += 2 * u / g;
      }
    }
  }
}

TEST(ImpactTime, OfSpheresThatPassThroughEachOtherWithinAStep) {
  Start start;
  add_sphere(start, 1, 0.1, {-5.03, 0.02, 0.01}, {100, 0.1, 0.2});
  add_sphere(start, 1, 0.1, {0.2, 0.03, 0.02}, {0, 0.1, 0.2});
  add_contact(start, 0, 0.1, 1, 0.1, 1);
  const Bounces all = bounce(start, "rk4", 0.1, 1);  // 10 m in the one step
  ASSERT_EQ(all.impacts.size(), 1u);
  EXPECT_NEAR(all.impacts[0].time, (5.23 - std::sqrt(0.2 * 0.2 - 2e-4)) / 100, 1e-14);
  start.motion[0].position.y() = 0.24;  // negative control: a miss by a hundredth
  EXPECT_TRUE(bounce(start, "rk4", 0.1, 1).impacts.empty());
}

// ---- The end
// -----------------------------------------------------------------------------------------------------

// All bounces are over at t_1 + 2 e u_1 / (g (1 - e)); after it the ball slides on.
TEST(Zeno, ABallComesToRestAndSlidesOn) {
  const Real e = 0.8, t1 = std::sqrt(2 * 0.5 / g), end_of_bounces = t1 * (1 + 2 * e / (1 - e));
  for (const Integrator& scheme : integrators()) {
    const Start start = ball_over_plane(0.5, e);
    const Bounces all = bounce(start, scheme.name, 6.0, 1200);
    const Vector3 v = velocity(all.end.bodies()[0], all.end.motion()[0]);
    const Vector3 slide = velocity(start.model.bodies[0], start.motion[0]);
    ASSERT_TRUE(all.end.motion()[0].position.allFinite()) << scheme.name;
    if (scheme.name == "explicit-euler") {  // gains g h a bounce: rest is a tremor u = e (u + g h)
      EXPECT_LT((v - slide).norm(), e / (1 - e) * g * 0.005);
      continue;
    }
    EXPECT_LT(std::abs(approach_of(all.end, start.model.contacts[0]).gap), 1e-15) << scheme.name;
    EXPECT_LT((v - slide).norm(), 1e-13) << scheme.name;
    if (scheme.order == 1) continue;  // its bounces lose energy on the way
    EXPECT_GT(all.impacts.size(), 30u) << scheme.name;
    EXPECT_NEAR(all.impacts.back().time, end_of_bounces, 1e-6) << scheme.name;
  }
}

TEST(Zeno, AnElasticBallNeverRests) {
  const Start start = ball_over_plane(0.02, 1);
  const Bounces all = bounce(start, "rk4", 20.0, 200);  // 0.128 s a bounce, more than once in some steps
  const Real energy = kinetic_energy(all.end.bodies(), all.end.motion()) +
                      0.7 * g * (start.model.contacts[0].normal.dot(all.end.motion()[0].position) - 0.65);
  EXPECT_NEAR(energy, kinetic_energy(start.model.bodies, start.motion) + 0.7 * g * 0.02, 1e-12);
  EXPECT_EQ(all.impacts.size(), 157u);  // (20 - t1) / (2 t1) + 1, t1 = 0.06386
}

TEST(Zeno, BallsStackedOnAFloorStayAndWeighOnIt) {
  Start start;
  for (int i = 0; i < 3; ++i) {
    add_sphere(start, 1.0 + i, 0.2, {0.3, 0.2 + 0.4 * i, -0.1}, {0, 0, 0});
    if (i > 0) add_contact(start, i - 1, 0.2, i, 0.2, 0.5);
  }
  add_contact(start, 0, 0.2, fixed_world, 0, 0.5);
  start.model.forces.gravity = {0, -g, 0};
  for (const Integrator& scheme : integrators()) {
    const World end = run(start, scheme, 1.0, 200);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((end.motion()[i].position - start.motion[i].position).norm(), 1e-14) << scheme.name << i;
      EXPECT_LT(end.motion()[i].momentum.norm(), 1e-14) << scheme.name << i;
    }
  }
}

// Between two others that close in, a light ball is struck without end when little is given back: the step
// must end.
TEST(Zeno, InelasticCollapseEnds) {
  Start start;
  add_sphere(start, 5, 0.1, {-0.5, 0, 0}, {1, 0, 0});
  add_sphere(start, 0.1, 0.1, {0.05, 0, 0}, {0, 0, 0});
  add_sphere(start, 5, 0.1, {0.5, 0, 0}, {-1, 0, 0});
  add_contact(start, 0, 0.1, 1, 0.1, 0.05);
  add_contact(start, 1, 0.1, 2, 0.1, 0.05);
  const Bounces all = bounce(start, "rk4", 1.0, 50);
  for (const Motion& m : all.end.motion()) ASSERT_TRUE(m.position.allFinite());
  EXPECT_LT((momentum(all.end.motion()) - momentum(start.motion)).norm(), 1e-14);
  for (const Contact& c : start.model.contacts) EXPECT_GT(approach_of(all.end, c).gap, -1e-12);
  EXPECT_GT(all.impacts.size(), 3u);
}

// Sequential impacts hand the motion through a row of equal spheres that touch.
TEST(Sequential, ARowOfTouchingSpheresHandsTheMotionOn) {
  Start start;
  for (int i = 0; i < 4; ++i) {
    add_sphere(start, 0.9, 0.25, {0.5 * i - (i == 0 ? 0.3 : 0), 0, 0}, {i == 0 ? 2.0 : 0.0, 0, 0});
    if (i > 0) add_contact(start, i - 1, 0.25, i, 0.25, 1);
  }
  const Bounces all = bounce(start, "rk4", 1.0, 10);
  EXPECT_EQ(all.impacts.size(), 3u);
  for (std::size_t i = 0; i < 4; ++i) {
    const Vector3 expected = {i == 3 ? 2.0 : 0.0, 0, 0};
    EXPECT_LT((velocity(all.end.bodies()[i], all.end.motion()[i]) - expected).norm(), 1e-14) << i;
  }
}

// m (g + a cos(wt)) presses until cos(wt) = -g/a; from there the ball flies.
TEST(Resting, LetsGoWhenPulledOff) {
  Start start = ball_over_plane(0, 0.5);
  const Vector3 n = start.model.contacts[0].normal;
  const Real a = 25, w = 2;
  start.model.forces.drives.push_back({0, -0.7 * a * n, w});
  const Real t0 = std::acos(-g / a) / w, t = t0 + 0.3;
  const World end = run(start, *find_integrator("rk4"), t, 4000);
  // gap'' = -g - a cos(wt), from rest at t0
  const Real s = t - t0;
  const Real gap =
      -g * s * s / 2 + a / (w * w) * (std::cos(w * t) - std::cos(w * t0)) + a / w * std::sin(w * t0) * s;
  ASSERT_GT(gap, 0.1);
  EXPECT_NEAR(approach_of(end, start.model.contacts[0]).gap, gap, 1e-6);
}

// ---- Locked bodies
// -----------------------------------------------------------------------------------------------

TEST(Locked, StayWhateverStrikesOrPullsThem) {
  Start start;
  add_sphere(start, 0.2, 0.5, {0.1, 0.2, -0.3}, {0, 0, 0}, true);
  add_sphere(start, 1.4, 0.3, {0.1, 2.0, -0.3}, {0, -1, 0});
  add_contact(start, 0, 0.5, 1, 0.3, 0.8);
  start.model.forces.gravity = {0, -g, 0};
  start.model.forces.springs.push_back({0, {0.1, 0.2, 0.3}, fixed_world, {3, 4, 5}, 50, 0.1, 0.2});
  const Bounces all = bounce(start, "rk4", 1.0, 100);
  EXPECT_EQ(all.end.motion()[0].position, start.motion[0].position);
  EXPECT_EQ(all.end.motion()[0].orientation.coeffs(), start.motion[0].orientation.coeffs());
  EXPECT_EQ(velocity(all.end.bodies()[0], all.end.motion()[0]), Vector3(Vector3::Zero()));
  EXPECT_EQ(angular_velocity(all.end.bodies()[0], all.end.motion()[0]), Vector3(Vector3::Zero()));
  ASSERT_GE(all.impacts.size(), 1u);  // 1 m below: v^2 = 1 + 2 g
  EXPECT_NEAR(all.impacts[0].separation, 0.8 * std::sqrt(1 + 2 * g * 1.0), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
