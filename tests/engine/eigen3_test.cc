// Principal axes: against the tensor, against given moments, and under small changes that must have no
// effect.
#include "engine/eigen3.h"

#include "engine/body.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <ostream>
#include <random>

namespace cylon::engine {
namespace {

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();

Matrix3 turned_tensor(const Matrix3& r, const Vector3& moments) {
  const Matrix3 a = r * moments.asDiagonal() * r.transpose();
  return (a + a.transpose()) / 2;
}

Matrix3 frame(Real x, Real y, Real z) { return exponential({x, y, z}).toRotationMatrix(); }

Real largest(const Matrix3& a) { return a.cwiseAbs().maxCoeff(); }

// 16 eps: three rotations a sweep, some five of them that turn by more than rounding, each worth half a
// rounding of every entry.
void expect_resolves(const Matrix3& a, const Principal& p) {
  const Matrix3& v = p.axes;
  EXPECT_LE(largest(v.transpose() * v - Matrix3::Identity()), 16 * epsilon);
  EXPECT_NEAR(v.determinant(), 1, 16 * epsilon);
  const Real scale = largest(a);
  const Matrix3 unit = a / scale;
  EXPECT_LE(largest(v * (p.moments / scale).asDiagonal() * v.transpose() - unit), 16 * epsilon);
  EXPECT_LE(p.moments[0], p.moments[1]);
  EXPECT_LE(p.moments[1], p.moments[2]);
}

struct Case {
  const char* name;
  Vector3 moments;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Eigen3 : public testing::TestWithParam<Case> {};

TEST_P(Eigen3, RecoversGivenMoments) {
  std::mt19937 random(7);
  for (int n = 0; n < 200; ++n) {
    const auto next = [&] { return static_cast<Real>(random()) / static_cast<Real>(4294967296.0) * 6 - 3; };
    const Real x = next(), y = next(), z = next();
    const Matrix3 a = turned_tensor(frame(x, y, z), GetParam().moments);
    const Principal p = principal(a);
    expect_resolves(a, p);
    // The tensor's own rounding, 16 eps of the greatest moment, and that of the moments found.
    EXPECT_LE((p.moments - GetParam().moments).cwiseAbs().maxCoeff(), 32 * epsilon * GetParam().moments[2]);
  }
}

TEST_P(Eigen3, IsScaleInvariant) {
  const int far = std::numeric_limits<Real>::max_exponent10 / 2;  // squares are out of range on either side
  const Matrix3 a = turned_tensor(frame(Real(0.3), Real(-0.7), Real(0.4)), GetParam().moments);
  const Principal here = principal(a);
  for (const int exponent : {far, -far}) {
    const int bits = static_cast<int>(exponent * 3.3);
    const Matrix3 moved = a.unaryExpr([&](Real x) { return std::ldexp(x, bits); });
    const Principal there = principal(moved);
    EXPECT_EQ(there.axes, here.axes);
    EXPECT_EQ(there.moments, Vector3(here.moments.unaryExpr([&](Real x) { return std::ldexp(x, bits); })));
    const Real factor = std::pow(Real(10), static_cast<Real>(exponent));  // no power of two
    expect_resolves(factor * a, principal(factor * a));
  }
}

// A change of a few roundings must move the axes by no more than the gap between the moments allows; where
// moments are equal, by no more than rounding.  sin(angle) <= |change|/gap: C. Davis, W. Kahan, SIAM J.
// Numer. Anal. 7 (1970) 1, theorem of sin theta.
TEST_P(Eigen3, IgnoresNoise) {
  const Matrix3 a = turned_tensor(frame(Real(0.3), Real(-0.7), Real(0.4)), GetParam().moments);
  const Principal before = principal(a);
  const Real noise = 2 * epsilon * largest(a);
  Matrix3 change;
  change << 1, Real(-0.7), Real(0.4), Real(-0.7), Real(-0.9), Real(0.6), Real(0.4), Real(0.6), Real(0.5);
  const Principal after = principal(a + noise * change);
  const Vector3& m = GetParam().moments;
  Real gap = m[2];
  for (const Real g : {m[1] - m[0], m[2] - m[1]})
    if (g > 0) gap = std::min(gap, g);
  EXPECT_LE(largest(after.axes - before.axes), 16 * epsilon + 8 * noise / gap);
}

INSTANTIATE_TEST_SUITE_P(
    Bodies, Eigen3,
    testing::Values(Case{"general", {Real(0.5), Real(0.7), Real(1.1)}},
                    Case{"far_apart", {Real(0.003), Real(0.9), Real(0.95)}},
                    Case{"flat", {Real(0.4), Real(0.7), Real(1.1)}},
                    Case{"long", {Real(0.2), Real(1.3), Real(1.3)}},
                    Case{"disc", {Real(0.6), Real(0.6), Real(1.2)}},
                    Case{"thin_rod", {Real(0), Real(1.7), Real(1.7)}},
                    Case{"sphere", {Real(0.8), Real(0.8), Real(0.8)}},
                    Case{"nearly_long", {Real(0.2), Real(1.3), Real(1.3) * (1 + 4096 * epsilon)}},
                    Case{"nearly_sphere",
                         {Real(0.8), Real(0.8) * (1 + 4096 * epsilon), Real(0.8) * (1 + 8192 * epsilon)}}),
    testing::PrintToStringParamName());

// ---- Conventions ------------------------------------------------------------------------------------

TEST(Eigen3, DiagonalInOrderIsLeftAlone) {
  for (const Vector3& m : {Vector3(Real(0.1), Real(0.2), Real(0.7)), Vector3(Real(0.2), Real(0.2), Real(0.7)),
                           Vector3(Real(0.2), Real(0.7), Real(0.7)), Vector3(Real(0.3), Real(0.3), Real(0.3)),
                           Vector3(0, Real(0.3), Real(0.3)), Vector3(0, 0, 0)}) {
    const Principal p = principal(Matrix3(m.asDiagonal()));
    EXPECT_EQ(p.axes, Matrix3(Matrix3::Identity())) << m.transpose();
    EXPECT_EQ(p.moments, m);
  }
}

TEST(Eigen3, DiagonalOutOfOrderIsPermuted) {
  const Real a = Real(0.1), b = Real(0.2), c = Real(0.7);
  for (const Vector3& m : {Vector3(a, c, b), Vector3(b, a, c), Vector3(b, c, a), Vector3(c, a, b),
                           Vector3(c, b, a), Vector3(b, c, b), Vector3(c, b, c), Vector3(b, a, b)}) {
    const Principal p = principal(Matrix3(m.asDiagonal()));
    EXPECT_EQ(p.axes.cwiseAbs() * Vector3::Ones(), Vector3(Vector3::Ones())) << p.axes;
    EXPECT_EQ(p.axes.determinant(), 1);
    EXPECT_EQ(Vector3(p.axes.cwiseAbs() * p.moments), m);
  }
}

TEST(Eigen3, EqualMomentsUseNearestAxes) {
  const Matrix3 tilt = frame(Real(0.2), Real(-0.1), Real(0.15));
  const Principal sphere = principal(turned_tensor(tilt, Vector3::Constant(Real(0.8))));
  EXPECT_EQ(sphere.axes, Matrix3(Matrix3::Identity()));
  EXPECT_EQ(sphere.moments[0], sphere.moments[2]);
  // A disc: the frame tilts as its axis does and does not turn about it.
  const Principal disc = principal(turned_tensor(tilt, {Real(0.6), Real(0.6), Real(1.2)}));
  const Vector3 n = tilt.col(2), turn = Vector3::UnitZ().cross(n);
  const Matrix3 least = exponential(turn / turn.norm() * std::asin(turn.norm())).toRotationMatrix();
  EXPECT_LE(largest(disc.axes - least),
            64 * epsilon);  // 16 of the tensor's over the gap of a half, and asin's
  EXPECT_EQ(disc.moments[0], disc.moments[1]);
}

TEST(Eigen3, SmallMomentsKeepRelativePrecision) {
  // A = S B S with S = diag(1, d, d^2) and B near 1: each moment is known to rounding relative to itself,
  // which no method that first makes A tridiagonal gives (Demmel, Veselic 1992).
  const Real d = sizeof(Real) == 8 ? Real(0x1p-20) : Real(0x1p-9);
  Matrix3 a;
  a << 1, Real(0.25) * d, Real(0.125) * d * d,  //
      Real(0.25) * d, d * d, Real(0.25) * d * d * d, Real(0.125) * d * d, Real(0.25) * d * d * d,
      d * d * d * d;
  const Principal p = principal(a);
  // To first order in d^2: Schur complements 1, (1 - 1/16) d^2, and det B / (1 - 1/16) d^4.
  const Real det = 1 - Real(1) / 16 - Real(1) / 16 - Real(1) / 64 + 2 * Real(1) / 128;
  const Real order = 4 * d * d + 16 * epsilon;  // the next order, and rounding
  EXPECT_NEAR(p.moments[2], 1, order);
  EXPECT_NEAR(p.moments[1] / (d * d), Real(15) / 16, order);
  EXPECT_NEAR(p.moments[0] / (d * d * d * d), det / (Real(15) / 16), order);
}

TEST(Body, ThinRodHasNoSpinAboutItsAxis) {
  const Matrix3 r = frame(Real(0.9), Real(-0.4), Real(1.3));
  const Body rod = make_body(2, turned_tensor(r, {0, Real(1.7), Real(1.7)}));
  EXPECT_EQ(rod.inverse_moments[0], 0);
  EXPECT_LE((rod.inverse_inertia * r.col(0)).norm(), 16 * epsilon);
  EXPECT_LE((rod.inverse_inertia * r.col(1) - r.col(1) / Real(1.7)).norm(), 16 * epsilon);
  // The control: a moment above the limit counts.
  const Body bar = make_body(2, turned_tensor(r, {Real(1e-3), Real(1.7), Real(1.7)}));
  EXPECT_NEAR(bar.inverse_moments[0] * Real(1e-3), 1, 32 * epsilon * 1700);
}

}  // namespace
}  // namespace cylon::engine
