// Mechanisms with every integrator: joints stay closed, orders and conservation laws hold, and runs repeat
// bit by bit.
#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

namespace cylon::engine {
namespace {

class Mechanism : public EveryIntegrator {
 protected:
  // Which integrator can take joints between bodies; those that cannot say why.
  static bool takes(const Model& model) {
    const std::string reason = unsupported(model, with(GetParam().name, 0.01));
    const bool can = GetParam().constraints || GetParam().kind == Kind::runge_kutta;
    if (can) {
      EXPECT_EQ(reason, "");
    } else {
      EXPECT_NE(reason.find("cannot integrate joints"), std::string::npos) << reason;
    }
    return can;
  }
};

TEST_P(Mechanism, JointsStayClosed) {
  for (const Model& model : {heavy_top(), linked_bodies(true), linked_bodies(false)}) {
    if (model.bodies.size() > 1 && !takes(model)) continue;
    run(model, with(GetParam().name, 1e-3), 1000, [&](const World& world) {
      for (const Joint& joint : model.joints) {
        ASSERT_LT(joint_gap(world.motions(), joint), 1e-14) << world.time();  // places of 1: a few ulp
      }
    });
  }
}

TEST_P(Mechanism, DoublePendulumHasOrderOfIntegrator) {
  const Model model = linked_bodies(true);
  if (!takes(model)) return;
  const int order = GetParam().order;
  const int n = order >= 8 ? 16 : order >= 6 ? 48 : order == 4 ? 128 : order == 2 ? 1024 : 16384;
  const auto exact = run(model, "rk8", 0.5, 2048).motions;
  const Real coarse = distance(run(model, GetParam().name, 0.5, n).motions, exact);
  const Real fine = distance(run(model, GetParam().name, 0.5, 2 * n).motions, exact);
  EXPECT_GT(fine, 1e-12) << "rounding, not truncation";
  EXPECT_NEAR(std::log2(coarse / fine), order, order > 4 ? 0.5 : 0.1);  // high orders: steps are large
}

// Each step adds the same pair of opposite impulses, each rounded: steps x parts x ulp of the momenta (1).
TEST_P(Mechanism, IsolatedBodiesKeepTheirMomentum) {
  for (const Model& model : {coupled_bodies(), coupled_bodies(0.4), linked_bodies(false)}) {
    if (!model.joints.empty() && !takes(model)) continue;
    const Outcome end = run(model, GetParam().name, 5.0, 2000);
    const Real rounding = 2000 * GetParam().evaluations * std::numeric_limits<Real>::epsilon();
    EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), rounding);
  }
}

// Kick and drift each keep p x K + L; a Runge-Kutta step mixes the two.
TEST_P(Mechanism, SplittingsKeepAngularMomentum) {
  const Model model = coupled_bodies(0.4);
  const int steps = 500;
  const Outcome end = run(model, GetParam().name, 5.0, steps);
  const Real drift = (angular_momentum(end.motions) - angular_momentum(model.motions)).norm();
  const Real rounding = steps * GetParam().evaluations * 4 * std::numeric_limits<Real>::epsilon();
  if (GetParam().kind == Kind::splitting) {
    EXPECT_LT(drift, rounding);
  } else if (GetParam().order < 8) {
    EXPECT_GT(drift, 10 * rounding);
  }
}

TEST_P(Mechanism, ConstraintsKeepAngularMomentum) {
  const Model model = linked_bodies(false);
  if (!GetParam().constraints) return;
  const int steps = 2000;
  const Outcome end = run(model, GetParam().name, 5.0, steps);
  // The impulses of a joint act at both anchors, which part by rounding: some ulp a part.
  const Real rounding = steps * GetParam().evaluations * 8 * std::numeric_limits<Real>::epsilon();
  EXPECT_LT((angular_momentum(end.motions) - angular_momentum(model.motions)).norm(), rounding);
}

TEST_P(Mechanism, RepeatsBits) {
  for (const Model& model : {forced_bodies(), linked_bodies(true), heavy_top()}) {
    if (!unsupported(model, with(GetParam().name, 0.01)).empty()) continue;
    const auto a = run(model, GetParam().name, 1.0, 500).motions,
               b = run(model, GetParam().name, 1.0, 500).motions;
    for (std::size_t i = 0; i < a.size(); ++i) EXPECT_TRUE(same_bits(a[i], b[i])) << i;
  }
}

// Energy bounded is what symplectic means: the mean error at the end of a long run is that of its start, with
// joints too (RATTLE).
TEST_P(Mechanism, EnergyErrorOfSymplecticIsBounded) {
  struct Case {
    Model model;
    Time dt;
  };
  Model smooth = coupled_bodies();
  smooth.forces.springs[0].rest_length = 0;  // else its direction is singular where the anchors meet
  for (const Case& c : {Case{smooth, 0.02}, Case{linked_bodies(true), 0.005}}) {
    const bool jointed = !c.model.joints.empty();
    if (!GetParam().symplectic || (jointed && !GetParam().constraints)) continue;
    const Real before = energy(c.model, c.model.motions);
    Real early = 0, late = 0;
    constexpr int steps = 10000, quarter = steps / 4;
    run(c.model, with(GetParam().name, c.dt), steps, [&](const World& world) {
      const Time share = world.time() / (c.dt * steps);
      const Real error = std::abs(energy(c.model, world.motions()) - before) / quarter;
      if (share < 0.25) early += error;
      if (share > 0.75) late += error;
    });
    // A steady drift would make it seven times as large.  Rounding: a few sqrt(steps x 14 parts) ulp of 20 J.
    EXPECT_LT(late, 2.5 * early + 1e-11) << (jointed ? "joints" : "springs");
  }
}

CYLON_EVERY_SCHEME(Mechanism);

TEST(Symplectic, ExplicitEulerEnergyGrows) {
  const Model model = coupled_bodies();
  const auto gain = [&](Time duration) {
    return energy(model,
                  run(model, with("explicit-euler", 0.01), static_cast<int>(duration / 0.01)).motions) -
           energy(model, model.motions);
  };
  EXPECT_GT(gain(10), 1.5 * gain(5));
}

// theta'' = -(m g l / (I + m l^2)) sin theta, by a Runge-Kutta of its own with tiny steps.
Real compound_pendulum(Real theta, Real k, Time duration) {
  Real rate = 0;
  const Real h = 1e-4;
  const long steps = std::lround(duration / h);
  for (long i = 0; i < steps; ++i) {
    const Real k1 = -k * std::sin(theta), k2 = -k * std::sin(theta + h / 2 * rate);
    const Real k3 = -k * std::sin(theta + h / 2 * rate + h * h / 4 * k1);
    const Real k4 = -k * std::sin(theta + h * rate + h * h / 2 * k2);
    theta += h * rate + h * h / 6 * (k1 + k2 + k3);
    rate += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
  }
  return theta;
}

// Two ball joints on one line are a hinge: a compound pendulum, with one condition too many.  A hinge is one
// too, and needs no condition at all.
TEST(Redundant, TwoBallJointsMakeAHinge) {
  Model model;
  const Real mass = 1.2, length = 0.4, about_axis = 0.03;  // moment about the centre of mass
  const Vector3 axis = {0, 0, 1}, turn = 0.5 * axis, pivot = {0.2, 0.1, -0.3};
  const Body body = make_body(mass, Vector3(0.05, 0.04, about_axis).asDiagonal());
  const Vector3 a = {0, length, -0.2}, b = {0, length, 0.3};
  const Vector3 centre = pivot - exponential(turn) * Vector3(0, length, 0);
  add_body(model, body, centre, turn, {0, 0, 0}, {0, 0, 0});
  model.forces.gravity = {0, -9.81, 0};
  Model hinged = model;
  for (const Vector3& anchor : {a, b}) {
    model.joints.push_back({.body = 0, .anchor = anchor, .to_anchor = centre + exponential(turn) * anchor});
  }
  hinged.joints.push_back({.type = joint_types::hinge,
                           .body = 0,
                           .anchor = a,
                           .to_anchor = model.joints[0].to_anchor,
                           .axis = axis,
                           .to_axis = axis});
  const Real k = mass * 9.81 * length / (about_axis + mass * length * length);
  const Quaternion exact = exponential(compound_pendulum(0.5, k, 1) * axis);
  for (const Model& m : {model, hinged}) {
    const Outcome end = run(m, "rk4", 1.0, 1000);
    EXPECT_LT(angle(end.motions[0].orientation, exact), 1e-10);  // h^4 of both
    for (const Joint& joint : m.joints) EXPECT_LT(joint_gap(end.motions, joint), 1e-14);
  }
}

// A ball joint to a locked body is one to the world.
TEST(Locked, ActsLikeTheWorldInJoints) {
  const Model free = heavy_top();
  Model locked = free;
  add_body(locked, make_body(0.3, general_inertia(0.1, 0.2, 0.25), true), {1, 2, 3}, {0.3, -0.4, 0.5},
           {0, 0, 0}, {0, 0, 0});
  Joint& joint = locked.joints[0];
  joint.to = 1;
  joint.to_anchor =
      locked.motions[1].orientation.conjugate() * (joint.to_anchor - locked.motions[1].position);
  const Outcome a = run(free, "rk8", 1.0, 1000), b = run(locked, "rk8", 1.0, 1000);
  EXPECT_LT((a.motions[0].position - b.motions[0].position).norm(), 1e-12);  // rounding over 25 rad of spin
  EXPECT_TRUE(same_bits(b.motions[1], locked.motions[1]));
}

// Energy and angular momentum about the vertical through the pivot of a double pendulum, by constraints
// alone.
TEST(Locked, ADoublePendulumKeepsItsEnergy) {
  const Model model = linked_bodies(true);
  const Outcome end = run(model, "rk8", 2.0, 2000);
  EXPECT_NEAR(energy(model, end.motions), energy(model, model.motions), 1e-12);
  const auto vertical = [&](const std::vector<Motion>& motions) {
    return (angular_momentum(motions) - Vector3(0.1, 0.2, 0.3).cross(momentum(motions))).y();
  };
  EXPECT_NEAR(vertical(end.motions), vertical(model.motions), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
