// Ball joints, springs at their pins, what stays constant, and the same bits twice.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

// The distance between the ends of a joint [m].
Real joint_gap(const World& w, const BallJoint& joint) {
  const auto place = [&](int body, const Vector3& anchor) -> Vector3 {
    if (body == fixed_world) return anchor;
    const Motion& m = w.motion()[static_cast<std::size_t>(body)];
    return m.position + m.orientation * anchor;
  };
  return (place(joint.body, joint.anchor) - place(joint.to, joint.to_anchor)).norm();
}

// Two bodies without symmetry on a ball joint between them; the first one hangs on the world where `pinned`.
Start linked_bodies(bool pinned) {
  Start start;
  const Vector3 a0 = {0.3, -0.2, 0.1}, a1 = {-0.4, 0.1, 0.2}, b0 = {0.2, 0.3, -0.1};
  const Body first = make_body(1.3, general_inertia(0.05, 0.07, 0.1));
  const Body second = make_body(0.8, general_inertia(0.02, 0.035, 0.04));
  const Vector3 turn_a = {0.5, 1.1, -0.6}, turn_b = {-1.3, 0.2, 0.8};
  const Vector3 w_a = {1.2, -0.7, 0.9}, w_b = {-0.8, 1.5, 0.4}, pivot = {0.1, 0.2, 0.3};
  const Vector3 p_a = pivot - exponential(turn_a) * a0;
  const Vector3 v_a = pinned ? Vector3(w_a.cross(p_a - pivot)) : Vector3(0.3, 0.8, -0.5);
  const Vector3 r_a = exponential(turn_a) * a1, r_b = exponential(turn_b) * b0;
  add_body(start, first, p_a, turn_a, v_a, w_a);
  add_body(start, second, p_a + r_a - r_b, turn_b, v_a + w_a.cross(r_a) - w_b.cross(r_b), w_b);
  start.model.joints.push_back({0, a1, 1, b0});
  if (pinned) {
    start.model.joints.push_back({0, a0, fixed_world, pivot});
    start.model.forces.gravity = {0, -9.81, 0};
  }
  return start;
}

class Mechanism : public EveryIntegrator {};

TEST_P(Mechanism, JointsStayClosed) {
  for (const Start& start : {heavy_top(), linked_bodies(true), linked_bodies(false)}) {
    World running(start.model, start.motion, GetParam(), 1e-3);
    for (int i = 0; i < 1000; ++i) {
      running.step();
      for (const BallJoint& joint : start.model.joints) ASSERT_LT(joint_gap(running, joint), 1e-14) << i;
    }
  }
}

TEST_P(Mechanism, ADoublePendulumHasTheOrderOfItsScheme) {
  const Start start = linked_bodies(true);
  const int n = GetParam().order == 4 ? 128 : GetParam().order == 2 ? 1024 : 16384;
  const World exact = run(start, *find_integrator("rk4"), 0.5, 4096);
  const Real coarse = distance(run(start, GetParam(), 0.5, n), exact);
  const Real fine = distance(run(start, GetParam(), 0.5, 2 * n), exact);
  EXPECT_NEAR(std::log2(coarse / fine), GetParam().order, 0.1);
}

TEST_P(Mechanism, IsolatedBodiesKeepTheirMomentum) {
  for (const Start& start : {coupled_bodies(), coupled_bodies(0.4), linked_bodies(false)}) {
    const World end = run(start, GetParam(), 5.0, 5000);
    EXPECT_LT((momentum(end.motion()) - momentum(start.motion)).norm(),
              1e-13);  // 5000 steps of 2e-16, measured 1e-14
  }
}

// Kick and drift each keep p x K + L; a Runge-Kutta step mixes the two.
TEST_P(Mechanism, SplittingSchemesKeepAngularMomentum) {
  const Start start = coupled_bodies(0.4);
  const World end = run(start, GetParam(), 5.0, 500);
  const Real drift = (angular_momentum(end.motion()) - angular_momentum(start.motion)).norm();
  const bool keeps = GetParam().name == "velocity-verlet" || GetParam().name == "symplectic-euler";
  if (keeps) {
    EXPECT_LT(drift, 1e-13);
  } else {
    EXPECT_GT(drift, 1e-12);
  }
}

TEST_P(Mechanism, TheSameStartGivesTheSameBits) {
  for (const Start& start : {forced_bodies(), linked_bodies(true), ball_over_plane(0.5, 0.8)}) {
    const World a = run(start, GetParam(), 1.0, 500), b = run(start, GetParam(), 1.0, 500);
    for (std::size_t i = 0; i < a.motion().size(); ++i) {
      EXPECT_EQ(a.motion()[i].position, b.motion()[i].position);
      EXPECT_EQ(a.motion()[i].momentum, b.motion()[i].momentum);
      EXPECT_EQ(a.motion()[i].orientation.coeffs(), b.motion()[i].orientation.coeffs());
      EXPECT_EQ(a.motion()[i].angular_momentum, b.motion()[i].angular_momentum);
    }
  }
}

CYLON_EVERY_INTEGRATOR(Mechanism);

// Energy bounded is what symplectic means: the error of a long run is no larger than that of a short one.
TEST(Symplectic, EnergyErrorDoesNotGrowAndExplicitEulersDoes) {
  const auto error = [](const Start& start, std::string_view scheme, Real duration) {
    World running(start.model, start.motion, *find_integrator(scheme), 0.01);
    const Real before = kinetic_energy(running.bodies(), running.motion());
    Real worst = 0;
    for (int i = 0; i < static_cast<int>(duration / 0.01); ++i) {
      running.step();
      worst = std::max(worst, std::abs(kinetic_energy(running.bodies(), running.motion()) - before));
    }
    return worst;
  };
  for (const std::string_view scheme : {"velocity-verlet", "symplectic-euler"}) {
    EXPECT_LT(error(free_top(), scheme, 200), 1.1 * error(free_top(), scheme, 20)) << scheme;
  }
  EXPECT_GT(error(free_top(), "explicit-euler", 40), 1.5 * error(free_top(), "explicit-euler", 20));
}

// Two ball joints on one line are a hinge: a compound pendulum, with one condition too many.
TEST(Redundant, TwoBallJointsMakeAHinge) {
  Start start;
  const Real mass = 1.2, length = 0.4, about_axis = 0.03;  // moment about the centre of mass
  const Vector3 axis = {0, 0, 1}, turn = 0.5 * axis, pivot = {0.2, 0.1, -0.3};
  const Body body = make_body(mass, Vector3(0.05, 0.04, about_axis).asDiagonal());
  const Vector3 a = {0, length, -0.2}, b = {0, length, 0.3};
  const Vector3 centre = pivot - exponential(turn) * Vector3(0, length, 0);
  add_body(start, body, centre, turn, {0, 0, 0}, {0, 0, 0});
  start.model.forces.gravity = {0, -9.81, 0};
  for (const Vector3& anchor : {a, b}) {
    start.model.joints.push_back({0, anchor, fixed_world, centre + exponential(turn) * anchor});
  }
  // theta'' = -(m g l / (I + m l^2)) sin theta, by a Runge-Kutta of its own with tiny steps.
  Real theta = 0.5, rate = 0;
  const Real k = mass * 9.81 * length / (about_axis + mass * length * length), h = 1e-4;
  for (int i = 0; i < 10000; ++i) {
    const Real k1 = -k * std::sin(theta), k2 = -k * std::sin(theta + h / 2 * rate);
    const Real k3 = -k * std::sin(theta + h / 2 * rate + h * h / 4 * k1);
    const Real k4 = -k * std::sin(theta + h * rate + h * h / 2 * k2);
    theta += h * rate + h * h / 6 * (k1 + k2 + k3);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  const World end = run(start, *find_integrator("rk4"), 1.0, 1000);
  EXPECT_LT(angle(end.motion()[0].orientation, exponential(theta * axis)), 1e-10);
  for (const BallJoint& joint : start.model.joints) EXPECT_LT(joint_gap(end, joint), 1e-14);
}

// A ball joint to a locked body is one to the world.
TEST(Locked, HoldsAJointLikeTheWorld) {
  const Start free = heavy_top();
  Start locked = free;
  add_body(locked, make_body(0.3, general_inertia(0.1, 0.2, 0.25), true), {1, 2, 3}, {0.3, -0.4, 0.5},
           {0, 0, 0}, {0, 0, 0});
  BallJoint& joint = locked.model.joints[0];
  joint.to = 1;
  joint.to_anchor = locked.motion[1].orientation.conjugate() * (joint.to_anchor - locked.motion[1].position);
  const World a = run(free, *find_integrator("rk4"), 1.0, 1000),
              b = run(locked, *find_integrator("rk4"), 1.0, 1000);
  EXPECT_LT((a.motion()[0].position - b.motion()[0].position).norm(), 1e-12);
}

// Errata 47, 48: at its pin a spring has no direction; it must not make NaN, and from there it pulls back.
TEST(Spring, AtItsPinIsHarmless) {
  for (const Real rest_length : {0.0, 0.4}) {
    for (const Real damping : {0.0, 0.3}) {
      Start start;
      add_body(start, make_body(1.1, Matrix3::Identity()), {0.5, -0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
      start.model.forces.springs.push_back(
          {0, {0, 0, 0}, fixed_world, {0.5, -0.2, 0.3}, 30.0, rest_length, damping});
      const World still = run(start, *find_integrator("rk4"), 0.1, 100);
      EXPECT_EQ(still.motion()[0].position, start.motion[0].position);

      start.motion[0].momentum = {0.3, 0.1, 0.2};
      EXPECT_TRUE(run(start, *find_integrator("rk4"), 5.0, 1000).motion()[0].position.allFinite());
    }
  }
}

// x'' = (F/m) cos(wt) - (c/m) x': every number of the closed form at once.
TEST(Drive, WithDragIsTheClosedForm) {
  Start start;
  const Real m = 1.3, c = 0.6, w = 2.3;
  const Vector3 force = {0.9, -0.4, 1.1};
  add_body(start, make_body(m, Matrix3::Identity()), {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  start.model.forces.drives.push_back({0, force, w});
  start.model.forces.drags.push_back({0, c, 0, 0});
  const Real t = 2.0, s = c / m;
  // v = F/m (s cos wt + w sin wt - s e^-st) / (s^2 + w^2)
  const Vector3 v =
      force / m * ((s * std::cos(w * t) + w * std::sin(w * t) - s * std::exp(-s * t)) / (s * s + w * w));
  const World end = run(start, *find_integrator("rk4"), t, 2000);
  EXPECT_LT((velocity(end.bodies()[0], end.motion()[0]) - v).norm(), 1e-12);
}

// L' = -momentum L, exactly exponential whatever the body (errata 51).
TEST(Drag, OfTheSpinDecaysExponentially) {
  Start start = free_top();
  start.model.forces.drags.push_back({0, 0, 0, 0.7});
  const World end = run(start, *find_integrator("rk4"), 2.0, 2000);
  EXPECT_LT((end.motion()[0].angular_momentum - std::exp(-1.4) * start.motion[0].angular_momentum).norm(),
            1e-12);
}

}  // namespace
}  // namespace cylon::engine
