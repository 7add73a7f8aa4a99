// What the event stepper must keep whatever the scene: rest, conservation, no tunnelling, general pairs,
// order.
#include "tests/engine/contact/contact_fixtures.h"

namespace cylon::engine {
namespace {

// Static rest is exact: not a bit moves.
TEST(EventContact, RestIsExact) {
  const Quaternion turn = exponential(Vector3(0.1, 0.7, -0.2));
  Model box = with_plane(turn * Vector3::UnitY(), 0.3, {0.4, 0.5});
  add_box(box, 1.7, {0.5, 0.3, 0.4}, turn * Vector3(0.2, 0.6, -0.1), turn, Vector3::Zero(), Vector3::Zero());

  Model corner = with_plane(Vector3(0.3, 1, 0.2).normalized(), 0, {0.5, 0.1});
  corner.planes.push_back({Vector3(-0.9, 0.4, 0.1).normalized(), -0.1});
  corner.planes.push_back({Vector3(0.1, 0.5, -0.8).normalized(), -0.2});
  corner.plane_surfaces.assign(3, 1);
  Matrix3 normals;
  Vector3 offsets;
  for (int i = 0; i < 3; ++i) {
    normals.row(i) = corner.planes[static_cast<std::size_t>(i)].normal;
    offsets[i] = corner.planes[static_cast<std::size_t>(i)].offset + Real(0.25);
  }
  add_sphere(corner, 0.8, 0.25, normals.inverse() * offsets, Vector3::Zero(), Vector3::Zero());

  for (const Model& model : {box, corner}) {
    Trial run(model, 0.01);
    run.step();
    const Motion first = run.motion(0);
    EXPECT_LT((first.position - model.motions[0].position).norm(), 1e-15);
    run.until(2);
    EXPECT_EQ(run.motion(0).position, first.position);
    EXPECT_EQ(run.motion(0).orientation.coeffs(), first.orientation.coeffs());
    EXPECT_TRUE(run.motion(0).momentum.isZero(0));
    EXPECT_TRUE(run.impacts.empty());
  }
}

// Steeper than friction holds, the same box slides: the test above could have failed.
TEST(EventContact, BoxOnSteepSlopeSlides) {
  const Quaternion turn = exponential(Vector3(0.1, 0.7, -0.6));
  Model box = with_plane(turn * Vector3::UnitY(), 0.3, {0.4, 0.5});
  add_box(box, 1.7, {0.5, 0.3, 0.4}, turn * Vector3(0.2, 0.6, -0.1), turn, Vector3::Zero(), Vector3::Zero());
  Trial run(box, 0.01);
  run.until(0.5);
  // a = g (sin - mu cos)
  const Real c = (turn * Vector3::UnitY()).y(), s = std::sqrt(1 - c * c);
  EXPECT_GT(s / c, 0.5);
  EXPECT_NEAR(run.velocity(0).norm(), 9.81 * (s - 0.5 * c) * 0.5, 1e-11);
}

TEST(EventContact, IsolatedBodiesConserveMomenta) {
  Model model = without_plane({0.6, 0.4});
  add_box(model, 1.3, {0.3, 0.2, 0.4}, {-1, 0.05, 0.1}, exponential(Vector3(0.3, 0.4, 0.1)), {2, 0.1, 0},
          {1, 2, -1});
  add_box(model, 0.9, {0.25, 0.35, 0.2}, {0.6, 0, 0}, exponential(Vector3(-0.3, 0.9, 0.5)), {-1, 0, 0.1},
          {-2, 0.5, 1});
  add_sphere(model, 0.7, 0.3, {0.1, 1.6, 0.1}, {0, -2, 0}, {3, 1, 2});
  Trial run(model, 0.02);
  const Vector3 k = run.momentum(), l = run.angular_momentum();
  Real energy = run.energy();
  while (run.time < 1.5) {
    run.step();
    EXPECT_LE(run.energy(), energy * (1 + 1e-11));
    energy = run.energy();
  }
  EXPECT_GE(run.impacts.size(), 2u);
  EXPECT_LT((run.momentum() - k).norm(), 1e-14);
  EXPECT_LT((run.angular_momentum() - l).norm(),
            1e-11);  // flight between impacts at the integrator's tolerance
}

TEST(EventContact, NoTunnelling) {
  // A ball of 1 cm at 700 m/s against one of 2 cm: in one step it passes 14 m.
  Model model = without_plane({1, 0});
  add_sphere(model, 0.1, 0.01, {-5, 0.003, 0}, {700, 0, 0}, Vector3::Zero());
  add_sphere(model, 0.1, 0.02, {3, 0, 0.002}, Vector3::Zero(), Vector3::Zero());
  Trial balls(model, 0.02);
  balls.step();
  ASSERT_EQ(balls.impacts.size(), 1u);
  // and a plate of 2 mm that turns
  Model plate = without_plane({0.5, 0.2});
  add_sphere(plate, 0.1, 0.01, {-5, 0.003, 0.1}, {700, 0, 0}, Vector3::Zero());
  add_box(plate, 1, {0.001, 0.3, 0.3}, {1, 0, 0}, Quaternion::Identity(), Vector3::Zero(), {0, 1, 0.5});
  Trial hit(plate, 0.02);
  hit.step();
  EXPECT_GE(hit.impacts.size(), 1u);
  // a miss is a miss
  Model miss = model;
  miss.motions[0].position.y() = 0.031;
  Trial none(miss, 0.02);
  none.step();
  EXPECT_TRUE(none.impacts.empty());
}

TEST(EventContact, BoxRestsOnBox) {
  Model model = with_plane(Vector3::UnitY(), 0, {0, 0.5});
  add_box(model, 2, {0.5, 0.25, 0.5}, {0.1, 0.25, 0}, Quaternion::Identity(), Vector3::Zero(),
          Vector3::Zero());
  add_box(model, 1, {0.3, 0.2, 0.3}, {0.2, 0.7, 0.1}, exponential(Vector3(0, 0.4, 0)), Vector3::Zero(),
          Vector3::Zero());
  Trial run(model, 0.01);
  run.until(1);
  EXPECT_LT((run.motion(0).position - model.motions[0].position).norm(), 1e-13);
  EXPECT_LT((run.motion(1).position - model.motions[1].position).norm(), 1e-13);
}

TEST(EventContact, SphereRollsOffALockedBall) {
  // 7/10 v^2 = g (R + r)(cos th_0 - cos th), and N = 0 where v^2 = g (R + r) cos th:  cos th = 10/17 cos
  // th_0.
  const Real gravity = Real(9.81), r = 0.2, far = 1.2, start = 0.3, mu = 50;
  Model model = with_plane(Vector3::UnitY(), -50, {0, mu});
  add_sphere(model, 1, far - r, Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), true);
  add_sphere(model, 1, r, far * Vector3(std::sin(start), std::cos(start), 0), Vector3::Zero(),
             Vector3::Zero());
  Trial run(model, 0.005);
  while (run.time < 2 && run.stepper.held().size() == 1) run.step();
  ASSERT_LT(run.time, 1.9);
  const Real cosine = Real(10) / 17 * std::cos(start), sine = std::sqrt(1 - cosine * cosine);
  const Real v = std::sqrt(gravity * far * cosine), friction = Real(2) / 7 * gravity * sine;
  // While N < T/mu it slips; N falls at g sin th th' + 2 v v'/(R + r), so for dt = (T/mu)/N', in which
  // friction is half of T on the average.  The next order is dt th' = 0.3 %, on a correction of 0.1 %.
  const Real fall = gravity * sine * v / far + 2 * v * Real(5) / 7 * gravity * sine / far;
  const Real slip_time = friction / mu / fall;
  const Real lost_spin = friction * r / (Real(0.4) * r * r) * slip_time / 2,
             won_speed = friction * slip_time / 2;
  EXPECT_NEAR(run.spin(1).norm(), v / r - lost_spin, Real(0.15) * lost_spin);
  const Real energy = run.velocity(1).squaredNorm() / 2 + gravity * run.motion(1).position.y();
  EXPECT_NEAR(energy, v * v / 2 + gravity * far * cosine + v * won_speed, Real(0.15) * v * won_speed);
}

TEST(EventContact, FixedStepsKeepOrderThroughImpacts) {
  // A damped, bouncing ball: drag makes the flight inexact, the impact is located inside the step.
  const auto end = [](double dt) {
    Model model = with_plane(Vector3(0.2, 1, -0.1).normalized(), 0, {0.7, 0.2});
    add_sphere(model, 1, 0.2, {0, 1, 0}, {0.4, 0, 0.1}, {1, 2, 3});
    model.forces.drags.push_back({0, 0.8, 0.1, 0});
    Trial run(model, dt, "rk4");
    run.until(0.8);
    EXPECT_EQ(run.impacts.size(), 1u);
    return Vector3(run.motion(0).position);
  };
  const Vector3 a = end(0.1), b = end(0.05), c = end(0.025);
  const Real order = std::log2((a - b).norm() / (b - c).norm());
  EXPECT_GT(order, 3.5);
}

TEST(EventContact, SplittingsSupportContacts) {
  Model model = with_plane(Vector3::UnitY(), 0, {0, 0.3});
  add_sphere(model, 1, 0.5, {0, 0.5, 0}, {5, 0, 0}, Vector3::Zero());
  Trial run(model, 0.02, "velocity-verlet");
  run.until(2);
  EXPECT_NEAR(run.motion(0).position.x(), 7.48958094960716192695, 1e-11);
}

TEST(EventContact, RepeatsBits) {
  std::vector<Vector3> ends;
  for (int i = 0; i < 2; ++i) {
    Model model = with_plane(Vector3(0.1, 1, 0.2).normalized(), 0, {0.4, 0.3});
    add_box(model, 1, {0.3, 0.2, 0.25}, {0, 1, 0}, exponential(Vector3(0.4, 0.5, 0.6)), {0.3, 0, 0},
            {1, 2, 3});
    Trial run(model, 0.01);
    run.until(1);
    ends.push_back(run.motion(0).position);
  }
  EXPECT_EQ(ends[0], ends[1]);
}

}  // namespace
}  // namespace cylon::engine
