// Limits and dry friction of joints in the stepping path, against events: every kind of joint and coordinate.
#include "engine/pile/body_pile.h"
#include "tests/engine/joint_scenes.h"
#include "tests/engine/rail_and_wheel.h"

namespace cylon::engine {
namespace {

// Can be stepped: a body might meet the plane, and never does.
Model over_a_far_plane(Model model) {
  for (Shape& shape : model.shapes) shape = Sphere{Real(0.1)};
  model.planes.push_back({Vector3::UnitY(), -100});
  make_touchable(model, 0);
  return model;
}

std::vector<Motion> stepped(const Model& model, Time dt, Time duration, bool swept) {
  PileSettings settings;
  if (swept) settings.exact_points = settings.direct_points = 0;
  pile::BodyPile pile(model, dt, settings);
  for (std::int64_t n = std::lround(duration / dt); n > 0; --n) pile.step();
  std::vector<Motion> end;
  pile.read(end);
  return end;
}

// The largest difference of places, turns and velocities.
Real apart(const Model& model, const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real worst = distance(a, b);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Body& body = model.bodies[i];
    worst = std::max({worst, (velocity(body, a[i]) - velocity(body, b[i])).norm(),
                      (angular_velocity(body, a[i]) - angular_velocity(body, b[i])).norm()});
  }
  return worst;
}

struct Coordinates {
  const char* name;
  Joint::Type type;
  Coordinate (*at)(const JointScene&);
};
const Coordinates coordinates[] = {
    {"slider", joint_types::slider, [](const JointScene& s) { return s.displacement(s.axis); }},
    {"cylindrical, displacement", joint_types::cylindrical,
     [](const JointScene& s) { return s.displacement(s.axis); }},
    {"cylindrical, angle", joint_types::cylindrical, [](const JointScene& s) { return s.angle(); }},
    {"planar, displacement", joint_types::planar,
     [](const JointScene& s) { return s.displacement(s.second); }},
    {"planar, angle", joint_types::planar, [](const JointScene& s) { return s.angle(); }},
    {"screw, angle", joint_types::screw, [](const JointScene& s) { return s.angle(); }},
    {"screw, displacement", joint_types::screw, [](const JointScene& s) { return s.displacement(s.axis); }},
    {"universal, first", joint_types::universal, [](const JointScene& s) { return s.angle(); }},
    {"universal, second", joint_types::universal, [](const JointScene& s) { return s.angle(true); }},
    {"gimbal, first", joint_types::gimbal, [](const JointScene& s) { return s.angle(); }},
    {"gimbal, second", joint_types::gimbal, [](const JointScene& s) { return s.angle(true); }},
    {"gimbal, third", joint_types::gimbal,
     [](const JointScene& s) { return gimbal_angles(s.model, s.joint())[2]; }},
};

Real value(const Model& model, const Coordinate& at) {
  return row_of(at, model.bodies, model.motions.data()).offset;
}

// Speeds and rates are of the order of 1 m/s, 3 rad/s and 10/s: where a blow comes a step late all differ by some ten of
// it.
TEST(JointLawsInSteps, ComeToWhatEventsSay) {
  constexpr Time duration = 0.4;
  for (const Coordinates& c : coordinates)
    for (const bool to_world : {true, false})
      for (const auto& [limited, rubs] : {std::pair{true, false}, {false, true}, {true, true}}) {
        JointScene scene = joint_scene(c.type, to_world);
        CoordinateLaw law;
        law.at = c.at(scene);
        const Real start = value(scene.model, law.at);
        const bool angle = law.at.kind == Coordinate::Kind::angle;
        law.stiffness = 2, law.target.value = start + Real(0.1);
        if (limited)
          law.lower = start - Real(0.15), law.upper = start + Real(0.2), law.restitution = Real(0.6);
        if (rubs) law.friction = angle ? Real(0.06) : Real(0.8);
        scene.model.forces.gravity = {1, -2, Real(0.5)};
        scene.model.forces.coordinate_laws.push_back(law);
        const Model model = over_a_far_plane(scene.model);
        const Outcome truth = run(model, with("auto", 0.01), 40);
        EXPECT_TRUE(truth.remarks.empty()) << c.name << ": " << truth.remarks.front();
        for (const Time dt : {1. / 500, 1. / 4000}) {
          const Real off = apart(model, truth.motions, stepped(model, dt, duration, false));
          EXPECT_LE(off, 20 * static_cast<Real>(dt))
              << c.name << (to_world ? ", world" : ", body") << (limited ? ", limits" : "")
              << (rubs ? ", friction " : " ") << dt;
        }
      }
}

// On a stop, pressed: it rests there and does not creep; and dry friction holds what is pulled by less.
TEST(JointLawsInSteps, RestWhereTheyHold) {
  for (const bool swept : {false, true}) {
    Model on_stop = body_on_rail(0), held = on_stop;
    CoordinateLaw law;
    law.at = along_rail();
    law.friction = 3;
    held.forces.gravity = 2 * rail_axis;
    held.forces.coordinate_laws = {law};
    law.friction = 0, law.lower = Real(-0.1), law.restitution = Real(0.4);
    on_stop.forces.gravity = -9 * rail_axis;
    on_stop.forces.coordinate_laws = {law};
    const Real rounding = swept ? Real(1e-6) : Real(1e-12);
    EXPECT_NEAR(along_rail(stepped(over_a_far_plane(held), 0.002, 2, swept)), 0, rounding);
    EXPECT_NEAR(along_rail(stepped(over_a_far_plane(on_stop), 0.002, 2, swept)), law.lower, rounding);

    // The same of an angle: on a stop that a torque presses it on, and held against a lesser torque.
    Wheel wheel = wheel_that_turns(0);
    CoordinateLaw turning;
    turning.at = wheel.angle, turning.upper = Real(0.7), turning.restitution = Real(0.4), turning.force = 2;
    Model pressed = wheel.model, stuck = wheel.model;
    pressed.forces.coordinate_laws = {turning};
    turning.upper = 9, turning.friction = 3;
    stuck.forces.coordinate_laws = {turning};
    const auto angle = [&](const std::vector<Motion>& motions) {
      return row_of(wheel.angle, wheel.model.bodies, motions.data()).offset;
    };
    EXPECT_NEAR(angle(stepped(over_a_far_plane(stuck), 0.002, 2, swept)), 0, rounding);
    EXPECT_NEAR(angle(stepped(over_a_far_plane(pressed), 0.002, 2, swept)), Real(0.7), rounding);
  }
}

// Two bodies alone, with stops, friction and a stiff spring between them: nothing outside acts, so both momenta stay, and
// none of the laws gives energy.
TEST(JointLawsInSteps, KeepTheMomentaOfWhatIsAlone) {
  for (const Coordinates& c : coordinates) {
    JointScene scene = joint_scene(c.type, false);
    CoordinateLaw law;
    law.at = c.at(scene);
    const Real start = value(scene.model, law.at);
    law.lower = start - Real(0.1), law.upper = start + Real(0.1), law.restitution = Real(0.5);
    law.friction = Real(0.05), law.damping = Real(50);
    scene.model.forces.coordinate_laws = {law};
    for (Shape& shape : scene.model.shapes) shape = std::monostate();
    scene.model.surfaces.assign(2, no_surface);
    const Model& model = scene.model;
    const std::vector<Motion> end = stepped(model, 1. / 500, 1, false);
    EXPECT_LT((momentum(end) - momentum(model.motions)).norm(), 1e-12) << c.name;
    EXPECT_LT((angular_momentum(end) - angular_momentum(model.motions)).norm(), 1e-12) << c.name;
    EXPECT_LE(kinetic_energy(model.bodies, end), kinetic_energy(model.bodies, model.motions)) << c.name;
  }
}

// A servo that follows a table, on a body that loses mass: stiff, it is at the target, and soft, where events say.
TEST(JointLawsInSteps, FollowATableWhileMassChanges) {
  for (const Real stiffness : {Real(60), Real(1e6)}) {
    Model model = body_on_rail(0);
    CoordinateLaw law;
    law.at = along_rail();
    law.stiffness = stiffness, law.damping = 2 * std::sqrt(stiffness);
    law.target.times = {0.1, 0.3, 0.6}, law.target.values = {0, Real(0.2), Real(-0.1)};
    law.upper = Real(0.15), law.restitution = Real(0.3);
    model.forces.coordinate_laws = {law};
    model.forces.thrusts.push_back({.body = 0, .mass_rate = Real(-0.2)});
    model.bodies[0].mass_rate = Real(-0.2);
    model = over_a_far_plane(model);
    const Outcome truth = run(model, with("auto", 0.01), 80);
    for (const Time dt : {1. / 250, 1. / 2000})
      EXPECT_LE(distance(truth.motions, stepped(model, dt, 0.8, false)), 4 * static_cast<Real>(dt))
          << stiffness << ' ' << dt;
  }
}

// Forces that are unstable in a step taken by themselves: at once at what they balance, at any step, in as many steps.
TEST(JointLawsInSteps, TakeStiffForcesImplicitly) {
  for (const bool swept : {false, true})
    for (const Real stiffness : {Real(1e5), Real(1e8)}) {
      Model servo = body_on_rail(0), damper = servo;
      CoordinateLaw law;
      law.at = along_rail();
      law.stiffness = stiffness, law.damping = std::sqrt(stiffness), law.force = 7;
      law.target.value = Real(0.25);
      servo.forces.coordinate_laws = {law};
      const Real balance = law.target.value + law.force / law.stiffness;
      EXPECT_NEAR(along_rail(stepped(over_a_far_plane(servo), 0.01, 3, swept)), balance, swept ? 1e-6 : 1e-9);

      law.stiffness = 0, law.damping = stiffness;
      damper.forces.coordinate_laws = {law};
      const Model model = over_a_far_plane(damper);
      const std::vector<Motion> end = stepped(model, 0.01, 1, swept);
      EXPECT_NEAR(rail_axis.dot(velocity(model.bodies[0], end[0])) * stiffness, law.force, 1e-6);
    }
}

// dv/dt = -c_2 v |v|/m:  v = v_0/(1 + c_2 v_0 t/m), which v = v_before/(1 + c_2 v_before h/m) meets in the middle of every
// step, and the mean of two of these to second order; it never turns round.
TEST(JointLawsInSteps, DampBySpeedSquared) {
  const Real v = 4, c = 3;
  Model model = body_on_rail(v);
  CoordinateLaw law;
  law.at = along_rail(), law.quadratic_damping = c;
  model.forces.coordinate_laws = {law};
  model = over_a_far_plane(model);
  const auto off = [&](Time dt) {
    const std::vector<Motion> end = stepped(model, dt, 1, false);
    return rail_axis.dot(velocity(model.bodies[0], end[0])) - v / (1 + c * v / rail_mass);
  };
  EXPECT_LT(std::abs(off(0.01)), 1e-5);
  EXPECT_NEAR(std::log10(off(0.1) / off(0.01)), 2, 0.05);
  law.quadratic_damping = Real(1e6);
  model.forces.coordinate_laws = {law};
  const std::vector<Motion> stopped = stepped(model, 0.1, 1, false);
  const Real left = rail_axis.dot(velocity(model.bodies[0], stopped[0]));
  EXPECT_GE(left, 0);
  EXPECT_LE(left, Real(1e-4));
}

// The same law by parts of a step and implicitly: they differ by the order of the step.
TEST(JointLawsInSteps, TakeStiffForcesToFirstOrder) {
  Wheel wheel = wheel_that_turns(3);
  CoordinateLaw law;
  law.at = wheel.angle;
  law.stiffness = Real(0.5), law.target = harmonic(Real(0.2), Real(0.4), 3, 1);
  law.damping = Real(1.5) * wheel.inertia / Real(0.01);  // of a step of 0.01 s
  wheel.model.forces.coordinate_laws = {law};
  const Model model = over_a_far_plane(wheel.model);
  const Outcome truth = run(model, with("auto", 0.01), 100);
  Real before = 0;
  for (const Time dt : {0.1, 0.05, 0.025}) {
    const Real off = distance(truth.motions, stepped(model, dt, 1, false));
    if (before > 0) {
      EXPECT_NEAR(std::log2(before / off), 1, 0.2) << dt;
    }
    before = off;
  }
}

// One angle is driven and turns the axis of the other, which lies on a stop without restitution and leaves it, or sticks by dry
// friction.  What kept to the axis of the beginning of a step was off by h/2 of what the turn of the axis makes of the rate: a
// stop let go late by the root of h, and what stuck crept.
TEST(JointLawsInSteps, HoldWhileTheirAxisTurns) {
  for (const Joint::Type type : {joint_types::universal, joint_types::gimbal})
    for (const bool rubs : {false, true}) {
      JointScene scene = joint_scene(type, false);
      CoordinateLaw drives, holds;
      drives.at = scene.angle(), holds.at = scene.angle(true);
      drives.stiffness = Real(0.5), drives.target.amplitude = 2, drives.target.frequency = 6;
      if (rubs) {
        holds.friction = 2;
      } else {
        holds.lower = Real(-0.1), holds.upper = Real(0.3);
      }
      scene.model.forces.gravity = {1, -2, Real(0.5)};
      scene.model.forces.coordinate_laws = {drives, holds};
      const Model model = over_a_far_plane(scene.model);
      const Outcome truth = run(model, with("auto", 0.01), 60);
      const auto off = [&](Time dt) { return apart(model, truth.motions, stepped(model, dt, 0.6, false)); };
      const Real coarse = off(1. / 500), fine = off(1. / 8000);
      if (rubs)
        EXPECT_LE(fine, coarse / 128) << "second order";
      else
        EXPECT_LE(fine, 40. / 8000) << "the stop's blow comes at some time within a step";
    }
}

// Negative control: the laws matter in these scenes.
TEST(JointLawsInSteps, MatterHere) {
  for (const Coordinates& c : coordinates) {
    JointScene scene = joint_scene(c.type, true);
    const Model free = over_a_far_plane(scene.model);
    CoordinateLaw law;
    law.at = c.at(scene);
    const Real start = value(scene.model, law.at);
    law.lower = start - Real(0.1), law.upper = start + Real(0.1);
    Model limited = free, rubbed = free;
    limited.forces.coordinate_laws = {law};
    CoordinateLaw rubs;
    rubs.at = law.at, rubs.friction = Real(0.3);
    rubbed.forces.coordinate_laws = {rubs};
    const auto end = [](const Model& model) { return stepped(model, 0.002, 0.4, false); };
    EXPECT_GT(apart(free, end(free), end(limited)), Real(0.2)) << c.name;
    EXPECT_GT(apart(free, end(free), end(rubbed)), Real(0.02)) << c.name;
  }
}

}  // namespace
}  // namespace cylon::engine
