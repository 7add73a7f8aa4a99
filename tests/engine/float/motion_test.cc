// The engine in single precision against closed forms in double, within the rounding of float.
#include "tests/engine/float/fixtures.h"

namespace cylon::engine {
namespace {

using Double3 = Eigen::Vector3d;

// ---- Free rotation -----------------------------------------------------------------------------------

// A symmetric top: L stays, and the axis turns about it at |L|/b.  L. D. Landau, E. M. Lifshitz, Mechanics,
// section 33.
TEST(FloatMotion, AxisOfSymmetricTopPrecesses) {
  Model model;
  add_body(model, make_body(2, general_inertia(real(0.5), real(0.5), real(0.8))), {1, 2, 3},
           {real(0.4), 1, real(-0.3)}, {0, 0, 0}, {3, 1, -1});
  const Body& body = model.bodies[0];
  const Motion start = model.motions[0];
  const Double3 l = start.angular_momentum.cast<double>();
  const auto axis = [&](const Motion& m) {
    return Double3((m.orientation * (body.principal_axes * Vector3::UnitZ())).cast<double>());
  };
  const Double3 before = axis(start), n = l.normalized();
  for (const double t : {0.1, 1.0, 7.0, 50.0}) {
    const Motion now = run(model, "auto", t, 1).motions[0];
    const double turned = l.norm() / 0.5 * t;
    const Double3 expected = n * n.dot(before) + std::cos(turned) * (before - n * n.dot(before)) +
                             std::sin(turned) * n.cross(before);
    // The rounding of L and of the moment, grown by the angle that it is multiplied with.
    EXPECT_LT((axis(now) - expected).norm(), (8 + 8 * turned) * static_cast<double>(rounding)) << t;
    EXPECT_EQ(now.angular_momentum, start.angular_momentum);
  }
}

// ---- Impacts in time ---------------------------------------------------------------------------------

// A ball let go from a height h: t_1 = sqrt(2h/g), then 2 e^k t_1 between bounces.
TEST(FloatMotion, BouncesOccurAtExactTimes) {
  const double height = 0.8, e = 0.75, fall = std::sqrt(2 * height / 9.81);
  for (const char* integrator : {"auto", "rk4", "velocity-verlet"}) {
    const Outcome end = run(ball_over_plane(real(height), real(e)), integrator, 2.0, 200);
    ASSERT_GE(end.impacts.size(), 4u) << integrator;
    double expected = fall;
    for (int k = 0; k < 4; ++k) {
      // The gap is the difference of places of size 1.5 with some tens of roundings; over a speed of g t, and
      // that of the bounces before.
      const double bound = 200 * 1.5 * static_cast<double>(rounding) / (9.81 * fall * std::pow(e, k));
      EXPECT_NEAR(end.impacts[static_cast<std::size_t>(k)].time, expected, bound) << integrator << " " << k;
      expected += 2 * fall * std::pow(e, k + 1);
    }
  }
}

// An integrator of first order comes down later within a step than the cubic between its ends does: the
// impact was taken for a graze, the ball stood inside the plane, parted, and was found to meet it at that
// instant for ever.
TEST(FloatMotion, FirstOrderStepDoesNotMissImpact) {
  for (const char* integrator : {"lie-trotter", "explicit-euler"}) {
    const Model model = ball_over_plane(real(0.5), real(0.6));
    Real deepest = 0;
    run(model, with(integrator, 0.005), 400,
        [&](const World& world) { deepest = std::min(deepest, plane_gap(model, world.motions())); });
    // Impacts are located to rounding of the places, of size 1.5; the step in which one was missed is 1e-3
    // deep.
    EXPECT_GT(deepest, -200 * rounding * real(1.5)) << integrator;
  }
}

// ---- What is conserved -------------------------------------------------------------------------------

class FloatInvariant : public EveryIntegrator {};

TEST_P(FloatInvariant, Momentum) {
  const Model model = coupled_bodies();
  const int steps = 1000;
  const Outcome end = run(model, GetParam().name, 4, steps);
  ASSERT_TRUE(finite(end.motions));
  // Each step rounds each of two momenta of size below 8 in every stage: at worst all one way.
  const Real bound =
      static_cast<Real>(steps) * 2 * static_cast<Real>(1 + GetParam().evaluations) * 4 * rounding;
  EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), bound);
}

TEST_P(FloatInvariant, NothingIsNotANumber) {
  const Model models[] = {coupled_bodies(), forced_bodies(), free_top(), heavy_top(),
                          ball_over_plane(real(0.5), real(0.6))};
  for (const Model& model : models) EXPECT_TRUE(finite(run(model, GetParam().name, 2, 400).motions));
}

CYLON_EVERY_SCHEME(FloatInvariant);

// ---- auto --------------------------------------------------------------------------------------------

// With drag on the point, decay [1/s]; without, the plan knows a closed form.
Model spring(double decay) {
  Model model;
  add_body(model, make_body(real(1.3), Matrix3::Zero()), {real(1.2), real(0.7), real(0.1)}, {0, 0, 0},
           {real(-0.3), real(1.1), real(0.7)}, {0, 0, 0});
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0, 0, 0}, 17, 0, 0});
  if (decay > 0) model.forces.drags.push_back({0, real(2 * 1.3 * decay), 0, 0});
  return model;
}

// The worst of all samples over 20 s, 72 rad, relative to length and speed.
double spring_error(double decay, Real tolerance, std::vector<std::string>& remarks) {
  const Model model = spring(decay);
  const double mass = static_cast<double>(real(1.3));
  if (decay > 0) decay = static_cast<double>(model.forces.drags[0].linear) / (2 * mass);
  const double w = std::sqrt(17.0 / mass - decay * decay);
  const Double3 p0 = model.motions[0].position.cast<double>(),
                v0 = model.motions[0].momentum.cast<double>() / mass;
  double worst = 0;
  const Outcome end =
      run(model, {.integrator = "auto", .dt = 0.1, .tolerance = tolerance}, 200, [&](const World& world) {
        const double t = world.time();
        const Double3 p =
            std::exp(-decay * t) * (p0 * std::cos(w * t) + (v0 + decay * p0) / w * std::sin(w * t));
        worst = std::max(worst, (world.motions()[0].position.cast<double>() - p).norm() / p0.norm());
      });
  remarks = end.remarks;
  return worst;
}

// In closed form a sample is rounded once, whatever the time.
TEST(FloatModes, AreExactToRounding) {
  std::vector<std::string> remarks;
  EXPECT_LT(spring_error(0, 0, remarks), 2 * static_cast<double>(rounding));
}

constexpr double decay = 0.05;

TEST(FloatAuto, KeepsItsOwnTolerance) {
  std::vector<std::string> remarks;
  EXPECT_LT(spring_error(decay, 0, remarks), 1e-4);
  EXPECT_TRUE(remarks.empty());
}

// 1e-8 is a tenth of a rounding: it must be said, and the motion must be the best that there is.
TEST(FloatAuto, ReportsToleranceBelowRounding) {
  std::vector<std::string> remarks;
  EXPECT_LT(spring_error(decay, real(1e-8), remarks), 1e-4);
  ASSERT_FALSE(remarks.empty());
  EXPECT_NE(remarks[0].find("tolerance"), std::string::npos);
}

TEST(FloatAuto, GivesTheSameBitsTwice) {
  for (const Model& model : {forced_bodies(), linked_bodies(false), ball_over_plane(real(0.5), real(0.8))}) {
    const auto a = run(model, "auto", 2, 40).motions, b = run(model, "auto", 2, 40).motions;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bits(a[i], b[i]));
  }
}

}  // namespace
}  // namespace cylon::engine
