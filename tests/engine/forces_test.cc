// Each force against a formula of its own at a general state, and in motion against closed forms.
#include "tests/engine/fixtures.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real ulps =
    64 * std::numeric_limits<Real>::epsilon();  // a few dozen operations on numbers of 1 to 30

// The loads and powers at the start of a model, from momenta alone.
struct Forced {
  std::vector<Kinematics> kinematics;
  std::vector<Load> loads;
  std::vector<Real> powers;
};

Forced forced(const Model& model, Time t = 0) {
  Forced f;
  f.loads.resize(model.bodies.size());
  f.powers.resize(model.forces.count());
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Motion& m = model.motions[i];
    f.kinematics.push_back({m.orientation.toRotationMatrix(), velocity(model.bodies[i], m),
                            angular_velocity(model.bodies[i], m)});
  }
  apply(model.forces, t, model.bodies, model.bodies.size(), model.motions.data(), f.kinematics.data(),
        f.loads.data(), f.powers.data());
  return f;
}

Model two_bodies() {
  Model model = coupled_bodies();
  model.forces = {};
  return model;
}

Vector3 matter_velocity(const Forced& f, std::size_t i, const Vector3& arm) {
  return f.kinematics[i].velocity + f.kinematics[i].angular_velocity.cross(arm);
}

// F.v + torque.w of all bodies is the rate at which the force works; seed eq. 84.
void expect_power(const Forced& f, std::size_t force) {
  Real power = 0;
  for (std::size_t i = 0; i < f.loads.size(); ++i) {
    power += f.loads[i].force.dot(f.kinematics[i].velocity) +
             f.loads[i].torque.dot(f.kinematics[i].angular_velocity);
  }
  EXPECT_NEAR(f.powers[force], power, ulps * (1 + std::abs(power)));
  for (std::size_t k = 0; k < f.powers.size(); ++k) {
    if (k == force) continue;
    EXPECT_EQ(f.powers[k], 0) << k;
  }
}

TEST(Force, GravityIsTheWeightOfEachBody) {
  Model model = two_bodies();
  model.forces.gravity = {0.3, -9.81, 0.7};
  const Forced f = forced(model);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((f.loads[i].force - model.bodies[i].mass * model.forces.gravity).norm(), ulps);  // errata 38
    EXPECT_EQ(f.loads[i].torque, Vector3(Vector3::Zero()));
  }
  expect_power(f, 0);
}

// Errata 5, 14 (arms turn with the body), 47 (towards the pin); stretched and pressed, damped and not.
TEST(Force, ASpringPullsAlongItsLine) {
  for (const Real rest : {0.0, 0.4, 5.0}) {
    for (const Real damping : {0.0, 0.7}) {
      for (const int to : {1, fixed_world}) {
        Model model = two_bodies();
        const Vector3 a = {0.3, -0.1, 0.25}, b = {-0.15, 0.2, 0.35};
        model.forces.springs.push_back({0, a, to, b, 9.0, rest, damping});
        const Forced f = forced(model);
        const Vector3 r_a = model.motions[0].orientation * a, x_a = place(model.motions, 0, a);
        const Vector3 x_b = place(model.motions, to, b);
        const Vector3 r_b = to == 1 ? Vector3(x_b - model.motions[1].position) : Vector3(Vector3::Zero());
        const Vector3 v_b = to == 1 ? matter_velocity(f, 1, r_b) : Vector3(Vector3::Zero());
        const Vector3 d = x_b - x_a, u = d.normalized();
        const Real tension = 9.0 * (d.norm() - rest) + damping * u.dot(v_b - matter_velocity(f, 0, r_a));
        EXPECT_LT((f.loads[0].force - tension * u).norm(), ulps * 40);
        EXPECT_LT((f.loads[0].torque - r_a.cross(tension * u)).norm(), ulps * 40);
        if (to == 1) {
          EXPECT_LT((f.loads[1].force + tension * u).norm(), ulps * 40);
          EXPECT_LT((f.loads[1].torque + r_b.cross(tension * u)).norm(), ulps * 40);
        }
        expect_power(f, 1);
      }
    }
  }
}

// Errata 49: no factor dt; the three parts of drag add.
TEST(Force, DragOpposesVelocityAndSpin) {
  Model model = two_bodies();
  model.forces.drags.push_back({1, 0.3, 0.2, 0.1});
  const Forced f = forced(model);
  EXPECT_LT((f.loads[1].force + 0.3 * f.kinematics[1].velocity).norm(), ulps);
  EXPECT_LT(
      (f.loads[1].torque + 0.2 * f.kinematics[1].angular_velocity + 0.1 * model.motions[1].angular_momentum)
          .norm(),
      ulps);
  EXPECT_EQ(f.loads[0].force, Vector3(Vector3::Zero()));
  EXPECT_LT(f.powers[1], 0);
  expect_power(f, 1);
}

TEST(Force, ThrustTurnsWithTheBodyAndCarriesMomentum) {
  Model model = two_bodies();
  const Vector3 push = {0.4, 1.2, -0.3}, exchanged = {-2.0, 0.5, 0.7};
  for (const bool relative : {false, true}) {
    model.forces.thrusts = {
        {.body = 1, .force = push, .mass_rate = -0.2, .relative = relative, .exchanged = exchanged}};
    const Forced f = forced(model);
    const Matrix3& r = f.kinematics[1].rotation;
    const Vector3 carried = relative ? Vector3(f.kinematics[1].velocity + r * exchanged) : exchanged;
    EXPECT_LT((f.loads[1].force - (r * push - 0.2 * carried)).norm(), ulps);
    EXPECT_EQ(f.loads[1].torque, Vector3(Vector3::Zero()));
    expect_power(f, 1);
  }
}

TEST(Force, ADriveSwingsWithTime) {
  Model model = two_bodies();
  const Vector3 push = {0.9, 0.4, -1.1};
  model.forces.drives.push_back({0, push, 2.3});
  for (const Time t : {0.0, 0.37, 12.9, 4567.8}) {
    const Forced f = forced(model, t);
    EXPECT_LT((f.loads[0].force - push * static_cast<Real>(std::cos(2.3 * t))).norm(), 1e-12) << t;
    expect_power(f, 1);
  }
}

TEST(Force, AttractionFollowsTheInverseSquare) {
  Model model = two_bodies();
  model.forces.attractions.push_back({0, 1, 0.7});
  const Forced f = forced(model);
  const Vector3 d = model.motions[1].position - model.motions[0].position;
  EXPECT_LT((f.loads[0].force - 0.7 * 1.3 * 0.8 / d.squaredNorm() * d.normalized()).norm(), ulps);
  EXPECT_EQ(f.loads[1].force, -f.loads[0].force);
  EXPECT_EQ(f.loads[0].torque, Vector3(Vector3::Zero()));
  expect_power(f, 1);
}

// On a body whose reference point is a pivot, what acts at its centre of mass has an arm.
TEST(Force, OnAPinnedBodyActsAtItsCentreOfMass) {
  Model model = two_bodies();
  Body& body = model.bodies[1];
  body.pinned = true, body.inverse_mass = 0, body.centre = {0.3, -0.2, 0.4};
  model.motions[1].momentum.setZero();
  const Vector3 arm = model.motions[1].orientation * body.centre;
  const auto torque = [&](const Forces& forces) {
    model.forces = forces;
    return forced(model).loads[1].torque;
  };
  const Vector3 w = forced(model).kinematics[1].angular_velocity, v = w.cross(arm);
  Forces gravity, drag, thrust, drive, pull;
  gravity.gravity = {0.3, -9.81, 0.7};
  EXPECT_LT((torque(gravity) - arm.cross(0.8 * gravity.gravity)).norm(), ulps);
  drag.drags.push_back({1, 0.3, 0, 0.6});
  const Vector3 spin = model.motions[1].angular_momentum - arm.cross(0.8 * v);
  EXPECT_LT((torque(drag) + arm.cross(0.3 * v) + 0.6 * spin).norm(), ulps);
  thrust.thrusts.push_back({.body = 1, .force = {0.4, 1.2, -0.3}});
  EXPECT_LT((torque(thrust) - arm.cross(model.motions[1].orientation * Vector3(0.4, 1.2, -0.3))).norm(),
            ulps);
  drive.drives.push_back({1, {0.9, 0.4, -1.1}, 2.3});
  EXPECT_LT((torque(drive) - arm.cross(Vector3(0.9, 0.4, -1.1))).norm(), ulps);
  pull.attractions.push_back({1, 0, 0.7});
  const Vector3 d = model.motions[0].position - model.motions[1].position - arm;
  EXPECT_LT((torque(pull) - arm.cross(0.7 * 1.3 * 0.8 / d.squaredNorm() * d.normalized())).norm(), ulps);
}

TEST(Force, LockedBodyFeelsNoForceButExertsIt) {
  Model model = two_bodies();
  model.bodies[1] = make_body(0.8, model.bodies[1].inertia, true);
  model.forces.gravity = {0, -9.81, 0};
  model.forces.springs.push_back({0, {0.3, 0, 0.1}, 1, {0.1, 0.2, 0.3}, 9, 0.5, 0.1});
  model.forces.attractions.push_back({1, 0, 0.7});
  for (const char* integrator : {"rk4", "velocity-verlet", "yoshida6"}) {
    const Outcome end = run(model, integrator, 1, 100);
    EXPECT_TRUE(same_bits(end.motions[1], model.motions[1])) << integrator;
    EXPECT_GT((end.motions[0].position - model.motions[0].position).norm(), 0.5);
  }
  for (Motion& m : model.motions) m.angular_momentum.setZero();  // and as points
  model.forces.springs.clear();
  const Outcome end = run(model, "rk4", 1, 100);
  EXPECT_TRUE(same_bits(end.motions[1], model.motions[1]));
}

// ---- In motion -------------------------------------------------------------------------------------

// Errata 47, 48: at its pin a spring has no direction; it must not make NaN, and from there it pulls back.
TEST(Spring, HasNoForceAtItsPin) {
  for (const Real rest_length : {0.0, 0.4}) {
    for (const Real damping : {0.0, 0.3}) {
      Model model;
      add_body(model, make_body(1.1, Matrix3::Identity()), {0.5, -0.2, 0.3}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
      model.forces.springs.push_back(
          {0, {0, 0, 0}, fixed_world, {0.5, -0.2, 0.3}, 30.0, rest_length, damping});
      EXPECT_EQ(run(model, "rk4", 0.1, 100).motions[0].position, model.motions[0].position);

      model.motions[0].momentum = {0.3, 0.1, 0.2};
      const Outcome end = run(model, "rk4", 5.0, 1000);
      EXPECT_LT((end.motions[0].position - model.motions[0].position).norm(), 2 * rest_length + 0.4);
    }
  }
}

// p = p0 cos wt + v0/w sin wt about the pin; errata 13, 43: energy must not grow.
TEST(Spring, ZeroLengthSpringGivesEllipse) {
  Model model;
  const Vector3 pin = {0.2, 0.5, -0.3}, p0 = {1.0, 0.2, 0.4}, v0 = {-0.3, 1.1, 0.7};
  add_body(model, make_body(1.3, Matrix3::Zero()), pin + p0, {0, 0, 0}, v0, {0, 0, 0});
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, pin, 17.0, 0, 0});
  const Real w = std::sqrt(17.0 / 1.3), t = 10;
  const Outcome end = run(model, "rk8", t, 1000);
  EXPECT_LT((end.motions[0].position - pin - p0 * std::cos(w * t) - v0 / w * std::sin(w * t)).norm(), 1e-12);
}

// x'' = (F/m) cos(wt) - (c/m) x': every number of the closed form at once.
TEST(Drive, WithDragIsTheClosedForm) {
  Model model;
  const Real m = 1.3, c = 0.6, w = 2.3;
  const Vector3 force = {0.9, -0.4, 1.1};
  add_body(model, make_body(m, Matrix3::Identity()), {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
  model.forces.drives.push_back({0, force, w});
  model.forces.drags.push_back({0, c, 0, 0});
  const Real t = 2.0, s = c / m;
  // v = F/m (s cos wt + w sin wt - s e^-st) / (s^2 + w^2)
  const Vector3 v =
      force / m * ((s * std::cos(w * t) + w * std::sin(w * t) - s * std::exp(-s * t)) / (s * s + w * w));
  const Outcome end = run(model, "rk4", t, 2000);
  EXPECT_LT((velocity(end.bodies[0], end.motions[0]) - v).norm(), 1e-12);
}

// L' = -momentum L, exactly exponential whatever the body (errata 51).  A splitting solves it exactly.
TEST(Drag, OfTheSpinDecaysExponentially) {
  for (const char* integrator : {"rk4", "velocity-verlet", "bm6"}) {
    Model model = free_top();
    model.forces.drags.push_back({0, 0, 0, 0.7});
    const Outcome end = run(model, integrator, 2.0, 2000);
    EXPECT_LT((end.motions[0].angular_momentum - std::exp(-1.4) * model.motions[0].angular_momentum).norm(),
              1e-12)
        << integrator;
  }
}

// The flow of a kick is exact however strong the drag: its series alone gave 1e55 where gamma h = 20.
TEST(Drag, StrongDragInASplittingIsExact) {
  for (const Real gamma : {Real(3), Real(20), Real(200), Real(3000)}) {
    Model model;
    add_body(model, make_body(2, general_inertia(0.3, 0.4, 0.5)), {0.3, 1, 0.2}, {0.1, 0.2, 0.3}, {7, 9, -2},
             {0, 0, 0});
    model.forces.drags.push_back({0, 2 * gamma, 0, 0});
    const Real t = 1;  // one step, of two kicks of a half
    const Vector3 k = run(model, "velocity-verlet", t, 1).motions[0].momentum;
    EXPECT_LT((k - std::exp(-gamma * t) * model.motions[0].momentum).norm(), 1e-7) << gamma;
    EXPECT_LT(run(model, "velocity-verlet", t, 1).motions[0].position.norm(), 20) << gamma;
  }
}

// m v' = m g - c v:  p = p0 + u t + (v0 - u)(1 - e^-bt)/b,  b = c/m,  u = g/b.  Errata 44, 49: from the first
// step.
TEST(Drag, OfAProjectileIsTheClosedForm) {
  Model model;
  const Vector3 v0 = {7.0, 9.0, -2.0}, g = {0.2, -9.81, 0.1};
  add_body(model, make_body(1.7, general_inertia(0.3, 0.4, 0.5)), {0.3, 1, 0.2}, {0.1, 0.2, 0.3}, v0,
           {0, 0, 0});
  model.forces.gravity = g;
  model.forces.drags.push_back({0, 0.5, 0, 0});
  const Real b = 0.5 / 1.7, t = 2;
  const Vector3 u = g / b, p = model.motions[0].position + u * t + (v0 - u) * (1 - std::exp(-b * t)) / b;
  EXPECT_LT((run(model, "rk8", t, 200).motions[0].position - p).norm(), 1e-13);
  const Real first = 1e-3;
  const Vector3 change = run(model, "rk4", first, 1).motions[0].momentum - model.motions[0].momentum;
  EXPECT_LT((change / first - (1.7 * g - 0.5 * v0)).norm(), 0.01);  // h/2 of the second derivative, 3 m/s^2
}

// Tsiolkovsky: v = v0 + g t + u ln(m0/m) along a nose that keeps its direction; the thrust is relative to the
// rocket, so that a boost changes nothing (errata 2).
TEST(Thrust, ARocketFollowsTsiolkovsky) {
  const Vector3 v0 = {0.4, 1.0, -0.7}, boost = {30, -20, 10}, turn = {0.3, 0.5, -0.2}, g = {0.1, -9.81, 0.3};
  const Vector3 exhaust = {-0.5, -40, 0.3};
  const Real m0 = 5, rate = -0.8, t = 4;
  for (const char* integrator : {"rk8", "yoshida6", "velocity-verlet"}) {
    std::vector<Vector3> ends;
    for (const Vector3& u : {Vector3(Vector3::Zero()), boost}) {
      Model model;
      Body body = make_body(m0, general_inertia(0.3, 0.4, 0.5));
      body.mass_rate = rate;
      add_body(model, body, {0.2, 0.3, 0.4}, turn, v0 + u, {0, 0, 0});
      model.forces.gravity = g;
      model.forces.thrusts.push_back({.body = 0, .mass_rate = rate, .relative = true, .exchanged = exhaust});
      const Outcome end = run(model, integrator, t, 400);
      const Real m = m0 + rate * t;
      const Vector3 n = exponential(turn) * exhaust, k = end.motions[0].momentum;
      const Vector3 v = v0 + u + g * t + n * std::log(m / m0);
      const Vector3 p =
          model.motions[0].position + (v0 + u) * t + g * t * t / 2 - n * (t + m / rate * std::log(m0 / m));
      const bool second = std::string(integrator) == "velocity-verlet";
      // Verlet: (h^2/12) times the third derivative of the force, 40 (0.8/1.8)^3 m/s^4, over 4 s
      const Real bound = second ? 1e-3 : 1e-9;
      EXPECT_LT((k / m - v).norm(), bound) << integrator;
      EXPECT_LT((end.motions[0].position - p).norm(), bound) << integrator;
      ends.emplace_back(end.motions[0].position - u * t);
    }
    // A splitting freezes the mass in its kicks: only to its truncation.
    EXPECT_LT((ends[0] - ends[1]).norm(), 2 * (std::string(integrator) == "velocity-verlet" ? 1e-3 : 1e-9))
        << integrator;
  }
}

// Mass that comes in at rest, literally seed eq. 12-16: dK/dt = m(t) g; the horizontal momentum stays.
// Errata 2.
TEST(Thrust, AccretionOfMassAtRestKeepsTheMomentum) {
  Model model;
  Body body = make_body(1, Matrix3::Zero());
  body.mass_rate = 0.5;
  const Vector3 v0 = {3, 4, -1}, g = {0, -9.81, 0};
  add_body(model, body, {0, 1, 0}, {0, 0, 0}, v0, {0, 0, 0});
  model.forces.gravity = g;
  model.forces.thrusts.push_back({.body = 0, .mass_rate = 0.5});
  const Real t = 2, m = 2;
  const Outcome end = run(model, "rk8", t, 400);
  const Vector3 k = v0 + g * (m * m - 1) / (2 * 0.5);
  EXPECT_LT((end.motions[0].momentum - k).norm(), 1e-12);
  // p = p0 + int K/m dt,  K = v0 + g (m^2 - 1)
  const Vector3 p = Vector3(0, 1, 0) + v0 * 2 * std::log(m) + g * ((m * m - 1) - 2 * std::log(m));
  EXPECT_LT((end.motions[0].position - p).norm(), 1e-12);
}

// A mass rate without a thrust: the mass leaves with the body's own... momentum is what is stated, K' = m(t)
// g.
TEST(Thrust, AMassRateCountsWithoutThrustRows) {
  Model model;
  Body body = make_body(1, Matrix3::Zero());
  body.mass_rate = 0.5;
  add_body(model, body, {0, 1, 0}, {0, 0, 0}, {3, 4, -1}, {0, 0, 0});
  model.forces.gravity = {0, -9.81, 0};
  const Outcome end = run(model, "rk8", 2.0, 400);
  EXPECT_NEAR(end.motions[0].momentum.y(), 4 - 9.81 * 3, 1e-12);
}

// Kepler: after T = 2 pi sqrt(a^3/(G (m_a + m_b))) both are back; E and L stay.
TEST(Attraction, TwoBodiesCloseTheirEllipses) {
  const Real strength = 2.5, m_a = 1.3, m_b = 0.7, mu = strength * (m_a + m_b);
  for (const Real speed : {0.9, 1.2, 1.5}) {
    Model model;
    const Vector3 d = {1.2, 0.3, -0.4}, v = speed * Vector3(0.2, 1.1, 0.5);
    add_body(model, make_body(m_a, Matrix3::Zero()), m_b / (m_a + m_b) * d, {0, 0, 0}, m_b / (m_a + m_b) * v,
             {0, 0, 0});
    add_body(model, make_body(m_b, Matrix3::Zero()), -m_a / (m_a + m_b) * d, {0, 0, 0},
             -m_a / (m_a + m_b) * v, {0, 0, 0});
    model.forces.attractions.push_back({0, 1, strength});
    const Real a = 1 / (2 / d.norm() - v.squaredNorm() / mu);  // vis viva
    const Real period = 2 * std::numbers::pi * std::sqrt(a * a * a / mu);
    const Outcome end = run(model, "rk8", period, 4000);
    EXPECT_LT(distance(end.motions, model.motions), 1e-11) << speed;
    EXPECT_LT(momentum(end.motions).norm(), 1e-13);
    EXPECT_LT((angular_momentum(end.motions) - angular_momentum(model.motions)).norm(), 1e-12);
    // Negative control: half a period is the other side.
    EXPECT_GT(distance(run(model, "rk8", period / 2, 2000).motions, model.motions), 0.5);
  }
}

// A planet that turns is carried by the general system, where its attraction is the same.
TEST(Attraction, IsTheSameForBodiesThatSpin) {
  Model points = two_bodies();
  for (Motion& m : points.motions) m.angular_momentum.setZero();
  points.forces.attractions.push_back({0, 1, 0.7});
  Model spinning = points;
  spinning.motions[0].angular_momentum = {0.3, 0.1, -0.2};
  EXPECT_EQ(make_plan(points, with("rk8", 0.01)).path, Path::points);
  EXPECT_EQ(make_plan(spinning, with("rk8", 0.01)).path, Path::bodies);
  const Outcome a = run(points, "rk8", 1, 200), b = run(spinning, "rk8", 1, 200);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_LT((a.motions[i].position - b.motions[i].position).norm(), 1e-14 * 10);
  }
}

// Errata 22: without anything from outside momentum and angular momentum stay, with gravity they do not.
TEST(Isolated, KeepsMomentumAndOnlyThen) {
  Model model = coupled_bodies(0.3);
  const Outcome end = run(model, "rk8", 2, 400);
  EXPECT_LT((momentum(end.motions) - momentum(model.motions)).norm(), 1e-13);
  EXPECT_LT((angular_momentum(end.motions) - angular_momentum(model.motions)).norm(), 1e-12);
  model.forces.gravity = {0, -9.81, 0};
  const Vector3 fallen = momentum(run(model, "rk8", 2, 400).motions) - momentum(model.motions);
  EXPECT_LT((fallen - 2.1 * 2 * model.forces.gravity).norm(), 1e-12);
}

}  // namespace
}  // namespace cylon::engine
