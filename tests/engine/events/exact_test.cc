// The event stepper against closed forms in which contacts meet joints, springs, spin, friction at its
// threshold and impacts of three bodies.
#include "tests/engine/contact/contact_fixtures.h"

#include <numbers>
#include <string>

namespace cylon::engine {
namespace {

constexpr double g = 9.81;

// A pendulum swings from its wall, at the bottom, and back:  2 sqrt(L/g) K(k_n) between strikes, with
// L = (l^2 + 2/5 r^2)/l and k_n = e^n sin(theta_0/2), for the speed at the bottom is 2 sqrt(g L) k.
TEST(EventExact, PendulumStrikesWall) {
  const double l = 0.8, r = 0.1, angle = 1.1, length = (l * l + 0.4 * r * r) / l;
  const Quaternion turn = exponential(Vector3(0, 0.7, 0));
  for (const double e : {1.0, 0.7}) {
    for (const bool reduced : {true, false}) {
      Model model = with_plane(turn * Vector3::UnitX(), -r, {e, 0});
      model.reduce_joints = reduced;
      const Quaternion q = turn * exponential(Vector3(0, 0, angle));
      add_sphere(model, 1.7, r, q * Vector3(0, -l, 0), Vector3::Zero(), Vector3::Zero());
      model.motions[0].orientation = q;
      Joint joint;
      joint.anchor = {0, l, 0};
      model.joints.push_back(joint);
      Trial run(model, 0.01);
      run.until(5);
      ASSERT_GE(run.impacts.size(), 5u) << e;
      const double swing = 2 * std::sqrt(length / g);
      double time = swing / 2 * std::comp_ellint_1(std::sin(angle / 2)), k = std::sin(angle / 2);
      for (const Impact& impact : run.impacts) {
        // 1e-13 a step, of 500
        EXPECT_NEAR(impact.time, time, 1e-11) << e << ' ' << reduced;
        EXPECT_NEAR(impact.approach, 2 * std::sqrt(g * length) * k * l / length, 1e-10)
            << e << ' ' << reduced;
        EXPECT_NEAR(impact.separation, e * impact.approach, 1e-12);
        k *= e;
        time += swing * std::comp_ellint_1(k);
      }
      EXPECT_TRUE(sentences(run.stepper.diagnostics()).empty());
    }
  }
}

// A ball hangs on a spring over a plane that it strikes.  With y = 0 where spring and weight balance, d above
// the plane, and w = sqrt(k/m):  y = A cos(w t) meets -d at acos(-d/A)/w;  from there with speed u it is back
// after 2/w (pi - atan(u/(w d))).
TEST(EventExact, BallOnSpringStrikesPlane) {
  const double m = 1.3, k = 40, rest = 0.5, r = 0.1, d = 0.15, amplitude = 0.4, e = 0.8;
  const double w = std::sqrt(k / m), anchor = d + r + rest + m * g / k;
  Model model = with_plane(Vector3::UnitY(), 0, {e, 0.3});
  add_sphere(model, m, r, {0.2, r + d + amplitude, -0.1}, Vector3::Zero(), Vector3::Zero());
  Spring spring;
  spring.to_anchor = {0.2, anchor, -0.1};
  spring.stiffness = k;
  spring.rest_length = rest;
  model.forces.springs.push_back(spring);
  Trial run(model, 0.01);
  run.until(3);
  ASSERT_GE(run.impacts.size(), 4u);
  double time = std::acos(-d / amplitude) / w, u = w * std::sqrt(amplitude * amplitude - d * d);
  for (const Impact& impact : run.impacts) {
    EXPECT_NEAR(impact.time, time, 1e-11);
    EXPECT_NEAR(impact.approach, u, 1e-10);
    u *= e;
    time += 2 / w * (std::numbers::pi - std::atan(u / (w * d)));
  }
}

// A ball that spins and slides any way on a level plane.  Slip u = v - r w x n keeps its direction d and
// loses 7/2 mu g t; until it ends  v = v_0 - mu g t d,  w = w_0 + 5/2 mu g t (n x d)/r;  then it rolls.
TEST(EventExact, SpinningBallSlidesObliquelyThenRolls) {
  struct Case {
    double mu;
    Vector3 v, w;
  };
  const Vector3 n = Vector3(0.3, 1, -0.2).normalized(), across = n.cross(Vector3(0.2, 0.1, 1)).normalized();
  const Vector3 aside = n.cross(across);
  const Case cases[] = {{0.2, 2 * across + 0.5 * aside, 4 * aside + 7 * n - 3 * across},
                        {0.35, 1.5 * aside, 20 * aside - 10 * across},    // backspin
                        {0.1, Vector3::Zero(), 12 * across + 3 * aside},  // spin alone
                        {0.5, -1.2 * across, 12 * aside - 5 * n}};        // slips one way, goes the other
  const double m = 0.8, r = 0.12;
  for (const Case& c : cases) {
    Model model = with_plane(n, 0.3, {0.4, c.mu});
    model.forces.gravity = -g * n;
    const Vector3 p = (0.3 + r) * n + 0.7 * across;
    add_sphere(model, m, r, p, c.v, c.w);
    const Vector3 u = c.v - r * c.w.cross(n), d = u.normalized();
    const double end = 2 * u.norm() / (7 * c.mu * g);
    Trial run(model, 0.01);
    while (run.time < 1.5 * end) {
      run.step();
      const double t = std::min(run.time, end), after = run.time - t;
      const Vector3 v = c.v - c.mu * g * t * d, w = c.w + 2.5 * c.mu * g * t / r * n.cross(d);
      const Vector3 at = p + c.v * t - c.mu * g * t * t / 2 * d + v * after;
      ASSERT_LT((run.velocity(0) - v).norm(), 1e-12) << c.mu << " at " << run.time;
      ASSERT_LT((run.spin(0) - w).norm(), 1e-11) << c.mu << " at " << run.time;
      ASSERT_LT((run.motion(0).position - at).norm(), 1e-12) << c.mu << " at " << run.time;
    }
    EXPECT_TRUE(sentences(run.stepper.diagnostics()).empty());
  }
}

// One ball strikes two that touch, between them, all declared simultaneous.  Normals at +-30 degrees:
//   (2 + 1/2) P/m = (1 + e) v cos(30),   v' = v - 2 cos(30) P/m = v (1 - 3/5 (1 + e)).
TEST(EventExact, OneBallStrikesTwoThatTouch) {
  const Vector3 along = Vector3(0.3, -0.8, 0.5).normalized(), aside = along.unitOrthogonal();
  for (const double e : {0.0, 0.5, 1.0}) {
    Model model = without_plane({e, 0});
    model.impacts = Impacts::simultaneous;
    const double r = 0.25, v = 1.4, gap = 0.3, half = std::sqrt(3.0) / 2;
    add_sphere(model, 0.6, r, -(gap + 2 * r * half) * along, v * along, Vector3::Zero());
    for (const double side : {1.0, -1.0})
      add_sphere(model, 0.6, r, side * r * aside, Vector3::Zero(), Vector3::Zero());
    Trial run(model, 0.05);
    const Vector3 k = run.momentum(), l = run.angular_momentum();
    run.until(1);
    ASSERT_GE(run.impacts.size(), 2u);
    EXPECT_NEAR(run.impacts[0].time, gap / v, 1e-12);
    EXPECT_LT((run.velocity(0) - v * (1 - 0.6 * (1 + e)) * along).norm(), 1e-12) << e;
    for (const std::size_t i : {1u, 2u}) {
      const double side = i == 1 ? 1 : -1;
      const Vector3 normal = half * along + side / 2 * aside;
      EXPECT_LT((run.velocity(i) - (1 + e) * v * half / 2.5 * normal).norm(), 1e-12) << e;
    }
    EXPECT_LT((run.momentum() - k).norm(), 1e-15);
    EXPECT_LT((run.angular_momentum() - l).norm(), 1e-15);
  }
}

// Three balls that springs press together turn as one:  N = sqrt(3) stays, for all three of them touch.
// Without friction none of them spins:  p_i = R(w t) p_i(0).
TEST(EventExact, ThreePressedBallsRotateTogether) {
  Model model = without_plane({0.5, 0});
  const Vector3 axis = Vector3(0.2, 0.5, 1).normalized(), arm = axis.unitOrthogonal();
  const double r = 0.2, out = 2 * r / std::sqrt(3.0), w = 1.3;
  for (int i = 0; i < 3; ++i) {
    const Vector3 p = out * (exponential(2 * std::numbers::pi / 3 * i * axis) * arm);
    add_sphere(model, 0.9, r, p, w * axis.cross(p), Vector3::Zero());
  }
  for (int i = 0; i < 3; ++i) {
    Spring spring;
    spring.body = i;
    spring.to = (i + 1) % 3;
    spring.stiffness = 30;
    spring.rest_length = r;
    model.forces.springs.push_back(spring);
  }
  Trial run(model, 0.02);
  run.until(3);
  EXPECT_EQ(run.stepper.held().size(), 3u);
  EXPECT_TRUE(run.impacts.empty());
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3 p = exponential(w * 3 * axis) * model.motions[i].position;
    EXPECT_LT((run.motion(i).position - p).norm(), 1e-11);
    EXPECT_LT((run.velocity(i) - w * axis.cross(p)).norm(), 1e-11);
    EXPECT_LT(run.spin(i).norm(), 1e-15);
  }
  EXPECT_LT(run.momentum().norm(), 1e-14);
}

// A box lies on an incline, or falls flat on it, bounces at t_1 with u_1 = g cos t_1 and so on, and rests or
// slides.  The plane's impulse along n between two times is m g cos times the time, and the change of m v_n
// more.  So what slips all the time has  v = a T,  a = g (sin - mu cos);  what the first bounce stops, for
// mu (1 + e) > tan, and no other, for mu (1 + e)/2 < tan, has  v = mu e u_1 + a (T - t_1);  what every bounce
// stops rests.  What rests does not creep.
TEST(EventExact, BouncesOnARoughInclineEndInRestOrSliding) {
  struct Case {
    double height, friction;  // of tan
    enum { rests, slides, stopped_once } does;
  };
  const double theta = 0.5, e = 0.5, tangent = std::tan(theta);
  const Case cases[] = {{0, 1.5, Case::rests},
                        {0, 1 + 1e-9, Case::rests},
                        {0, 1 - 1e-9, Case::slides},
                        {0, 0.5, Case::slides},
                        {0.2, 2, Case::rests},
                        {0.2, 1 + 1e-6, Case::stopped_once},
                        {0.2, 1 - 1e-6, Case::stopped_once},
                        {0.2, 0.5, Case::slides}};
  const Vector3 normal(std::sin(theta), std::cos(theta), 0), down(std::cos(theta), -std::sin(theta), 0);
  for (const Case& c : cases) {
    const double mu = c.friction * tangent, t1 = std::sqrt(2 * c.height / (g * std::cos(theta)));
    Model model = with_plane(normal, 0, {e, mu});
    const Vector3 half(0.5, 0.1, 0.4);
    add_box(model, 1.2, half, (half.y() + c.height) * normal, exponential(Vector3(0, 0, -theta)),
            Vector3::Zero(), Vector3::Zero());
    Trial run(model, 0.01);
    run.until(1.2);
    ASSERT_LT(t1 * (1 + e) / (1 - e), 0.7);
    EXPECT_EQ(run.impacts.empty(), c.height == 0);
    const Motion first = run.motion(0);
    const double v = run.velocity(0).dot(down), a = g * (std::sin(theta) - mu * std::cos(theta));
    run.until(2.2);
    const std::string name = std::to_string(c.height) + " " + std::to_string(c.friction);
    EXPECT_NEAR(run.motion(0).position.dot(normal), half.y(), 1e-14) << name;
    EXPECT_LT(run.motion(0).orientation.angularDistance(model.motions[0].orientation), 1e-12) << name;
    EXPECT_TRUE(sentences(run.stepper.diagnostics()).empty())
        << name << ": " << sentences(run.stepper.diagnostics())[0];
    if (c.does == Case::rests) {
      EXPECT_EQ(run.motion(0).position, first.position) << name;
      EXPECT_EQ(run.motion(0).orientation.coeffs(), first.orientation.coeffs()) << name;
      EXPECT_TRUE(run.motion(0).momentum.isZero(0)) << name;
      continue;
    }
    const double u1 = g * std::cos(theta) * t1;
    EXPECT_NEAR(v, c.does == Case::slides ? a * 1.2 : mu * e * u1 + a * (1.2 - t1), 1e-12) << name;
    EXPECT_NEAR(run.velocity(0).dot(down) - v, a, 1e-12) << name;
    EXPECT_NEAR((run.motion(0).position - first.position).dot(down), v + a / 2, 1e-12) << name;
  }
}

}  // namespace
}  // namespace cylon::engine
