// Impacts of whole runs: their law, their times, their end; fixed integrators and auto alike.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

constexpr Real g = 9.81;  // m/s^2, as in ball_over_plane

void add_sphere(Model& model, Real mass, Real radius, const Vector3& position, const Vector3& v,
                bool locked = false) {
  add_body(model, make_body(mass, Matrix3::Identity() * (0.4 * mass * radius * radius), locked), position,
           {0.3, 0.1, 0.2}, v, {0.4, -1.1, 0.6}, Sphere{radius});
}

Real gap(const std::vector<Motion>& motions, const Model& model, std::size_t a, std::size_t b) {
  return (motions[a].position - motions[b].position).norm() - std::get<Sphere>(model.shapes[a]).radius -
         std::get<Sphere>(model.shapes[b]).radius;
}

// Auto follows spheres in closed form, a chosen integrator event by event.
const std::vector<const char*> followed = {"auto", "rk4", "velocity-verlet", "yoshida6", "bm4"};

// ---- The law ---------------------------------------------------------------------------------------

class Restitution : public testing::TestWithParam<Real> {};

// Two unequal spheres, oblique: the normal speed is reversed times e, all else stays (errata 24, 25, 54, 55).
TEST_P(Restitution, OfTwoSpheresInAnObliqueImpact) {
  const Real e = GetParam();
  Model start;
  add_sphere(start, 1.3, 0.3, {0.1, 0.2, -0.4}, {1.1, 0.3, 0.2});
  add_sphere(start, 0.6, 0.2, {1.3, 0.5, -0.3}, {-0.7, -0.2, 0.1});
  make_touchable(start, e);
  for (const char* integrator : followed) {
    const Outcome all = run(start, integrator, 1.0, 10);
    ASSERT_EQ(all.impacts.size(), 1u) << integrator;

    // The time of contact from |d + v t| = r_a + r_b.
    const Vector3 d = start.motions[0].position - start.motions[1].position;
    const Vector3 v_a = velocity(start.bodies[0], start.motions[0]),
                  v_b = velocity(start.bodies[1], start.motions[1]);
    const Vector3 v = v_a - v_b;
    const Real b = d.dot(v),
               t = (-b - std::sqrt(b * b - v.squaredNorm() * (d.squaredNorm() - 0.25))) / v.squaredNorm();
    EXPECT_NEAR(all.impacts[0].time, t, 1e-13) << integrator;

    const Vector3 n = (d + t * v).normalized();
    const Vector3 impulse = -(1 + e) * v.dot(n) / (1 / 1.3 + 1 / 0.6) * n;
    const auto& after = all.motions;
    EXPECT_LT((velocity(all.bodies[0], after[0]) - (v_a + impulse / 1.3)).norm(), 1e-13) << integrator;
    EXPECT_LT((velocity(all.bodies[1], after[1]) - (v_b - impulse / 0.6)).norm(), 1e-13) << integrator;
    EXPECT_LT((momentum(after) - momentum(start.motions)).norm(), 1e-15);
    EXPECT_LT((angular_momentum(after) - angular_momentum(start.motions)).norm(), 1e-14);
    const Real loss = kinetic_energy(start.bodies, start.motions) - kinetic_energy(all.bodies, after);
    const Real reduced = 1 / (1 / 1.3 + 1 / 0.6);
    EXPECT_NEAR(loss, (1 - e * e) * reduced * std::pow(v.dot(n), 2) / 2, 1e-13);
  }
}

TEST_P(Restitution, OfASphereOnAPlane) {
  const Model start = ball_over_plane(0.8, GetParam());
  for (const char* integrator : followed) {
    const Outcome all = run(start, integrator, 0.41, 41);  // t1 = 0.404 s
    ASSERT_GE(all.impacts.size(), 1u);
    const Real u = std::sqrt(2 * g * 0.8);
    EXPECT_NEAR(all.impacts[0].approach, u, 1e-12) << integrator;
    EXPECT_NEAR(all.impacts[0].separation, GetParam() * u, 1e-12) << integrator;
    const Vector3 n = start.planes[0].normal, v = velocity(all.bodies[0], all.motions[0]);
    EXPECT_LT((v - v.dot(n) * n - velocity(start.bodies[0], start.motions[0])).norm(),
              1e-14);  // sideways kept
    // An impulse through the centre: its arm and the normal are parallel but for rounding.
    EXPECT_LT((all.motions[0].angular_momentum - start.motions[0].angular_momentum).norm(), 1e-15)
        << integrator;
  }
}

INSTANTIATE_TEST_SUITE_P(Coefficients, Restitution, testing::Values(0.0, 0.8, 1.0));

// ---- The times -------------------------------------------------------------------------------------

// t_1 = sqrt(2h/g), t_{n+1} = t_n + 2 e^n u_1/g: these integrators follow a parabola exactly, at any step.
TEST(ImpactTime, OfABouncingBallIsTheClosedForm) {
  for (const std::string_view integrator : {"auto", "rk4", "velocity-verlet"}) {
    for (const int steps : {50, 2000}) {
      const Outcome all = run(ball_over_plane(2.0, 0.8), integrator, 5.0, steps);
      ASSERT_GE(all.impacts.size(), 8u);
      Real t = std::sqrt(2 * 2.0 / g), u = g * t;
      for (std::size_t n = 0; n < 8; ++n) {
        EXPECT_NEAR(all.impacts[n].time, t, 1e-11) << integrator << ' ' << steps << " bounce " << n + 1;
        EXPECT_NEAR(all.impacts[n].separation, 0.8 * u, 1e-11) << integrator << " bounce " << n + 1;
        u *= 0.8;
        t += 2 * u / g;
      }
    }
  }
}

TEST(ImpactTime, OfSpheresThatPassThroughEachOtherWithinAStep) {
  Model start;
  add_sphere(start, 1, 0.1, {-5.03, 0.02, 0.01}, {100, 0.1, 0.2});
  add_sphere(start, 1, 0.1, {0.2, 0.03, 0.02}, {0, 0.1, 0.2});
  make_touchable(start, 1);
  for (const char* integrator : {"auto", "rk4"}) {
    const Outcome all = run(start, integrator, 0.1, 1);  // 10 m in the one step
    ASSERT_EQ(all.impacts.size(), 1u) << integrator;
    EXPECT_NEAR(all.impacts[0].time, (5.23 - std::sqrt(0.2 * 0.2 - 2e-4)) / 100, 1e-14);
    Model miss = start;
    miss.motions[0].position.y() = 0.24;  // negative control: a miss by a hundredth
    EXPECT_TRUE(run(miss, integrator, 0.1, 1).impacts.empty()) << integrator;
  }
}

// With an impact inside a step the order holds only because the impact is at its own time.
class Struck : public EveryIntegrator {};

TEST_P(Struck, KeepsOrderThroughImpacts) {
  Model start;
  add_body(start, make_body(1.2, Matrix3::Identity()), {0.7, 0.2, 0.3}, {0.1, 0.2, 0.3}, {-0.3, 0.4, 0.1},
           {0, 0, 0}, Sphere{0.1});
  start.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.3, -0.2}, 17.0, 0.35, 0.2});
  start.planes.push_back({Vector3(1, 0.1, -0.2).normalized(), 0.05});
  make_touchable(start, 0.7);
  const auto exact = run(start, "rk8", 1, 4096);
  ASSERT_GE(exact.impacts.size(), 1u);
  const auto error = [&](int n) {
    return distance(run(start, GetParam().name, 1, n).motions, exact.motions);
  };
  const int order = GetParam().order;
  if (order >= 6) {
    EXPECT_LT(error(512), 1e-9);
    return;
  }
  const int n = order == 4 ? 128 : order == 2 ? 1024 : 8192;
  EXPECT_NEAR(std::log2(error(n) / error(2 * n)), order, 0.25);  // the impact's place in its step differs
}

CYLON_EVERY_SCHEME(Struck);

// ---- The end ---------------------------------------------------------------------------------------

// All bounces are over at t_1 + 2 e u_1 / (g (1 - e)); after it the ball slides on.
TEST(Zeno, ABallComesToRestAndSlidesOn) {
  const Real e = 0.8, t1 = std::sqrt(2 * 0.5 / g), end_of_bounces = t1 * (1 + 2 * e / (1 - e));
  for (const char* integrator : {"auto", "rk4", "rk8", "velocity-verlet", "yoshida4", "bm6", "rkn4"}) {
    const Model start = ball_over_plane(0.5, e);
    const Outcome all = run(start, integrator, 6.0, 600);
    const Vector3 v = velocity(all.bodies[0], all.motions[0]);
    ASSERT_TRUE(all.motions[0].position.allFinite()) << integrator;
    EXPECT_LT(std::abs(plane_gap(start, all.motions)), 1e-9) << integrator;
    EXPECT_LT((v - velocity(start.bodies[0], start.motions[0])).norm(), 1e-8) << integrator;
    EXPECT_GT(all.impacts.size(), 30u) << integrator;
    EXPECT_NEAR(all.impacts.back().time, end_of_bounces, 1e-6) << integrator;
  }
}

TEST(Zeno, AnElasticBallNeverRests) {
  const Model start = ball_over_plane(0.02, 1);
  for (const char* integrator : {"auto", "rk4"}) {
    const Outcome all = run(start, integrator, 20.0, 200);  // 0.128 s a bounce, more than once in some steps
    EXPECT_NEAR(energy(start, all.motions), energy(start, start.motions), 1e-11) << integrator;
    EXPECT_EQ(all.impacts.size(), 157u) << integrator;  // (20 - t1) / (2 t1) + 1, t1 = 0.06386
  }
}

TEST(Zeno, StackedBallsRestWithTheirWeight) {
  Model start;
  for (int i = 0; i < 3; ++i) {
    add_body(start, make_body(1.0 + i, Matrix3::Identity() * 0.02), {0.3, 0.2 + 0.4 * i, -0.1}, {0, 0, 0},
             {0, 0, 0}, {0, 0, 0}, Sphere{0.2});
  }
  start.planes.push_back({Vector3::UnitY(), 0});
  start.forces.gravity = {0, -g, 0};
  make_touchable(start, 0.5);
  for (const char* integrator : {"auto", "rk4", "velocity-verlet"}) {
    const Outcome end = run(start, integrator, 1.0, 100);
    for (std::size_t i = 0; i < 3; ++i) {
      EXPECT_LT((end.motions[i].position - start.motions[i].position).norm(), 1e-12) << integrator << i;
      EXPECT_LT(end.motions[i].momentum.norm(), 1e-12) << integrator << i;
    }
  }
}

// Between two others that close in, a light ball is struck without end when little is given back: the step
// must end.
TEST(Zeno, InelasticCollapseEnds) {
  Model start;
  add_sphere(start, 5, 0.1, {-0.5, 0, 0}, {1, 0, 0});
  add_sphere(start, 0.1, 0.1, {0.05, 0, 0}, {0, 0, 0});
  add_sphere(start, 5, 0.1, {0.5, 0, 0}, {-1, 0, 0});
  make_touchable(start, 0.05);
  for (const char* integrator : {"auto", "rk4"}) {
    const Outcome all = run(start, integrator, 1.0, 50);
    for (const Motion& m : all.motions) ASSERT_TRUE(m.position.allFinite()) << integrator;
    EXPECT_LT((momentum(all.motions) - momentum(start.motions)).norm(), 1e-13) << integrator;
    EXPECT_GT(gap(all.motions, start, 0, 1), -1e-9) << integrator;
    EXPECT_GT(gap(all.motions, start, 1, 2), -1e-9) << integrator;
    EXPECT_GT(all.impacts.size(), 3u) << integrator;
  }
}

// Sequential impacts hand the motion through a row of equal spheres that touch.
TEST(Sequential, RowOfTouchingSpheresTransfersMotion) {
  Model start;
  for (int i = 0; i < 4; ++i) {
    add_sphere(start, 0.9, 0.25, {0.5 * i - (i == 0 ? 0.3 : 0), 0, 0}, {i == 0 ? 2.0 : 0.0, 0, 0});
  }
  make_touchable(start, 1);
  for (const char* integrator : {"auto", "rk4"}) {
    const Outcome all = run(start, integrator, 1.0, 10);
    EXPECT_EQ(all.impacts.size(), 3u) << integrator;
    for (std::size_t i = 0; i < 4; ++i) {
      const Vector3 expected = {i == 3 ? 2.0 : 0.0, 0, 0};
      EXPECT_LT((velocity(all.bodies[i], all.motions[i]) - expected).norm(), 1e-13) << integrator << i;
    }
  }
}

// m (g + a cos(wt)) presses until cos(wt) = -g/a; from there the ball flies.
TEST(Resting, ContactEndsWhenPulledApart) {
  Model start = ball_over_plane(0, 0.5);
  const Vector3 n = start.planes[0].normal;
  const Real a = 25, w = 2;
  start.forces.drives.push_back({0, -0.7 * a * n, w});
  const Real t0 = std::acos(-g / a) / w, t = t0 + 0.3;
  // gap'' = -g - a cos(wt), from rest at t0
  const Real s = t - t0;
  const Real expected =
      -g * s * s / 2 + a / (w * w) * (std::cos(w * t) - std::cos(w * t0)) + a / w * std::sin(w * t0) * s;
  ASSERT_GT(expected, 0.1);
  for (const char* integrator : {"auto", "rk4", "rk8"}) {
    const Outcome end = run(start, integrator, t, 1000);
    EXPECT_NEAR(plane_gap(start, end.motions), expected, 1e-6) << integrator;
  }
}

// ---- Locked bodies ---------------------------------------------------------------------------------

TEST(Locked, DoNotMoveUnderImpactsAndForces) {
  Model start;
  add_sphere(start, 0.2, 0.5, {0.1, 0.2, -0.3}, {0, 0, 0}, true);
  add_sphere(start, 1.4, 0.3, {0.1, 2.0, -0.3}, {0, -1, 0});
  make_touchable(start, 0.8);
  start.forces.gravity = {0, -g, 0};
  start.forces.springs.push_back({0, {0.1, 0.2, 0.3}, fixed_world, {3, 4, 5}, 50, 0.1, 0.2});
  for (const char* integrator : {"auto", "rk4"}) {
    const Outcome all = run(start, integrator, 1.0, 100);
    EXPECT_EQ(all.motions[0].position, start.motions[0].position);
    EXPECT_EQ(all.motions[0].orientation.coeffs(), start.motions[0].orientation.coeffs());
    EXPECT_EQ(velocity(all.bodies[0], all.motions[0]), Vector3(Vector3::Zero()));
    EXPECT_EQ(angular_velocity(all.bodies[0], all.motions[0]), Vector3(Vector3::Zero()));
    ASSERT_GE(all.impacts.size(), 1u);  // 1 m below: v^2 = 1 + 2 g
    EXPECT_NEAR(all.impacts[0].separation, 0.8 * std::sqrt(1 + 2 * g * 1.0), 1e-9) << integrator;
  }
}

// Rough: slip u = v + w x r_c;  sticks if (2/7) m |u| <= mu J_n, else slides on (errata 30-33, 52, 53).
TEST(Friction, OfARoughBallIsCoulombs) {
  for (const Real friction : {0.01, 0.9}) {
    Model start = ball_over_plane(0.3, 0.6);
    make_touchable(start, 0.6, friction);
    const Vector3 n = start.planes[0].normal, arm = -0.25 * n;
    const Real mass = 0.7, u_n = std::sqrt(2 * g * 0.3), j_n = 1.6 * mass * u_n;
    const Vector3 v = velocity(start.bodies[0], start.motions[0]), w = {1.0, 2.0, -0.5};
    Vector3 slip = v + w.cross(arm);
    slip -= slip.dot(n) * n;
    const bool sticks = 2.0 / 7 * mass * slip.norm() <= friction * j_n;
    EXPECT_EQ(sticks, friction == 0.9);
    const Vector3 j_t =
        sticks ? Vector3(-2.0 / 7 * mass * slip) : Vector3(-friction * j_n * slip.normalized());
    const Vector3 w_after = w + arm.cross(j_t) / (0.4 * mass * 0.25 * 0.25);
    for (const char* integrator : {"auto", "rk4"}) {
      const Outcome all = run(start, integrator, 0.26, 26);  // t1 = 0.2473 s
      ASSERT_EQ(all.impacts.size(), 1u);
      EXPECT_LT((angular_velocity(all.bodies[0], all.motions[0]) - w_after).norm(), 1e-12)
          << integrator << friction;
      const Vector3 after = velocity(all.bodies[0], all.motions[0]);
      EXPECT_LT((after - after.dot(n) * n - v - j_t / mass).norm(), 1e-12) << integrator << friction;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
