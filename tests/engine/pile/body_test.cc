// Piles of boxes and other shapes: stacks, ratios of masses, inclines, creep, joints.
#include "engine/pile/body_pile.h"
#include "tests/engine/joint_types.h"
#include "tests/engine/pile/pile_fixtures.h"
#include "tests/engine/same_bits.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::engine {
namespace {

Model stack(int cubes, Real top_mass) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < cubes; ++i)
    add_box(model, i == cubes - 1 ? top_mass : 1, Vector3::Constant(Real(0.5)),
            Vector3(Real(0.3), Real(0.5) + static_cast<Real>(i), Real(-0.2)));
  return model;
}

Real farthest(const std::vector<Motion>& from, const std::vector<Motion>& to, bool along_floor = false) {
  Real worst = 0;
  for (std::size_t i = 0; i < from.size(); ++i) {
    Vector3 d = to[i].position - from[i].position;
    if (along_floor) d.y() = 0;
    worst = std::max(worst, d.norm());
  }
  return worst;
}

struct StackCase {
  int cubes;
  double top, dt, seconds;
};

class PileStack : public testing::TestWithParam<StackCase> {};

TEST_P(PileStack, Stands) {
  const auto [cubes, top, dt, seconds] = GetParam();
  const Model model = stack(cubes, static_cast<Real>(top));
  const auto stepper = make_pile(model, dt);
  const auto end = after(*stepper, static_cast<int>(std::lround(seconds / dt)));
  // Everything is solved to rounding in double; in float the forces of the heaviest are rounded.
  EXPECT_LT(farthest(model.motions, end), sizeof(Real) == 8 ? Real(1e-6) : Real(1e-2));
}

INSTANTIATE_TEST_SUITE_P(All, PileStack,
                         testing::Values(StackCase{10, 1, 1. / 60, 10}, StackCase{20, 1, 1. / 60, 60},
                                         StackCase{10, 1000, 1. / 60, 10}, StackCase{2, 1e4, 1. / 240, 10},
                                         StackCase{10, 1e6, 1. / 240, 2}));

TEST(PileBody, StacksCreepLessThanANanometre) {
  for (const int cubes : {1, 10}) {
    const auto stepper = make_pile(stack(cubes, 1), 1. / 240);
    const auto start = after(*stepper, 1000);
    const int steps = 20000;
    // 1e-9 m in 10^6 steps, a fiftieth of it here; in float a micrometre, an ulp of 10 m
    const Real allowed = sizeof(Real) == 8 ? Real(1e-9 * steps / 1000000) : Real(1e-6);
    EXPECT_LT(farthest(start, after(*stepper, steps), true), allowed) << cubes;
  }
}

TEST(PileBody, StacksInSweepsStand) {
  const Model model = stack(10, 1);
  PileSettings settings;
  settings.direct_points = 0;
  const auto end = after(*make_pile(model, 1. / 240, settings), 2400);
  EXPECT_LT(farthest(model.motions, end), Real(0.01));  // Bullet 4.8e-3, ODE 8.9e-3 at this step
}

// a = g (sin - mu cos): what is constant the leapfrog method integrates exactly.
TEST(PileBody, BoxOnAnIncline) {
  const Real angle = Real(20 * std::acos(-1.) / 180);
  const Vector3 normal(-std::sin(angle), std::cos(angle), 0), down(-std::cos(angle), -std::sin(angle), 0);
  const Quaternion turn(Eigen::AngleAxis<Real>(angle, Vector3::UnitZ()));
  const auto way = [&](Real friction, double dt, double seconds) {
    Model model = pile_model(0, friction);
    model.planes[0] = {normal, 0};
    add_box(model, 2, Vector3(Real(0.5), Real(0.3), Real(0.4)), Real(0.3) * normal, Vector3::Zero(),
            Vector3::Zero(), turn);
    const auto end = after(*make_pile(model, dt), static_cast<int>(std::lround(seconds / dt)));
    return static_cast<double>(down.dot(end[0].position - model.motions[0].position));
  };
  EXPECT_LT(std::abs(way(Real(0.5), 1. / 240, 10)), sizeof(Real) == 8 ? 1e-9 : 1e-4);
  const double a = 9.81 * (std::sin(static_cast<double>(angle)) - 0.3 * std::cos(static_cast<double>(angle)));
  for (const double dt : {1. / 60, 1. / 120, 1. / 240})
    EXPECT_NEAR(way(Real(0.3), dt, 2), a * 4 / 2, sizeof(Real) == 8 ? 1e-12 : 1e-4) << dt;
}

TEST(PileBody, CubeReleasedAtRestStays) {
  Model model = pile_model(0, Real(0.5));
  add_box(model, 1, Vector3::Constant(Real(0.5)), Vector3(Real(0.7), Real(0.5), Real(0.2)));
  // ten seconds at the speed that the solver takes for rounding, 256 eps g dt; in float eps/64 is double's
  EXPECT_LT(farthest(model.motions, after(*make_pile(model, 1. / 60), 600)), 10 * 256 * eps * g / 60);
}

// Two boxes meet askew, without gravity: both momenta stay; energy does not grow.
TEST(PileBody, CollisionsKeepBothMomenta) {
  for (const Real e : {Real(0), Real(0.5), Real(1)}) {
    Model model = pile_model(e, Real(0.4), false);
    model.forces.gravity.setZero();
    add_box(model, Real(1.3), Vector3(Real(0.5), Real(0.3), Real(0.4)), Vector3(-2, Real(0.2), Real(0.1)),
            Vector3(3, 0, Real(0.1)), Vector3(Real(0.3), 1, Real(-0.4)));
    add_box(model, Real(2.1), Vector3(Real(0.4), Real(0.6), Real(0.2)), Vector3(Real(0.3), 0, 0),
            Vector3(Real(-0.2), 0, 0), Vector3(Real(-0.5), Real(0.2), 1));
    const auto end = after(*make_pile(model, 1. / 240), 480);
    EXPECT_GT((end[0].momentum - model.motions[0].momentum).norm(), Real(0.5));
    EXPECT_LT((momentum(end) - momentum(model.motions)).norm(), 1000 * eps);
    EXPECT_LE(mechanical_energy(model, end),
              mechanical_energy(model, model.motions) * (1 + 1000 * static_cast<double>(eps)));
    EXPECT_LT((angular_momentum(end) - angular_momentum(model.motions)).norm(), 1000 * eps);
  }
}

TEST(PileBody, SpinningBoxKeepsAngularMomentumAndEnergy) {
  Model model = pile_model(0, Real(0.5), false);
  model.forces.gravity.setZero();
  add_box(model, 2, Vector3(Real(0.1), Real(0.2), Real(0.3)), Vector3::Zero(), Vector3::Zero(),
          Vector3(Real(0.1), 5, Real(0.1)));
  const auto end = after(*make_pile(model, 1. / 60), 6000);
  EXPECT_LT((end[0].angular_momentum - model.motions[0].angular_momentum).norm(), 1000 * eps);
  EXPECT_NEAR(mechanical_energy(model, end) / mechanical_energy(model, model.motions), 1,
              0.02);  // bounded: symplectic, first order
}

TEST(PileBody, DominoesFallInARow) {
  Model model = pile_model(0, Real(0.4));
  const int count = 6;
  for (int i = 0; i < count; ++i)
    add_box(model, 1, Vector3(Real(0.05), Real(0.5), Real(0.25)),
            Vector3(Real(0.5) * static_cast<Real>(i), Real(0.5), 0),
            i == 0 ? Vector3(Real(0.5), 0, 0) : Vector3(0, 0, 0),
            i == 0 ? Vector3(0, 0, Real(-1)) : Vector3(0, 0, 0));
  const auto end = after(*make_pile(model, 1. / 240), 960);
  for (int i = 0; i < count; ++i)
    EXPECT_LT((end[static_cast<std::size_t>(i)].orientation * Vector3::UnitY()).y(), Real(0.6)) << i;
}

// Two boards lean on each other; friction holds them, and without it they slide apart.
TEST(PileBody, CardHouseStandsByFriction) {
  const auto height = [](Real friction) {
    Model model = pile_model(0, friction);
    const Real lean = Real(0.35), half = Real(0.5), thick = Real(0.02);
    for (const Real side : {Real(-1), Real(1)}) {
      const Quaternion turn(Eigen::AngleAxis<Real>(side * lean, Vector3::UnitZ()));
      const Real y = half * std::cos(lean) + thick * std::sin(lean);
      // the inner upper corners meet at x = 0
      const Real x = half * std::sin(lean) + thick * std::cos(lean);
      add_box(model, Real(0.1), Vector3(thick, half, Real(0.3)), Vector3(side * x, y, 0), Vector3::Zero(),
              Vector3::Zero(), turn);
    }
    const auto end = after(*make_pile(model, 1. / 240), 1200);
    return std::min(end[0].position.y(), end[1].position.y());
  };
  EXPECT_GT(height(Real(0.6)), Real(0.4));
  EXPECT_LT(height(Real(0)), Real(0.1));
}

// A chain of balls on joints, each kind once: the anchors stay together, and energy does not grow.
TEST(PileBody, JointsHold) {
  Model model = pile_model(0, 0, false);
  model.surface_count = 1;
  for (int i = 0; i < 3; ++i) {
    add_box(model, Real(1) + static_cast<Real>(i), Vector3(Real(0.5), Real(0.1), Real(0.1)),
            Vector3(Real(0.5) + static_cast<Real>(i), 0, 0));
    model.surfaces.back() = no_surface;
  }
  const Vector3 left(Real(-0.5), 0, 0), right(Real(0.5), 0, 0);
  model.joints.push_back({joint_types::ball, 0, left, fixed_world, Vector3::Zero()});
  Joint hinge{joint_types::hinge, 1, left, 0, right};
  hinge.axis = hinge.to_axis = Vector3::UnitZ();
  model.joints.push_back(hinge);
  model.joints.push_back({joint_types::fixed, 2, left, 1, right});
  const auto stepper = make_pile(model, 1. / 240);
  std::vector<Motion> m;
  const double start = mechanical_energy(model, model.motions);
  Real lowest = 0;
  for (int k = 0; k < 480; ++k) {
    stepper->step();
    stepper->read(m);
    EXPECT_LT((m[0].position + m[0].orientation * left).norm(), Real(1e-4));
    EXPECT_LT((m[1].position + m[1].orientation * left - m[0].position - m[0].orientation * right).norm(),
              Real(1e-4));
    EXPECT_LT(m[2].orientation.angularDistance(m[1].orientation), Real(1e-3));
    EXPECT_LT(mechanical_energy(model, m), start + 1.);  // of 6 kg falling about 1 m: 60 J
    lowest = std::min(lowest, m[2].position.y());
  }
  EXPECT_LT(lowest, Real(-1));
}

TEST(PileBody, BitsDoNotDependOnThreads) {
  Model model = pile_model(0, Real(0.5));
  for (int i = 0; i < 48; ++i) {
    const int layer = i / 16;
    add_box(model, 1, Vector3(Real(0.5), Real(0.3), Real(0.4)),
            Vector3(Real(1.1) * static_cast<Real>(i % 4) + Real(0.05) * static_cast<Real>(i % 3),
                    Real(0.5) + Real(0.7) * static_cast<Real>(layer), static_cast<Real>(i / 4 % 4)),
            Vector3::Zero(), Vector3(Real(0.1), Real(0.2), 0));
  }
  std::vector<std::vector<Motion>> ends;
  for (const int threads : {1, 2, 4}) {
    PileSettings settings;
    settings.threads = threads, settings.direct_points = 0;
    ends.push_back(after(*make_pile(model, 1. / 120, settings), 60));
  }
  EXPECT_TRUE(same_bits(ends[0], ends[1]));
  EXPECT_TRUE(same_bits(ends[0], ends[2]));
}

}  // namespace
}  // namespace cylon::engine
