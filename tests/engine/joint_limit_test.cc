// Limits and dry friction of joints, as events: against closed forms, and at rest.
#include "tests/engine/rail_and_wheel.h"

#include <numbers>

namespace cylon::engine {
namespace {

constexpr Real mass = rail_mass;
const Vector3& axis = rail_axis;

CoordinateLaw law_of_slider() {
  CoordinateLaw law;
  law.at = along_rail();
  return law;
}

// `pull` along the line [m/s^2].
Model slider(Real speed, Real pull, const CoordinateLaw& law) {
  Model model = body_on_rail(speed);
  model.forces.gravity = pull * axis + 3 * axis.unitOrthogonal();
  model.forces.coordinate_laws.push_back(law);
  return model;
}

Wheel wheel(Real speed, CoordinateLaw law) {
  Wheel w = wheel_that_turns(speed);
  w.angle.origin = law.at.origin;
  law.at = w.angle;
  w.model.forces.coordinate_laws.push_back(law);
  return w;
}

Real position(const std::vector<Motion>& motions) { return along_rail(motions); }
Real speed(const World& world) { return axis.dot(velocity(world.bodies()[0], world.motions()[0])); }
Real spin(const World& world) { return axis.dot(angular_velocity(world.bodies()[0], world.motions()[0])); }

const bool both_forms[] = {false, true};
Options form(bool constraints, Time dt, const char* integrator = "auto") {
  Options options = with(integrator, dt);
  options.constraints = constraints;
  return options;
}

// Between two stops without loss: a triangle wave, and the energy stays.
TEST(Limit, ElasticStopsGiveATriangleWave) {
  CoordinateLaw law = law_of_slider();
  law.lower = -0.23, law.upper = 0.41, law.restitution = 1;
  const Real v = 1.7, width = law.upper - law.lower;
  for (const bool constraints : both_forms)
    for (const char* integrator : {"auto", "rk8", "velocity-verlet"})
      run(slider(v, 0, law), form(constraints, 0.01, integrator), 300, [&](const World& world) {
        const Real way = std::fmod(static_cast<Real>(v * world.time()) - law.lower, 2 * width);
        const Real exact = law.lower + (way < width ? way : 2 * width - way);
        ASSERT_NEAR(position(world.motions()), exact, 1e-10) << integrator << world.time();
        ASSERT_NEAR(std::abs(speed(world)), v, 1e-12);
      });
}

// Falls on a stop and bounces to rest: flights shrink by e, and end at t = v/g (1 + e)/(1 - e) after the first
// impact; then it lies there and does not creep.
TEST(Limit, BouncesToRestAndStays) {
  CoordinateLaw law = law_of_slider();
  law.lower = -0.3, law.restitution = 0.6;
  const Real g = 9.81, fall = std::sqrt(2 * 0.3 / g), v = g * fall;
  const Real ends = fall + v / g * (2 * law.restitution) / (1 - law.restitution);
  for (const bool constraints : both_forms) {
    Real rest = 0;
    const Outcome end = run(slider(0, -g, law), form(constraints, 0.01), 400, [&](const World& world) {
      const Real t = static_cast<Real>(world.time());
      if (t < fall) return;
      Real hit = fall, up = law.restitution * v;
      while (hit + 2 * up / g <= t && up > 1e-9) hit += 2 * up / g, up *= law.restitution;
      const Real since = t - hit;
      const Real exact = t < ends - 1e-6 ? up * since - g / 2 * since * since : 0;
      ASSERT_NEAR(position(world.motions()) - law.lower, exact, 1e-9) << world.time();
      if (std::abs(t - 2) < 1e-9) rest = position(world.motions());
      if (t > 2) {
        ASSERT_EQ(position(world.motions()), rest) << "creeps";
      }
    });
    EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
    EXPECT_TRUE(end.impacts.empty()) << "no surfaces met";
  }
}

// The same of an angle, which a torque alone presses: its rates are small beside what this torque gives, whatever the
// force on the body is (none here).
TEST(Limit, OfAWheelBouncesToRestAndStays) {
  CoordinateLaw law;
  law.lower = -0.3, law.restitution = 0.6, law.force = -0.4;
  const Wheel w = wheel(0, law);
  const Real a = 0.4 / w.inertia, fall = std::sqrt(2 * 0.3 / a), v = a * fall;
  const Real ends = fall + v / a * (2 * law.restitution) / (1 - law.restitution);
  for (const bool constraints : both_forms) {
    const Outcome end = run(w.model, form(constraints, 0.01), 400, [&](const World& world) {
      const Real t = static_cast<Real>(world.time());
      if (t < fall) return;
      Real hit = fall, up = law.restitution * v;
      while (hit + 2 * up / a <= t && up > 1e-9) hit += 2 * up / a, up *= law.restitution;
      ASSERT_NEAR(spin(world), t < ends - 1e-6 ? up - a * (t - hit) : 0, 1e-7) << world.time();
      if (t > ends + 0.01) {
        ASSERT_EQ(spin(world), 0) << world.time();
      }
    });
    EXPECT_LT(ends, 3) << "it rests for a second";
    EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
  }
}

// Without restitution it stays where it strikes while it is pressed, and leaves when the pull turns round.
TEST(Limit, PlasticStopHoldsUntilItIsPulledAway) {
  CoordinateLaw law = law_of_slider();
  law.upper = 0.2;
  law.stiffness = 30, law.target = harmonic(0.1, 0.4, 4, 0);
  // Pressed while target(t) > upper:  cos(4 t) > 0.25;  it arrives before that ends and then leaves with no speed.
  const Real leaves = std::acos(0.25) / 4;
  for (const bool constraints : both_forms) {
    const auto exact =
        small_steps({0.2, 0}, leaves, leaves + 0.3, 4000, [&](double t, const std::vector<double>& y) {
          return std::vector<double>{y[1], -30 / mass * (y[0] - 0.1 - 0.4 * std::cos(4 * t))};
        });
    Model model = slider(0.9, 0, law);
    model.forces.gravity.setZero();
    Options options = form(constraints, (leaves + 0.3) / 100);
    Real at_stop = 0;
    const Outcome end = run(model, options, 100, [&](const World& world) {
      ASSERT_LE(position(world.motions()), law.upper + 1e-12);
      if (std::abs(position(world.motions()) - law.upper) < 1e-13) at_stop = static_cast<Real>(world.time());
    });
    EXPECT_NEAR(at_stop, leaves, 0.01);
    EXPECT_NEAR(position(end.motions), exact[0], 1e-9);
  }
}

// Height over the stop at the origin, thrown upwards at v:  flights of 2 v/g, each at e times the speed before.
// The margin of a gap was a part of its distance from the origin, which is nothing here, and the blows never ended;
// and a gap that rounding left a little above 0 after a blow was a blow again at once.
TEST(Limit, AtTheOriginOfTheWorldKeepsItsRestitution) {
  const Real g = 9.81;
  for (const Real e : {Real(1), Real(0.9), Real(0.5)})
    for (const bool constraints : both_forms) {
      Model model;
      add_body(model, make_body(mass, general_inertia(0.05, 0.07, 0.1)), {0, 0, 0}, {0, 0, 0}, {0, 1, 0},
               {0, 0, 0});
      model.joints.push_back({.type = joint_types::slider, .body = 0, .to_axis = Vector3::UnitY()});
      CoordinateLaw law;
      law.at.axis = Vector3::UnitY(), law.lower = 0, law.upper = 0.5, law.restitution = e;
      model.forces.gravity = {0, -g, 0};
      model.forces.coordinate_laws.push_back(law);
      const Outcome end = run(model, form(constraints, 0.01), 200, [&](const World& world) {
        Real t = static_cast<Real>(world.time()), v = 1;
        for (; t > 2 * v / g && v > 1e-6; v *= e) t -= 2 * v / g;
        const Real height = v > 1e-6 ? v * t - g * t * t / 2 : 0;
        ASSERT_NEAR(world.motions()[0].position.y(), height, 1e-10) << e << ' ' << world.time();
      });
      EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
    }
}

// From rest under a constant torque, in steps in which it turns by several radians: the stop at u is met after
// sqrt(2 u/a) at sqrt(2 u a), and again after 2 e w/a.  The rate at the start, which is 0, was all that bounded a piece.
TEST(Limit, OfAnAngleThatSpeedsUpWithinAStepIsMet) {
  constexpr Real a = 1600, e = 0.5, dt = 0.1;
  // Classical Runge-Kutta is off by percents in pieces of up to 2 rad; a missed stop would be off by (1 + e) w, above 100.
  for (const auto& [integrator, tolerance] :
       {std::pair{"auto", 1e-6 * a}, std::pair{"rk8", 1e-6 * a}, std::pair{"rk4", Real(4)}})
    for (const bool constraints : both_forms)
      for (const Real upper : {Real(1.5), Real(4), Real(7), Real(7.9)}) {
        CoordinateLaw law;
        law.upper = upper, law.restitution = e;
        law.force = a * wheel(0, law).inertia;
        const Outcome end = run(wheel(0, law).model, form(constraints, dt, integrator), 1);
        Real t = dt - std::sqrt(2 * upper / a), w = std::sqrt(2 * upper * a);
        for (w *= e; t > 2 * w / a; w *= e) t -= 2 * w / a;
        EXPECT_NEAR(axis.dot(angular_velocity(end.bodies[0], end.motions[0])), a * t - w, tolerance)
            << integrator << ' ' << upper << ' ' << constraints;
      }
}

// A wheel between stops more than a turn apart: the angle is that of all its turns.
TEST(Limit, OfAnAngleCountsTurns) {
  CoordinateLaw law;
  law.lower = -1, law.upper = 9, law.restitution = 0.8;
  const Real w = 12;
  const Wheel turning = wheel(w, law);
  for (const bool constraints : both_forms) {
    Real turned = 0, rate = w, t = 0;
    run(turning.model, form(constraints, 0.013), 300, [&](const World& world) {
      const Real now = static_cast<Real>(world.time());
      for (Real hit; hit = t + ((rate > 0 ? law.upper : law.lower) - turned) / rate, hit <= now;) {
        t = hit, turned = rate > 0 ? law.upper : law.lower;
        rate *= -law.restitution;
      }
      turned += rate * (now - t), t = now;
      ASSERT_NEAR(spin(world), rate, 1e-9) << now;
    });
    EXPECT_LT(std::abs(rate), 0.6 * w) << "it struck stops";
  }
}

// m q'' = -F sign(q'):  stops after v^2/(2 F/m) and stays, to rounding.
TEST(Friction, StopsABlock) {
  CoordinateLaw law = law_of_slider();
  law.friction = 2.1;
  const Real v = 0.9, brake = law.friction / mass, stop = v / brake;
  for (const bool constraints : both_forms)
    for (const char* integrator : {"auto", "rk8", "yoshida4"}) {
      Real rest = 0;
      Model model = slider(v, 0, law);
      run(model, form(constraints, 0.01, integrator), 200, [&](const World& world) {
        const Real t = std::min(stop, static_cast<Real>(world.time()));
        ASSERT_NEAR(position(world.motions()), v * t - brake * t * t / 2, 1e-10)
            << integrator << world.time();
        if (std::abs(world.time() - 1) < 1e-9) rest = position(world.motions());
        if (world.time() > 1) {
          ASSERT_EQ(position(world.motions()), rest) << "creeps";
        }
      });
    }
}

// On a slope it holds up to its largest force, and slides beyond with the difference.
TEST(Friction, HoldsOnASlope) {
  CoordinateLaw law = law_of_slider();
  law.friction = 2.1;
  for (const bool constraints : both_forms)
    for (const Real part : {0.9, 1.2}) {
      const Real pull = part * law.friction / mass;
      const Outcome end = run(slider(0, -pull, law), form(constraints, 0.01), 100);
      if (part < 1) {
        EXPECT_EQ(position(end.motions), 0);
      } else {
        EXPECT_NEAR(position(end.motions), -(pull - law.friction / mass) / 2, 1e-10);
      }
    }
}

// On a spring dry friction takes 2 F/k from each half swing, and holds where the spring pulls by less than F.
TEST(Friction, DampsASpringByEqualSteps) {
  CoordinateLaw law;
  law.stiffness = 1.9, law.friction = 0.31, law.at.origin = 1.5;
  const Wheel w = wheel(0, law);
  const Real half = std::numbers::pi / std::sqrt(law.stiffness / w.inertia),
             lost = law.friction / law.stiffness;
  const auto exact = [&](Real t) {
    Real from = law.at.origin, sign = -1;
    for (; t > half && std::abs(from) > lost; t -= half, sign = -sign) from = -from - 2 * sign * lost;
    if (!(std::abs(from) > lost)) return from;
    const Real centre = -sign * lost;
    return centre + (from - centre) * std::cos(std::numbers::pi * t / half);
  };
  for (const bool constraints : both_forms) {
    const Outcome end = run(w.model, form(constraints, 0.01), 400, [&](const World& world) {
      const Vector3 mark = world.motions()[0].orientation * w.model.forces.coordinate_laws[0].at.mark;
      const Vector3& zero = w.model.forces.coordinate_laws[0].at.zero;
      const Real turned = law.at.origin + std::atan2(axis.cross(zero).dot(mark), zero.dot(mark));
      ASSERT_NEAR(turned, exact(static_cast<Real>(world.time())), 1e-12) << world.time();
    });
    EXPECT_TRUE(end.remarks.empty()) << end.remarks.front();
    EXPECT_EQ(axis.dot(end.motions[0].angular_momentum), 0) << "it rests";
  }
}

// A body on a universal joint at its centre of mass: where one angle is held by dry friction, the other turns on.  It was
// stopped with the one, as the centre of mass does not move.
TEST(Friction, OfOneAngleLeavesTheOther) {
  const Vector3 second = axis.unitOrthogonal(), turn = {0.5, 1.1, -0.6};
  const Real w = 1.7;
  Model model;
  add_body(model, make_body(mass, general_inertia(0.05, 0.07, 0.1)), rail_start, turn, {0, 0, 0}, w * second);
  CoordinateLaw law;
  law.at.kind = Coordinate::Kind::angle;
  law.at.axis = axis, law.at.zero = second;
  law.at.mark = exponential(turn).conjugate() * second;
  law.friction = 5;
  model.joints.push_back({.type = joint_types::universal,
                          .body = 0,
                          .to_anchor = rail_start,
                          .axis = law.at.mark,
                          .to_axis = axis});
  model.forces.coordinate_laws.push_back(law);
  for (const bool constraints : both_forms)
    for (const char* integrator : {"auto", "rk8"})
      run(model, form(constraints, 0.01, integrator), 100, [&](const World& world) {
        const Vector3 turns = angular_velocity(world.bodies()[0], world.motions()[0]);
        ASSERT_LT((turns - w * second).norm(), 1e-10) << integrator << world.time();
      });
}

// A spring whose end is drawn along sticks until it pulls with F, then slips:  m s'' = k (v t - s) - F.
TEST(Friction, SticksUntilItIsDrawnAway) {
  CoordinateLaw law = law_of_slider();
  law.friction = 2.1, law.stiffness = 50;
  law.target.times = {0, 10}, law.target.values = {0, 5};
  const Real drawn = 0.5, begins = law.friction / (law.stiffness * drawn), w = std::sqrt(50 / mass);
  for (const bool constraints : both_forms) {
    Model model = slider(0, 0, law);
    model.forces.gravity.setZero();
    run(model, form(constraints, 0.004), 40, [&](const World& world) {
      const Real t = static_cast<Real>(world.time()) - begins;
      const Real exact = t < 0 ? 0 : drawn * (t - std::sin(w * t) / w);
      ASSERT_NEAR(position(world.motions()), exact, 1e-10) << world.time();
    });
  }
}

// Joints of every new kind with limits and friction on what they leave free: energy never rises.
TEST(Limit, GiveNoEnergy) {
  for (const JointKind& kind : joint_kinds)
    for (const bool to_world : both_forms) {
      JointScene s = joint_scene(kind.type, to_world);
      CoordinateLaw law;
      law.at = s.free_one();
      const Real now = kind.type.turn == Joint::Turn::never ? 0.3 : 0;
      law.lower = now - 0.2, law.upper = now + 0.15, law.restitution = 0.9, law.friction = 0.05;
      s.model.forces.coordinate_laws.push_back(law);
      Real before = kinetic_energy(s.model.bodies, s.model.motions), first = before;
      run(s.model, with("auto", 0.01), 200, [&](const World& world) {
        const Real e = kinetic_energy(world.bodies(), world.motions());
        ASSERT_LT(e, before + 1e-10) << kind.name << to_world << world.time();
        before = e;
        ASSERT_LT(opened(world.motions(), s.joint()), 1e-12) << kind.name;
        const Real q = row_of(law.at, world.bodies(), world.motions().data()).offset;
        ASSERT_GT(q, law.lower - 1e-11) << kind.name << world.time();
        ASSERT_LT(q, law.upper + 1e-11) << kind.name << world.time();
      });
      EXPECT_LT(before, 0.99 * first) << kind.name << "lost nothing: it met no limit";
    }
}

}  // namespace
}  // namespace cylon::engine
