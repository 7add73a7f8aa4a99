// Bodies that only touch each other keep both momenta to rounding and gain no energy, whatever is done about
// contacts and overlaps: in the direct solution, in sweeps, and where all are spheres.
//
// Moving overlapping bodies apart used to change sum p x K by their displacements times their momenta, 6e-3
// kg m^2/s here; impulses at two points that had drifted apart, in sweeps, by 5e-2; and restitution at
// several points at once, or with friction, added up to 1.5 % to the energy in a step.
#include "tests/engine/joint_types.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <ostream>
#include <random>
#include <utility>
#include <vector>

namespace cylon::engine {
namespace {

enum class Kind { boxes, balls, mixed };

struct Row {
  Kind kind;
  int seed;
  double restitution, friction;
  bool sweeps, gravity;
};

void PrintTo(const Row& row, std::ostream* out) {
  *out << static_cast<int>(row.kind) << " seed " << row.seed << " e " << row.restitution << " friction "
       << row.friction << (row.sweeps ? " sweeps" : " direct") << (row.gravity ? " falling" : "");
}

// On a crooked lattice, rushing together, each with a spin of its own.
Model cluster(const Row& row) {
  Model model = pile_model(static_cast<Real>(row.restitution), static_cast<Real>(row.friction), false);
  if (!row.gravity) model.forces.gravity.setZero();
  std::mt19937 random(static_cast<unsigned>(row.seed));  // the standard fixes its numbers
  const auto between = [&](double low, double high) {
    return static_cast<Real>(low + (high - low) * static_cast<double>(random()) / 4294967296.);
  };
  const auto vector = [&](double size) {
    const Real x = between(-size, size), y = between(-size, size), z = between(-size, size);
    return Vector3(x, y, z);
  };
  for (int i = 0; i < 8; ++i) {
    const Vector3 corner(Real(i & 1) - Real(0.5), Real(i >> 1 & 1) - Real(0.5), Real(i >> 2) - Real(0.5));
    const Vector3 place = Real(1.5) * corner + vector(0.1), velocity = -2 * corner + vector(0.5),
                  spin = vector(2);
    const Real mass = between(0.5, 3);
    const bool ball = row.kind == Kind::balls || (row.kind == Kind::mixed && i % 2 == 0);
    const Vector3 half(between(0.2, 0.4), between(0.2, 0.4), between(0.2, 0.4));
    const Quaternion turn = turned(Quaternion::Identity(), vector(1));
    if (ball)
      add_ball(model, mass, half.x() + Real(0.1), place + Vector3(3, -2, 1), velocity, spin);
    else
      add_box(model, mass, half, place + Vector3(3, -2, 1), velocity, spin, turn);
  }
  return model;
}

// About a point that falls with the centre of mass, where gravity has no torque.
Vector3 own_angular_momentum(const Model& model, const std::vector<Motion>& motions) {
  Vector3 centre = Vector3::Zero();
  Real mass = 0;
  for (std::size_t i = 0; i < motions.size(); ++i)
    mass += model.bodies[i].mass, centre += model.bodies[i].mass * motions[i].position;
  centre /= mass;
  const Vector3 k = momentum(motions);
  return angular_momentum(motions) - centre.cross(k);
}

class PileIsolated : public testing::TestWithParam<Row> {};

TEST_P(PileIsolated, KeepsBothMomentaAndGainsNoEnergy) {
  const Row row = GetParam();
  const Model model = cluster(row);
  PileSettings settings;
  if (row.sweeps) settings.direct_points = 0;
  const double dt = 1. / 240;
  const int steps = 480;
  const auto stepper = make_pile(model, dt, settings);
  std::vector<Motion> motions;
  Real size = 0;  // of sum |p||K| + |L|: what one rounding of each is an eps of
  for (const Motion& m : model.motions)
    size += m.position.norm() * m.momentum.norm() + m.angular_momentum.norm();
  Model weightless = model;  // for the kinetic energy alone
  weightless.forces.gravity.setZero();
  const Vector3 fall = Vector3(0, row.gravity ? -g : 0, 0);
  Real mass = 0;
  for (const Body& body : model.bodies) mass += body.mass;
  double before = mechanical_energy(weightless, model.motions);
  const double start = before;
  std::size_t struck = 0;
  for (int k = 1; k <= steps; ++k) {
    stepper->step();
    struck += stepper->impacts().size();
    stepper->read(motions);
    if (row.gravity) continue;
    const double energy = mechanical_energy(weightless, motions);
    ASSERT_LE(energy, before + 64 * static_cast<double>(eps) * start) << k;
    before = energy;
  }
  EXPECT_GT(struck, 8u);
  // Each step rounds each of some ten sums over impulses once: a walk of steps^1/2, in ten parts in sweeps.
  const Real rounding = 10 * std::sqrt(Real(10 * steps)) * eps,
             speed = row.gravity ? g * Real(steps * dt) : Real(3);
  EXPECT_LT((momentum(motions) - momentum(model.motions) - mass * Real(steps * dt) * fall).norm(),
            rounding * mass * speed);
  EXPECT_LT((own_angular_momentum(model, motions) - own_angular_momentum(model, model.motions)).norm(),
            rounding * (row.gravity ? mass * speed * 20 : size));  // 20 m: how far it falls
  if (!row.gravity) {
    EXPECT_LT((angular_momentum(motions) - angular_momentum(model.motions)).norm(), rounding * size);
  }
}

// x(t) + u t + g t^2/2.  Steps were divided by how fast bodies are in the world, margins and the least speed of a rebound
// followed gravity, and bodies fell by g h t/2 too far.
TEST_P(PileIsolated, MovesAlikeInFreeFallAndWithABoost) {
  Row row = GetParam();
  row.gravity = false;
  const Model model = cluster(row);
  const Vector3 boost(2, 1, -3), gravity(1, -g, 2);
  Model moved = model;
  moved.forces.gravity = gravity;
  for (std::size_t i = 0; i < moved.motions.size(); ++i)
    moved.motions[i].momentum += moved.bodies[i].mass * boost;
  PileSettings settings;
  if (row.sweeps) settings.direct_points = 0;
  // Whether balls that a blow without rebound leaves in touch meet again is rounding, and moves them by some micrometres.
  const Real allowed = row.kind != Kind::boxes && row.restitution == 0 ? Real(1e-4) : Real(1e6) * eps;
  const double dt = 1. / 240;
  const auto plain = make_pile(model, dt, settings), other = make_pile(moved, dt, settings);
  std::vector<Motion> at, of_other;
  std::size_t struck = 0;
  for (int k = 1; k <= 120; ++k) {
    plain->step(), other->step();
    struck += plain->impacts().size();
    plain->read(at), other->read(of_other);
    const Real t = static_cast<Real>(k * dt);
    for (std::size_t i = 0; i < at.size(); ++i)
      ASSERT_LT((of_other[i].position - t * boost - t * t / 2 * gravity - at[i].position).norm(), allowed)
          << k << " body " << i;
  }
  EXPECT_GT(struck, 4u);
}

// The same of two boxes on a hinge whose damper is too stiff for the step, which makes it one of first order.
TEST(PileIsolated, AStiffJointMovesAlikeInFreeFallAndWithABoost) {
  const Vector3 half(Real(0.5), Real(0.1), Real(0.2)), right(Real(0.6), 0, 0), w(0, 0, 2);
  Model model = pile_model(0, 0, false);
  model.forces.gravity.setZero();
  add_box(model, Real(1.3), half, Vector3::Zero(), Vector3::Zero(), w);
  add_box(model, Real(0.7), half, 2 * right, w.cross(right) - w.cross(-right), w);
  Joint joint{joint_types::hinge, 0, right, 1, -right};
  joint.axis = joint.to_axis = Vector3::UnitZ();
  model.joints = {joint};
  CoordinateLaw damper;
  damper.at.kind = Coordinate::Kind::angle, damper.at.body = 1, damper.at.to = 0;
  damper.at.axis = Vector3::UnitZ(), damper.at.zero = damper.at.mark = Vector3::UnitX();
  damper.stiffness = 20, damper.damping = 200;
  model.forces.coordinate_laws = {damper};
  const Vector3 boost(2, 1, -3), gravity(1, -g, 2);
  Model moved = model;
  moved.forces.gravity = gravity;
  for (std::size_t i = 0; i < 2; ++i) moved.motions[i].momentum += moved.bodies[i].mass * boost;
  const double dt = 0.005;
  const auto plain = make_pile(model, dt), other = make_pile(moved, dt);
  const auto at = after(*plain, 100), of_other = after(*other, 100);
  EXPECT_EQ(plain->order_so_far(), 1);
  const Real t = Real(0.5);
  for (std::size_t i = 0; i < 2; ++i)
    EXPECT_LT((of_other[i].position - t * boost - t * t / 2 * gravity - at[i].position).norm(),
              Real(1e6) * eps)
        << i;
}

// A tray that a spring holds against its weight, and a box on it: what hangs from the world falls with nothing.
TEST(PileIsolated, AWeightThatASpringHoldsStaysWhereItIs) {
  Model model = pile_model(0, Real(0.4), false);
  add_box(model, 1, {Real(0.5), Real(0.1), Real(0.5)}, Vector3::Zero());
  add_box(model, Real(0.5), Vector3::Constant(Real(0.1)), {0, Real(0.2), 0});
  Spring spring;  // above the common centre of both, which are one to it
  spring.to_anchor = {0, 2, 0}, spring.stiffness = 50, spring.rest_length = 2 - Real(1.5) * g / 50;
  model.forces.springs.push_back(spring);
  const auto end = after(*make_pile(model, 0.005), 400);
  for (std::size_t i = 0; i < end.size(); ++i) {
    EXPECT_LT((end[i].position - model.motions[i].position).norm(), Real(1e5) * eps) << i;
    EXPECT_LT(end[i].momentum.norm(), Real(1e5) * eps) << i;
  }
}

std::vector<Row> rows() {
  std::vector<Row> rows;
  int seed = 0;
  for (const Kind kind : {Kind::boxes, Kind::balls, Kind::mixed})
    for (const double e : {0., 0.5, 1.})
      for (const double friction : {0., 0.4})
        for (const bool sweeps : {false, true}) rows.push_back({kind, ++seed, e, friction, sweeps, false});
  rows.push_back({Kind::boxes, ++seed, 0.5, 0.4, false, true});
  rows.push_back({Kind::balls, ++seed, 0.5, 0.4, false, true});
  return rows;
}

INSTANTIATE_TEST_SUITE_P(All, PileIsolated, testing::ValuesIn(rows()));

// Two boxes on a joint, struck by a third: closing the joint moves bodies too.
TEST(PileIsolated, JointsKeepBothMomenta) {
  const Vector3 half(Real(0.5), Real(0.1), Real(0.15)), right(Real(0.6), 0, 0);
  for (const auto type : {joint_types::ball, joint_types::hinge, joint_types::distance, joint_types::fixed})
    for (const bool sweeps : {false, true}) {
      Model model = pile_model(Real(0.5), Real(0.3), false);
      model.forces.gravity.setZero();
      const Vector3 v(Real(0.3), Real(-0.2), Real(0.4)), w(Real(0.2), Real(1.1), Real(-0.7));
      add_box(model, Real(1.3), half, Vector3::Zero(), v, w);
      add_box(model, Real(2.1), half, 2 * right, v + w.cross(2 * right), w);
      add_box(model, Real(0.7), half, Vector3(Real(0.2), -2, Real(0.1)), Vector3(0, 4, 0), Vector3(1, 2, 3));
      Joint joint{type, 0, right, 1, -right};
      joint.axis = joint.to_axis = Vector3::UnitZ();
      if (type == joint_types::distance) {
        joint.anchor = right / 2, joint.to_anchor = -right / 2;
        joint.length = right.x();
      }
      model.joints = {joint};
      PileSettings settings;
      if (sweeps) settings.direct_points = 0;
      const auto stepper = make_pile(model, 1. / 240, settings);
      std::size_t struck = 0;
      std::vector<Motion> end;
      for (int k = 0; k < 240; ++k) {
        stepper->step();
        struck += stepper->impacts().size();
      }
      stepper->read(end);
      EXPECT_GT(struck, 0u);
      const Real rounding = 10 * std::sqrt(Real(2400)) * eps * 10;  // of up to 10 kg m^2/s, as above
      EXPECT_LT((momentum(end) - momentum(model.motions)).norm(), rounding) << joint_types::label(type);
      EXPECT_LT((angular_momentum(end) - angular_momentum(model.motions)).norm(), rounding)
          << joint_types::label(type) << (sweeps ? " sweeps" : " direct");
    }
}

// Overlapping at the start, sliding past each other: what is done about the overlap keeps both momenta too.
// A locked body, however far, could take up momentum: then the overlap's share of p x K is let go.
TEST(PileIsolated, OverlapsAreTakenAwayWithoutAngularMomentum) {
  for (const auto& [balls, locked] :
       {std::pair(false, false), std::pair(true, false), std::pair(false, true), std::pair(true, true)}) {
    Model model = pile_model(0, Real(0.3), false);
    model.forces.gravity.setZero();
    const Vector3 half(Real(0.5), Real(0.3), Real(0.4)), to(Real(0.1), Real(0.53), Real(-0.1));
    if (balls) {
      add_ball(model, Real(1.3), Real(0.3), Vector3::Zero(), Vector3(1, 0, 0), Vector3(0, 1, 2));
      add_ball(model, Real(2.1), Real(0.3), to, Vector3(-1, 0, Real(0.5)), Vector3(1, 0, Real(0.5)));
    } else {
      add_box(model, Real(1.3), half, Vector3::Zero(), Vector3(1, 0, 0), Vector3(0, 1, 0));
      add_box(model, Real(2.1), half, to, Vector3(-1, 0, Real(0.5)), Vector3(0, Real(0.5), 0));
    }
    if (locked) {
      add_ball(model, 1, Real(0.3), Vector3(50, 0, 0));
      model.bodies.back() = make_body(1, Matrix3::Identity(), true);
    }
    const auto end = after(*make_pile(model, 1. / 240), 24);
    EXPECT_GT((end[1].position - end[0].position).y(), to.y() + Real(0.01)) << balls;  // moved apart
    const Real rounding = 10 * std::sqrt(Real(240)) * eps;  // 24 steps, as above, of numbers of 1
    EXPECT_LT((momentum(end) - momentum(model.motions)).norm(), rounding) << balls;
    const Real change = (angular_momentum(end) - angular_momentum(model.motions)).norm();
    if (locked)
      EXPECT_GT(change, Real(1e-3)) << balls;
    else
      EXPECT_LT(change, rounding) << balls;
  }
}

}  // namespace
}  // namespace cylon::engine
