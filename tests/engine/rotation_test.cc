// Finite rotations and the body's inverses.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

// The matrix of a rotation by b, seed eq. 27.
Matrix3 rodrigues(const Vector3& b) {
  return Eigen::AngleAxis<Real>(b.norm(), b.normalized()).toRotationMatrix();
}

TEST(Rotation, ExponentialIsTheRotationByAnyAngle) {
  const Vector3 axis = Vector3(0.4, -0.7, 0.2).normalized();
  for (const Real b : {1e-9, 5e-6, 1e-3, 0.1, 0.1999, 0.2, 0.2001, 1.0, 3.0, 7.0}) {
    const Quaternion q = exponential(b * axis);
    EXPECT_NEAR(q.norm(), 1, 4e-16) << b;
    EXPECT_LT((q.toRotationMatrix() - rodrigues(b * axis)).norm(), 2e-15) << b;
  }
}

// Errata 45: the seed drops rotations below 1e-5.  A hundred thousand turns of w dt = 5e-6 make half a
// radian.
TEST(Rotation, TinyRotationsAddUp) {
  const Vector3 step = 5e-6 * Vector3(0.4, -0.7, 0.2).normalized();
  Quaternion q = Quaternion::Identity();
  for (int i = 0; i < 100000; ++i) q = turned(q, step);
  EXPECT_NEAR(angle(q, exponential(1e5 * step)), 0, 1e-12);
  EXPECT_NEAR(angle(q, Quaternion::Identity()), 0.5, 1e-12);
  EXPECT_NEAR(q.norm(), 1, 4e-16);
}

// d/ds exp(u + s du) at s = 0 turns with w when du = dexp^-1_u w.
TEST(Rotation, InverseDexpIsTheDerivativeOfTheLogarithm) {
  const Vector3 u = {0.3, -0.2, 0.25}, w = {0.7, 1.1, -0.4};
  const Vector3 du = inverse_dexp(u, w);
  const Real s = 1e-5;
  const Quaternion turn = exponential(u + s * du) * exponential(u - s * du).conjugate();  // exp(2 s w)
  EXPECT_LT((2 * turn.vec() - 2 * s * w).norm() / (2 * s), 1e-8);
  // Negative control: without the correction it is not.
  const Quaternion wrong = exponential(u + s * w) * exponential(u - s * w).conjugate();
  EXPECT_GT((2 * wrong.vec() - 2 * s * w).norm() / (2 * s), 1e-2);
}

class Spin : public EveryIntegrator {};

// A ball that spins turns by w t, whatever the integrator and however small the step.
TEST_P(Spin, OfABallIsExact) {
  Model start;
  const Vector3 w = {0.002, -0.003, 0.0035};
  add_body(start, make_body(0.9, Matrix3::Identity() * 0.3), {1, 2, 3}, {0.4, 0.5, 0.6}, {0, 0, 0}, w);
  const Outcome end = run(start, GetParam().name, 10.0, 10000);  // w dt = 5e-6
  // Every drift or stage is the same turn, and so may its rounding be: an ulp each.
  const Real rounding = 10000 * (GetParam().evaluations + 1) * std::numeric_limits<Real>::epsilon();
  EXPECT_LT(angle(end.motions[0].orientation, exponential(10.0 * w) * start.motions[0].orientation),
            rounding);
}

// Angular momentum stays in world axes, whatever the body does (errata 42: a constant inertia would never
// precess).
TEST_P(Spin, OfAFreeTopKeepsItsAngularMomentumAndPrecesses) {
  const Model start = free_top();
  const Outcome end = run(start, GetParam().name, 2.0, 2000);
  EXPECT_EQ(end.motions[0].angular_momentum, start.motions[0].angular_momentum);
  const Vector3 before = angular_velocity(start.bodies[0], start.motions[0]);
  EXPECT_GT((angular_velocity(end.bodies[0], end.motions[0]) - before).norm(), 0.5);
}

// The free rotation of a symmetric body has no truncation error: R = exp(t L/I1) R0 exp(t (1 - I3/I1) w3 e3).
TEST(FreeRotation, OfASymmetricTopIsExact) {
  Model start;
  const Vector3 w = {1.0, 0.3, 10.0};  // body axes
  add_body(start, make_body(1, Vector3(1, 1, 2).asDiagonal()), {0, 0, 0}, {0.3, 0.4, 0.5}, {0, 0, 0},
           exponential({0.3, 0.4, 0.5}) * w);
  const Outcome end = run(start, "velocity-verlet", 20.0, 2000);
  const Quaternion exact = exponential(20.0 * start.motions[0].angular_momentum) *
                           start.motions[0].orientation *
                           exponential(20.0 * (1 - 2.0) * w.z() * Vector3::UnitZ());
  EXPECT_LT(angle(end.motions[0].orientation, exact), 1e-11);
}

TEST(Body, KeepsInitialVelocities) {
  const Body body = make_body(1.7, general_inertia(0.2, 0.35, 0.5));
  const Vector3 v = {0.3, -1.1, 0.7}, w = {2.0, -3.0, 0.5};
  const Motion motion = make_motion(body, {1, 2, 3}, exponential({0.5, -0.4, 1.2}), v, w);
  EXPECT_LT((velocity(body, motion) - v).norm(), 1e-15);
  EXPECT_LT((angular_velocity(body, motion) - w).norm(), 3e-15);
}

TEST(Body, ThinRodDoesNotSpinAboutItsAxis) {
  for (const Matrix3& inertia : {Matrix3(Vector3(0.4, 0, 0.4).asDiagonal()), general_inertia(0.4, 0, 0.4)}) {
    const Body rod = make_body(1, inertia);
    const Motion motion =
        make_motion(rod, {0, 0, 0}, exponential({0.5, 0.1, 0.2}), {0, 0, 0}, {1.0, 2.0, 0.3});
    const Vector3 w = angular_velocity(rod, motion);
    EXPECT_TRUE(w.allFinite());
    EXPECT_LT((make_motion(rod, {0, 0, 0}, motion.orientation, {0, 0, 0}, w).angular_momentum -
               motion.angular_momentum)
                  .norm(),
              1e-14);
    EXPECT_LT(w.norm(), 2.2);
  }
}

// Pulled through its centre and slowed, but never turned: no rounding creeps in.
TEST_P(Spin, WhatNothingTurnsKeepsItsOrientationExactly) {
  Model start;
  add_body(start, make_body(0.7, general_inertia(0.2, 0.3, 0.4)), {0.5, 0.2, -0.3}, {0.1, 0.2, 0.3},
           {0.3, 0.1, 0.2}, {0, 0, 0});
  start.forces.gravity = {0.1, -9.81, 0.2};
  start.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0.1, 0.9, 0.4}, 20, 0.3, 0.2});
  start.forces.drags.push_back({0, 0.2, 0.1, 0.3});
  const Outcome end = run(start, GetParam().name, 1.0, 1000);
  EXPECT_EQ(end.motions[0].orientation.coeffs(), start.motions[0].orientation.coeffs());
  EXPECT_EQ(end.motions[0].angular_momentum, Vector3(Vector3::Zero()));
}

CYLON_EVERY_SCHEME(Spin);

}  // namespace
}  // namespace cylon::engine
