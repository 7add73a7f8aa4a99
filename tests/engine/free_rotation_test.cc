// Free rotation against recorded exact motions, its own symmetries, and a Runge-Kutta run of Euler's
// equations.
#include "engine/free_rotation.h"

#include "engine/integrators/advance.h"
#include "tests/engine/scheme_systems.h"
#include "tests/paths.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <fstream>
#include <iostream>
#include <limits>
#include <string>

namespace cylon::engine {
namespace {

constexpr double eps = std::numeric_limits<Real>::epsilon();

double apart(const Quaternion& a, const Quaternion& b) {
  const Real d = std::min((a.coeffs() - b.coeffs()).norm(), (a.coeffs() + b.coeffs()).norm());
  return 4 * std::asin(std::min<Real>(1, d / 2));
}

Matrix3 general_inertia(Real a, Real b, Real c, const Vector3& turn = {0.3, -0.7, 0.4}) {
  const Matrix3 r = exponential(turn).toRotationMatrix();
  const Matrix3 inertia = r * Vector3(a, b, c).asDiagonal() * r.transpose();
  return (inertia + inertia.transpose()) / 2;
}

struct Start {
  std::string name;
  Body body;
  Quaternion orientation;
  Vector3 momentum;
};

// L given in principal axes, so that each row is of the kind that it is named after.
Start start(std::string name, const Matrix3& inertia, const Vector3& principal_momentum) {
  const Body body = make_body(1.3, inertia);
  const Quaternion q = exponential({0.4, 1.0, -0.3});
  return {std::move(name), body, q, q * (body.principal_axes * principal_momentum)};
}

std::vector<Start> starts() {
  const Matrix3 general = general_inertia(0.5, 0.7, 1.0);
  return {
      start("about_the_least", general, {1.1, 0.4, -0.3}),
      start("about_the_greatest", general, {0.3, 0.4, -1.2}),
      start("about_the_greatest_and_back", general, {-0.3, -0.4, 1.2}),
      start("near_the_least_axis", general, {1.1, 1e-9, -1e-10}),
      start("on_the_greatest_axis", general, {0, 0, 1.2}),
      start("nearly_symmetric", general_inertia(0.5, 0.500001, 1.0), {0.9, 0.4, 0.3}),
      start("nearly_round", general_inertia(0.5, 0.50001, 0.50002), {0.9, 0.4, -0.6}),
      start("flat", general_inertia(0.3, 0.4, 0.7), {0.2, -0.4, 0.9}),
      start("oblate", general_inertia(0.5, 0.5, 1.0), {0.8, 0.4, 0.7}),
      start("prolate", general_inertia(0.5, 1.0, 1.0), {0.8, 0.4, -0.7}),
      start("sphere", general_inertia(0.5, 0.5, 0.5), {0.8, 0.4, -0.7}),
      start("rod", Matrix3(Vector3(0.7, 0, 0.7).asDiagonal()), {0, 0.4, -0.7}),
  };
}

// The largest phase after time t [rad], which double knows to eps times itself; some ten of them meet in one
// orientation, and the inertia's axes and moments are themselves rounded.
double rounding(const Start& s, double t) {
  return 30 * eps * (1 + s.momentum.norm() * s.body.inverse_moments.maxCoeff() * std::abs(t));
}

class FreeRotationOf : public testing::TestWithParam<Start> {};

TEST_P(FreeRotationOf, IsEulersEquationsSolved) {
  const Start& s = GetParam();
  TiedBody system;
  system.body = s.body;
  system.stiffness = 0;
  std::vector<Real> y(7);
  TiedBody::store(s.orientation, y.data());
  Vector3::Map(y.data() + 4) = s.momentum;
  Advance<TiedBody> advance(*find_integrator("rk8"), y.size());
  const int steps = 2000;
  const double t = 10;
  advance.run(system, 0, t / steps, y.data(), steps);
  // (h w)^8 = 1e-16 a step and 2000 rounded steps
  EXPECT_LT(apart(FreeRotation(s.body, s.orientation, s.momentum).at(t), TiedBody::orientation(y.data())),
            rounding(s, t) + steps * eps);
}

TEST_P(FreeRotationOf, StartsWhereItStartsAndComposes) {
  const Start& s = GetParam();
  const FreeRotation f(s.body, s.orientation, s.momentum);
  EXPECT_LT(apart(f.at(0), s.orientation), rounding(s, 0));
  for (const double first : {0.37, 2.9, -14.3, 61.0}) {
    for (const double second : {0.21, -5.7, 33.0}) {
      const FreeRotation on(s.body, f.at(first), s.momentum);
      EXPECT_LT(apart(on.at(second), f.at(first + second)), rounding(s, std::abs(first) + std::abs(second)));
    }
  }
}

TEST_P(FreeRotationOf, KeepsEnergyAndUnitLength) {
  const Start& s = GetParam();
  const FreeRotation f(s.body, s.orientation, s.momentum);
  const auto energy = [&](const Quaternion& q) {
    return s.momentum.dot(inverse_inertia_times(s.body, q, s.momentum)) / 2;
  };
  for (const double t : {0.1, 1.7, 23.0, -411.0, 1e4}) {
    EXPECT_NEAR(f.at(t).norm(), 1, 4 * eps);
    // free of phases: 30 eps of the rotation matrices and amplitudes
    EXPECT_NEAR(energy(f.at(t)) / energy(s.orientation), 1, 30 * eps) << t;
  }
}

TEST_P(FreeRotationOf, RunsBackward) {
  const Start& s = GetParam();
  const FreeRotation f(s.body, s.orientation, s.momentum);
  const double t = 7.3;
  EXPECT_LT(apart(FreeRotation(s.body, f.at(t), -s.momentum).at(t), s.orientation), rounding(s, 2 * t));
}

TEST_P(FreeRotationOf, DoesNotDependOnTheBodysAxes) {
  const Start& s = GetParam();
  const Quaternion c = exponential({-0.9, 0.2, 1.3});
  const Matrix3 m = c.toRotationMatrix(), inertia = m.transpose() * s.body.inertia * m;
  const Body body = make_body(1.3, (inertia + inertia.transpose()) / 2);
  const double t = 9.1;
  EXPECT_LT(apart(FreeRotation(body, s.orientation * c, s.momentum).at(t),
                  FreeRotation(s.body, s.orientation, s.momentum).at(t) * c),
            // nearly equal moments are told apart, and their axes found, to eps / their difference
            rounding(s, t) * (s.name.starts_with("nearly") ? 4 : 1));
}

TEST_P(FreeRotationOf, IsExactForShortSteps) {
  const Start& s = GetParam();
  const FreeRotation f(s.body, s.orientation, s.momentum);
  for (const double h : {0.0, 1e-12, 1e-4, 0.003, -0.01, 0.04, 0.1, -0.19, 0.3, 2.7})
    EXPECT_LT(apart(free_flow(s.body, s.orientation, s.momentum, h), f.at(h)), rounding(s, h)) << h;
  // a rotation that is smaller than an ulp of 1 still turns
  const Vector3 w = inverse_inertia_times(s.body, s.orientation, s.momentum);
  const Vector3 turn =
      2 * (free_flow(s.body, Quaternion::Identity(), s.orientation.conjugate() * s.momentum, 1e-20)).vec();
  EXPECT_LT((turn - 1e-20 * (s.orientation.conjugate() * w)).norm(), 1e-20 * 30 * eps * w.norm());
}

// Powers of two change no digit: momentum times s is time times s.
TEST_P(FreeRotationOf, TinyAndHugeSpinsAreTheSameMotion) {
  const Start& s = GetParam();
  const double t = 3.7;
  const Quaternion q = FreeRotation(s.body, s.orientation, s.momentum).at(t);
  for (const double scale : {0x1p-100, 0x1p-20, 0x1p30, 0x1p100}) {
    EXPECT_EQ(apart(FreeRotation(s.body, s.orientation, scale * s.momentum).at(t / scale), q), 0) << scale;
    // Short steps made their turn of seventh powers of the momentum, and lost it below 1e-23 kg m^2/s.
    for (const double h : {1e-4, 0.003, 0.04, 0.1, 0.3}) {
      EXPECT_EQ(apart(free_flow(s.body, s.orientation, scale * s.momentum, h / scale),
                      free_flow(s.body, s.orientation, s.momentum, h)),
                0)
          << scale << ' ' << h;
    }
  }
}

// Negative control: the splitting is not exact, and comes nearer by 4 when the step halves.
TEST(FreeRotation, SplittingIsApproximate) {
  const Start s = starts()[0];
  const FreeRotation f(s.body, s.orientation, s.momentum);
  const auto error = [&](int steps) {
    Quaternion q = s.orientation;
    for (int i = 0; i < steps; ++i) q = free_rotation(s.body, q, s.momentum, 1.0 / steps, Splitting::strang);
    return apart(q, f.at(1));
  };
  EXPECT_GT(error(100), 1e-7);
  EXPECT_NEAR(std::log2(error(100) / error(200)), 2, 0.01);
}

INSTANTIATE_TEST_SUITE_P(Tops, FreeRotationOf, testing::ValuesIn(starts()),
                         [](const auto& row) { return row.param.name; });

// Within a distance delta of the separatrix the motion lingers at the middle axis for ln(1/delta)/lambda and
// leaves it exponentially: rounding grows by e^(lambda t), here at most e^9 = 1e4 until the first turn is
// over.
TEST(FreeRotation, NearTheSeparatrix) {
  const Matrix3 inertia = general_inertia(0.5, 0.7, 1.0);
  const double x12 = 1 / 0.5 - 1 / 0.7, x23 = 1 / 0.7 - 1 / 1.0;
  for (const double delta : {1e-3, -1e-3, 1e-6, -1e-6, 1e-9, -1e-9, 1e-12, -1e-12, 1e-15, 0.0}) {
    const Start s = start("separatrix", inertia, {0.5 * std::sqrt(x23 / x12) * (1 + delta), 0.9, 0.5});
    TiedBody system;
    system.body = s.body;
    system.stiffness = 0;
    std::vector<Real> y(7);
    TiedBody::store(s.orientation, y.data());
    Vector3::Map(y.data() + 4) = s.momentum;
    Advance<TiedBody> advance(*find_integrator("rk8"), y.size());
    const int steps = 4000;
    const double t = 12;
    advance.run(system, 0, t / steps, y.data(), steps);
    const double error =
        apart(FreeRotation(s.body, s.orientation, s.momentum).at(t), TiedBody::orientation(y.data()));
    EXPECT_LT(error, 1e4 * rounding(s, t)) << delta;
  }
}

TEST(FreeRotation, ALockedBodyAndOneWithoutSpinStay) {
  const Quaternion q = exponential({0.4, 1.0, -0.3});
  const Body locked = make_body(1, general_inertia(0.5, 0.7, 1.0), true),
             loose = make_body(1, general_inertia(0.5, 0.7, 1.0));
  EXPECT_LT(apart(FreeRotation(locked, q, {1, 2, 3}).at(5), q), 4 * eps);
  EXPECT_EQ(apart(free_flow(locked, q, {1, 2, 3}, 5), q), 0);
  EXPECT_LT(apart(FreeRotation(loose, q, {0, 0, 0}).at(5), q), 4 * eps);
  EXPECT_EQ(apart(free_flow(loose, q, {0, 0, 0}, 5), q), 0);
}

// ---- Recorded motions, 30 digits and more.

struct Recorded {
  std::string name;
  double allowed;  // [rad], largest over the samples
};

class RecordedTop : public testing::TestWithParam<Recorded> {};

TEST_P(RecordedTop, MeetsItsClaim) {
  std::ifstream file(std::string(source_dir) + "/tests/data/truth/" + GetParam().name + ".json");
  const auto json = nlohmann::json::parse(file);
  const auto number = [](const nlohmann::json& x) { return std::stod(x.get<std::string>()); };
  const auto vector = [&](const nlohmann::json& x) {
    return Vector3(number(x[0]), number(x[1]), number(x[2]));
  };
  const auto rotation = [&](const nlohmann::json& x) {
    return Quaternion(number(x[0]), number(x[1]), number(x[2]), number(x[3]));
  };
  const auto& given = json["bodies"][0];
  const Body body =
      make_body(number(given["mass"]), vector(given["inertia_body_com_diag"]).asDiagonal().toDenseMatrix());
  const Motion motion = make_motion(body, vector(given["position0"]), rotation(given["orientation0"]),
                                    vector(given["velocity0"]), vector(given["angular_velocity0"]));
  const FreeRotation f(body, motion.orientation, motion.angular_momentum);
  const auto& orientations = json["trajectory"].begin().value()["orientation"];
  double worst = 0;
  for (std::size_t i = 0; i < json["t"].size(); ++i)
    worst = std::max(worst, apart(f.at(number(json["t"][i])), rotation(orientations[i])));
  std::cout << GetParam().name << ": " << worst << " rad\n";
  RecordProperty("largest_angle", std::to_string(worst));
  EXPECT_LT(worst, GetParam().allowed);
}

// Rounding of phases: 20 s at 4 rad/s, 20 s at 10 and more, 10 s at 3, all 30 eps phase.  The last passes its
// unstable axis, where the rounding of L grows by e^(lambda t) = 1e3 at each of 20 flips' approaches.
INSTANTIATE_TEST_SUITE_P(Truth, RecordedTop,
                         testing::Values(Recorded{"constant_spin", 30 * eps * 30},
                                         Recorded{"free_symmetric_top", 30 * eps * 250},
                                         Recorded{"free_asymmetric_top", 30 * eps * 100},
                                         Recorded{"dzhanibekov", 1e-9}),
                         [](const auto& row) { return row.param.name; });

// ---- Elliptic integrals and functions: values of Carlson's paper (section 7, 14 digits) and of Abramowitz
// and Stegun, table 17.1.
TEST(Elliptic, HasItsPublishedValues) {
  EXPECT_NEAR(carlson_rf(1, 2, 0), 1.3110287771461, 1e-13);
  EXPECT_NEAR(carlson_rf(0.5, 1, 0), 1.8540746773014, 1e-13);
  EXPECT_NEAR(carlson_rf(2, 3, 4), 0.58408284167715, 1e-14);
  EXPECT_NEAR(carlson_rj(0, 1, 2, 3), 0.77688623778582, 1e-14);
  EXPECT_NEAR(carlson_rj(2, 3, 4, 5), 0.14297579667157, 1e-14);
  EXPECT_NEAR(Jacobi(0.5).quarter_period(), 1.854074677301372, 1e-15);
  EXPECT_NEAR(Jacobi(0.01).quarter_period(), 3.695637362989875, 2e-15);
}

TEST(Elliptic, FunctionsInvertTheIntegral) {
  for (const double complement : {1.0, 0.99, 0.5, 0.1, 1e-3, 1e-8, 1e-16, 1e-30, 1e-40}) {
    const Jacobi jacobi(complement);
    const double k = jacobi.quarter_period();
    EXPECT_NEAR(k, carlson_rf(0, complement, 1), 4e-16 * k);
    for (const double part : {-0.93, -0.4, -1e-7, 0.0, 1e-12, 0.2, 0.7, 0.999}) {
      const JacobiValues v = jacobi(part * k);
      EXPECT_NEAR(v.sn * v.sn + v.cn * v.cn, 1, 1e-15);
      EXPECT_NEAR(v.dn * v.dn, v.cn * v.cn + complement * v.sn * v.sn, 1e-15);
      EXPECT_NEAR(v.sn * carlson_rf(v.cn * v.cn, v.dn * v.dn, 1), part * k, 2e-15 * (1 + k)) << complement;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
