// Springs, dampers, motors and servos on the coordinates of joints, against closed forms and independent
// integrations of the reduced equations.
#include "tests/engine/rail_and_wheel.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real mass = rail_mass;
const Vector3& axis = rail_axis;

Real position(const std::vector<Motion>& motions) { return along_rail(motions); }
Real spin(const Outcome& end) { return axis.dot(angular_velocity(end.bodies[0], end.motions[0])); }

const std::vector<std::pair<const char*, bool>> forms = {
    {"auto", false}, {"auto", true}, {"rk8", false}, {"rk8", true}, {"yoshida6", false}, {"yoshida6", true}};
Options form(const std::pair<const char*, bool>& f, Time dt) {
  Options options = with(f.first, dt);
  options.constraints = f.second;
  return options;
}

// m q'' = -k (q - r) - c q' + F + m g.a:  q = q_e + e^(-d t) (A cos(w t) + B sin(w t)).
TEST(Law, OfASliderOnADampedSpring) {
  Model model = body_on_rail(0.7);
  model.forces.gravity = {0.2, -9.81, 0.4};
  CoordinateLaw law;
  law.at = along_rail();
  law.at.origin = 0.15;  // q = 0.15 at the start
  law.stiffness = 40, law.damping = 0.9, law.force = 1.1, law.target.value = 0.25;
  model.forces.coordinate_laws.push_back(law);
  const Real k = law.stiffness, d = law.damping / (2 * mass), w = std::sqrt(k / mass - d * d), t = 2;
  const Real rest = law.target.value + (law.force + mass * model.forces.gravity.dot(axis)) / k;
  const Real a = law.at.origin - rest, b = (0.7 + d * a) / w;
  const Real q = rest + std::exp(-d * t) * (a * std::cos(w * t) + b * std::sin(w * t));
  for (const auto& f : forms)
    EXPECT_NEAR(law.at.origin + position(run(model, form(f, 2e-3), 1000).motions), q, 1e-9)
        << f.first << f.second;
}

// I q'' = -k q, over many turns: q = W/w sin(w t).  The angle of an orientation alone would turn round at pi.
TEST(Law, CountsTurns) {
  Wheel w = wheel_that_turns(40);
  CoordinateLaw law;
  law.at = w.angle;
  law.stiffness = 0.3;
  w.model.forces.coordinate_laws.push_back(law);
  const Real rate = std::sqrt(law.stiffness / w.inertia);
  EXPECT_GT(40 / rate, 4 * std::numbers::pi) << "two turns to each side";
  for (const auto& f : forms) {
    const Outcome end = run(w.model, form(f, 2e-3), 1500);
    EXPECT_NEAR(spin(end), 40 * std::cos(rate * 3), 2e-7) << f.first << f.second;
  }
}

// A flywheel with all three losses: I w' = -c w - c2 w|w| + T.
TEST(Law, OfAWheelWithQuadraticLoss) {
  Wheel w = wheel_that_turns(-9);
  CoordinateLaw law;
  law.at = w.angle;
  law.damping = 0.03, law.quadratic_damping = 0.02, law.force = 0.4;
  w.model.forces.coordinate_laws.push_back(law);
  const auto exact = small_steps({-9}, 0, 1.5, 4000, [&](double, const std::vector<double>& y) {
    return std::vector<double>{
        (law.force - law.damping * y[0] - law.quadratic_damping * y[0] * std::abs(y[0])) / w.inertia};
  });
  for (const auto& f : forms) {
    const Options options = form(f, 1e-3);
    if (std::string(f.first) == "yoshida6") {
      EXPECT_NE(unsupported(w.model, options).find("quadratic damping"), std::string::npos);
      continue;
    }
    EXPECT_NEAR(spin(run(w.model, options, 1500)), exact[0], 1e-8) << f.first << f.second;
  }
  Wheel without = w;
  without.model.forces.coordinate_laws[0].quadratic_damping = 0;
  EXPECT_GT(std::abs(spin(run(without.model, with("auto", 0.01), 150)) - exact[0]), 0.1);
}

// A servo that follows a harmonic, and one that follows a table with kinks, which an integrator must not step over.
TEST(Law, OfServos) {
  for (const bool table : {false, true}) {
    Model model = body_on_rail(0.3);
    CoordinateLaw law;
    law.at = along_rail();
    law.stiffness = 60, law.damping = 1.4;
    if (table) {
      law.target.times = {0.1, 0.333, 0.75, 1.201};
      law.target.values = {0.1, 0.5, -0.4, 0.2};
    } else {
      law.target = harmonic(0.1, 0.4, 5, -0.7);
    }
    model.forces.coordinate_laws.push_back(law);
    const auto wanted = [&](double t, double from) -> std::pair<double, double> {
      if (!table) return {0.1 + 0.4 * std::cos(5 * t - 0.7), -2 * std::sin(5 * t - 0.7)};
      if (from < 0.1) return {0.1, 0};
      if (from < 0.333) return {0.1 + 0.4 * (t - 0.1) / 0.233, 0.4 / 0.233};
      if (from < 0.75) return {0.5 - 0.9 * (t - 0.333) / 0.417, -0.9 / 0.417};
      if (from < 1.201) return {-0.4 + 0.6 * (t - 0.75) / 0.451, 0.6 / 0.451};
      return {0.2, 0};
    };
    std::vector<double> y = {0, 0.3};
    const double ends[] = {0, 0.1, 0.333, 0.75, 1.201, 2};
    for (int i = 0; i < 5; ++i)
      y = small_steps(y, ends[i], ends[i + 1], 4000, [&](double t, const std::vector<double>& z) {
        const auto [value, rate] = wanted(t, ends[i]);
        return std::vector<double>{z[1],
                                   (-law.stiffness * (z[0] - value) - law.damping * (z[1] - rate)) / mass};
      });
    for (const auto& f : forms) {
      const Outcome end = run(model, form(f, 0.01), 200);
      EXPECT_NEAR(position(end.motions), y[0], f.first == std::string("yoshida6") ? 1e-7 : 1e-9)
          << f.first << f.second << table;
      EXPECT_TRUE(end.remarks.empty());
    }
  }
}

// A servo at a kink: a fixed scheme keeps its order over it.  In place and speed together: the error of the place alone
// passes through zero near 220 steps.
TEST(Law, KeepsTheOrderOverKinks) {
  Model model = body_on_rail(0.3);
  CoordinateLaw law;
  law.at = along_rail();
  law.stiffness = 60, law.damping = 1.4;
  law.target.times = {0.1, 0.333, 0.75};
  law.target.values = {0.1, 0.5, -0.4};
  model.forces.coordinate_laws.push_back(law);
  const auto exact = run(model, "rk8", 1, 4000).motions;
  const Real coarse = distance(run(model, "rk4", 1, 64).motions, exact),
             fine = distance(run(model, "rk4", 1, 512).motions, exact);
  EXPECT_NEAR(std::log2(coarse / fine) / 3, 4, 0.05);
}

// Springs on both angles of a universal joint keep the energy, with angles from the axes alone.
TEST(Law, KeepsTheEnergyOnAUniversalJoint) {
  JointScene s = joint_scene(joint_types::universal, false);
  for (const bool second : {false, true}) {
    CoordinateLaw law;
    law.at = s.angle(second);
    law.stiffness = second ? 1.5 : 2.2;
    s.model.forces.coordinate_laws.push_back(law);
  }
  for (Motion& m : s.model.motions)
    m.momentum *= 2, m.angular_momentum *= 2;  // so that springs take some of it
  const Matrix3 zero =
      (s.model.motions[1].orientation.conjugate() * s.model.motions[0].orientation).toRotationMatrix();
  const Vector3 first = s.joint().to_axis, other = zero * s.joint().axis;
  const auto potential = [&](const std::vector<Motion>& m) {
    const Matrix3 turned =
        (m[1].orientation.conjugate() * m[0].orientation).toRotationMatrix() * zero.transpose();
    // R = R(first, a) R(other, b):  R other = R(first, a) other,  R^T first = R(other, -b) first
    const Vector3 x = turned * other, y = turned.transpose() * first;
    const Real a = std::atan2(first.cross(other).dot(x), other.dot(x));
    const Real b = -std::atan2(other.cross(first).dot(y), first.dot(y));
    return 2.2 * a * a / 2 + 1.5 * b * b / 2;
  };
  const Real whole = kinetic_energy(s.model.bodies, s.model.motions);
  Real most = 0;
  run(s.model, with("auto", 0.01), 300, [&](const World& world) {
    ASSERT_NEAR(kinetic_energy(world.bodies(), world.motions()) + potential(world.motions()), whole, 1e-9);
    most = std::max(most, potential(world.motions()));
  });
  EXPECT_GT(most, 0.1);
}

// What a law works is what the energy gains.
TEST(Law, TellsItsWork) {
  for (const bool constraints : {false, true}) {
    JointScene s = joint_scene(joint_types::planar, false);
    CoordinateLaw law;
    law.at = s.displacement(s.second);
    law.stiffness = 12, law.damping = 0.6, law.force = 2;
    law.target = harmonic(0.1, 0.2, 3, 0.4);
    s.model.forces.coordinate_laws = {law, law};
    s.model.forces.coordinate_laws[1].at = s.angle();
    Options options = with("rk8", 1e-3);
    options.account = true, options.constraints = constraints;
    const Outcome end = run(s.model, options, 1000);
    ASSERT_EQ(end.works.size(), 3u);
    EXPECT_NEAR(kinetic_energy(end.bodies, end.motions) - kinetic_energy(s.model.bodies, s.model.motions),
                end.works[1] + end.works[2], 1e-10);
    EXPECT_GT(std::abs(end.works[1]), 0.01);
    EXPECT_GT(std::abs(end.works[2]), 0.01);
  }
}

// Between two bodies it pushes both alike: momentum and angular momentum stay.
TEST(Law, KeepsMomenta) {
  for (const JointKind& kind : joint_kinds) {
    JointScene s = joint_scene(kind.type, false);
    CoordinateLaw law;
    law.at = s.free_one();
    law.stiffness = 12, law.damping = 0.6, law.force = 2;
    s.model.forces.coordinate_laws.push_back(law);
    const Outcome end = run(s.model, with("auto", 0.01), 100);
    EXPECT_LT((momentum(end.motions) - momentum(s.model.motions)).norm(), 1e-11) << kind.name;
    EXPECT_LT((angular_momentum(end.motions) - angular_momentum(s.model.motions)).norm(), 1e-11) << kind.name;
    Model without = s.model;
    without.forces.coordinate_laws.clear();
    EXPECT_GT(distance(end.motions, run(without, with("auto", 0.01), 100).motions), 0.05) << kind.name;
  }
}

}  // namespace
}  // namespace cylon::engine
