// Limits of joints and dry friction in them, on every engine that says that it knows them, against closed forms.
#include "harness/core/joint_coordinates.h"
#include "harness/scenario/scenario.h"
#include "tests/conformance/adapters_joint_bounds.h"
#include "tests/conformance/adapters_joint_cases.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::conformance {
namespace {

using core::JointType;

class JointStops : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, JointStops, testing::ValuesIn(subjects_with_dart()), test_name);

// ---- Scenes -------------------------------------------------------------------------------------------

struct Stop {
  JointType type;
  bool to_a_body;  // that moves as freely; else to the world
  bool upper;
  double restitution;
  bool both = false;   // with another stop on the other side, which nothing reaches
  bool rotor = false;  // as large as what moves with the coordinate
};

std::string name_of(const Stop& stop) {
  return fmt::format("{} to {}, {}{}{}, e = {}", core::kind_of(stop.type).name,
                     stop.to_a_body ? "a body" : "the world", stop.upper ? "upper" : "lower",
                     stop.both ? " of two" : "", stop.rotor ? ", a rotor" : "", stop.restitution);
}

std::vector<Stop> stops() {
  std::vector<Stop> all;
  for (const JointType type : {JointType::slider, JointType::hinge, JointType::gimbal})
    for (const bool to_a_body : {false, true})
      for (const bool upper : {false, true})
        for (const double restitution : {0.0, 0.6}) {
          all.push_back({type, to_a_body, upper, restitution});
          if (type == JointType::hinge) all.push_back({type, to_a_body, upper, restitution, true});
          if (type == JointType::slider) all.push_back({type, to_a_body, upper, restitution, false, true});
        }
  return all;
}

// Bodies at rest whose centres of mass lie on the axis of the joint, which is a principal axis of both: what acts along the
// joint turns nothing else, and the coordinate moves as  q'' = Q (1/m + 1/m')  or  Q (1/A + 1/A'),  without m', A' of the
// world.
core::Scene on_an_axis(JointType type, bool to_a_body) {
  core::Scene scene = at_rest(to_a_body ? 2 : 1);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Body& one = scene.bodies[i];
    one.initial.position = point + (i == 0 ? 0.35 : -0.45) * axis;
    one.initial.orientation = core::Quaternion::FromTwoVectors(Vector3::UnitX(), axis);
    one.inertia = core::principal_axes(one.inertia).moments.asDiagonal();
  }
  scene.forces.clear();
  scene.joints = {joint_of(type, 0, to_a_body ? 1 : core::world)};
  if (type == JointType::gimbal) scene.joints[0].axis_2 = axis_2;  // its first angle is about the axis alone
  return scene;
}

double inverse_inertia(const core::Scene& scene) {
  double sum = 0;
  for (const core::Body& one : scene.bodies)
    sum += scene.joints[0].type == JointType::slider ? 1 / one.mass : 1 / one.inertia(0, 0);
  return sum;
}

void act(core::Scene& scene, const core::JointCoordinate& coordinate) {
  core::Joint& joint = scene.joints[0];
  if (joint.type == JointType::slider)
    joint.displacements = {{coordinate}};
  else
    joint.angles = {{coordinate}};
}

double along(const core::Scene& scene, const core::State& state) {
  const core::HeldJoint joint = core::held_joint(scene, scene.joints[0]);
  return joint.type == JointType::slider ? core::joint_displacement(joint, core::Ordinal::first, state)
                                         : core::joint_angle(joint, core::Ordinal::first, state);
}
double rate(const core::Scene& scene, const core::State& state) {
  const core::HeldJoint joint = core::held_joint(scene, scene.joints[0]);
  return joint.type == JointType::slider ? core::joint_displacement_rate(joint, core::Ordinal::first, state)
                                         : core::joint_angle_rate(joint, core::Ordinal::first, state);
}

constexpr std::int64_t steps = 4000;
double rounding(const Subject& subject) { return event_rounding(subject, steps); }

// ---- Tests ----------------------------------------------------------------------------------------------

// With a = Q w of on_an_axis() and the way d to the stop, the coordinate is there after t = sqrt(2 d/a) with v = a t, and
// at t + s  d - e v s + a s^2/2  where it bounces, and d where it does not.
TEST_P(JointStops, GiveBackTheirPart) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  std::string refused;
  for (const Stop& stop : stops()) {
    core::Scene scene = on_an_axis(stop.type, stop.to_a_body);
    constexpr double start = -0.1, way = 0.35, a = 7;
    const double s =
        stop.restitution > 0 ? 0.06 : 0.4;  // a soft stop has 20 of its time constants to come to rest
    const double sign = stop.upper ? 1 : -1;
    core::JointCoordinate acts{.start = start, .restitution = stop.restitution};
    if (stop.rotor) acts.armature = 1 / inverse_inertia(scene);
    acts.force = sign * a * (1 / inverse_inertia(scene) + acts.armature);
    (stop.upper ? acts.upper : acts.lower) = start + sign * way;
    if (stop.both) (stop.upper ? acts.lower : acts.upper) = start - sign * 1.4;
    act(scene, acts);
    const std::string what = fmt::format("{}, {}", name_of(stop), subject().id);
    if (const auto reason = refusal(engine, subject().choice(), scene)) {
      refused += fmt::format("\n  {}: {}", name_of(stop), *reason);
      continue;
    }
    ++run;
    const double hit = std::sqrt(2 * way / a), v = a * hit, e = stop.restitution;
    const double dt = (hit + s) / static_cast<double>(steps);
    const double expected = e > 0 ? way - e * v * s + a * s * s / 2 : way;
    const double found = along(scene, last(subject().choice(), scene, dt, steps));
    double allowed = rounding(subject());
    if (!locates_events(subject())) allowed += on_the_grid(e, v, a, s, dt);
    if (is_soft(subject())) allowed += soft_stop(a);
    expect_within(what, std::abs(sign * found - expected), allowed);
  }
  EXPECT_EQ(run, taken_by(subject()).stops) << "refused:" << refused;
  if (run == 0) GTEST_SKIP() << "takes none of these scenes:" << refused;
}

// A coordinate that moves by itself at v is braked by a = Q w until it stands, and then stands: x = v^2/(2 a).
TEST_P(JointStops, DryFrictionBrakesAndHolds) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  std::string refused;
  for (const JointType type : {JointType::slider, JointType::hinge, JointType::gimbal})
    for (const bool to_a_body : {false, true}) {
      core::Scene scene = on_an_axis(type, to_a_body);
      constexpr double v = 1.3, a = 2.6;
      act(scene, {.friction = a / inverse_inertia(scene)});
      (type == JointType::slider ? scene.bodies[0].initial.velocity
                                 : scene.bodies[0].initial.angular_velocity) = v * axis;
      const std::string what = fmt::format("{} to {}, {}", core::kind_of(type).name,
                                           to_a_body ? "a body" : "the world", subject().id);
      if (const auto reason = refusal(engine, subject().choice(), scene)) {
        refused += fmt::format("\n  {}: {}", what, *reason);
        continue;
      }
      ++run;
      const double dt = 2 * v / a / static_cast<double>(steps);
      const core::State end = last(subject().choice(), scene, dt, steps);
      double allowed = rounding(subject());
      if (!locates_events(subject()))
        allowed += v * dt / 2;  // Euler's v dt/2; the last step is exact or shorter
      if (is_soft(subject())) allowed += soft_friction(a);
      if (type == JointType::hinge) allowed += left_out(subject(), a, dt);
      expect_within(what, std::abs(along(scene, end) - v * v / (2 * a)), allowed);
      expect_within("stands, " + what, std::abs(rate(scene, end)),
                    rounding(subject()) + slow_friction(subject(), dt));
    }
  EXPECT_EQ(run, taken_by(subject()).frictions) << "refused:" << refused;
  if (run == 0) GTEST_SKIP() << "takes none of these scenes:" << refused;
}

// A rotor with A = k/w, k times what moves with the coordinate, leaves of its acceleration Q w the part 1/(1 + k).
TEST_P(JointStops, RotorsTakeTheirPart) {
  const core::Engine engine = process::describe(subject().choice(), limits);
  int run = 0;
  std::string refused;
  for (const JointType type : {JointType::slider, JointType::hinge, JointType::gimbal})
    for (const bool to_a_body : {false, true}) {
      core::Scene scene = on_an_axis(type, to_a_body);
      constexpr double a = 3.4, k = 1.7, t = 0.5;
      const double inverse = inverse_inertia(scene);
      act(scene, {.force = a / inverse, .armature = k / inverse});
      const std::string what = fmt::format("{} to {}, {}", core::kind_of(type).name,
                                           to_a_body ? "a body" : "the world", subject().id);
      if (const auto reason = refusal(engine, subject().choice(), scene)) {
        refused += fmt::format("\n  {}: {}", what, *reason);
        continue;
      }
      ++run;
      const double dt = t / static_cast<double>(steps), left = a / (1 + k);
      const core::State end = last(subject().choice(), scene, dt, steps);
      const double grid = locates_events(subject()) ? 0 : left * t * dt;  // twice Euler's
      expect_within(what, std::abs(along(scene, end) - left * t * t / 2), grid + rounding(subject()));
      expect_within("rate, " + what, std::abs(rate(scene, end) - left * t), rounding(subject()));
    }
  EXPECT_EQ(run, taken_by(subject()).rotors) << "refused:" << refused;
  if (run == 0) GTEST_SKIP() << "takes none of these scenes:" << refused;
}

// A puck whose rail does not lead through its centre comes to a stop at 2.5 m/s, and stays.  Where sweeps end before joint and
// stop agree, it leaves with what docs/engines.md says; with ODE's own ERP of stops with a fifth of the way past it in a step, half
// a step here.
TEST(JointStopsAlone, SweepsThatEndEarlyLeaveARate) {
  core::Scene scene = scenario::load(std::filesystem::path(source_dir) / "scenarios/rail_stops.toml").scene;
  scene.joints[0].displacements[0].restitution = 0;
  struct Row {
    const char* engine;
    double left;
  };
  for (const Row& row :
       {Row{"in-house", 0}, Row{"ode", 0}, Row{"ode/path=as-shipped", 0.5}, Row{"rapier", 0}, Row{"physx", 0},
        Row{"dart", 0}, Row{"jolt", 0.187}, Row{"jolt/velocity-steps=100", 0}, Row{"havok", 0.583}}) {
    const process::EngineChoice choice =
        process::parse_engine(row.engine, process::default_engines(binary_dir));
    if (process::missing(choice.row)) continue;
    const Vector3 velocity = last(choice, scene, 0.001, 200)[0].velocity;
    EXPECT_NEAR(-scene.joints[0].axis.dot(velocity), row.left, 2e-3) << row.engine;
  }
}

core::Scene found(const char* name) {
  return scenario::load(std::filesystem::path(source_dir) / "tests/data/found" / name).scene;
}
process::EngineChoice engine_of(const char* id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

// An arm leans on its stop, at phi = -0.1 rad, and a bob on the arm on its own, and four arms so in a chain, for ten seconds.
// What sweeps leave of a load goes on where no ERP takes it back: docs/engines.md has these numbers.
TEST(JointStopsAlone, BearALoadThatLasts) {
  const core::Scene leaning = found("leaning_arm.toml"), chain = found("leaning_chain.toml");
  const double bob = -0.8 * std::sin(0.1) - 0.1 * std::sin(0.2);
  double end = 0;
  for (int i = 1; i <= 4; ++i) end -= (i < 4 ? 0.4 : 0.2) * std::sin(0.1 * i);
  struct Row {
    const char* engine;
    double bob, end;  // heights after 10 s [m]
    double within;
  };
  for (const Row& row : {
           Row{"in-house", bob, end, 1e-12},
           Row{"ode", bob, end, 2e-2},  // a step of the blow past each stop stays
           Row{"ode-quick", bob, end, 1e-2},
           Row{"ode-quick/stop-erp=0", -0.868, -1.227, 1e-3},
           Row{"ode/path=as-expert", bob, end, 2e-2},
           Row{"bullet", bob, end, 1e-4},
           Row{"bullet/path=as-expert", bob, end, 1e-4},
           Row{"bullet-float", bob, end, 1e-4},
           Row{"bullet-multibody", bob, end, 2e-2},
           Row{"bullet/path=as-shipped", -0.1041, -0.3331, 1e-3},
           Row{"bullet/solver=sequential-impulse", -0.0999, -0.3156, 1e-3},
           Row{"bullet/solver=sequential-impulse,iterations=10", -0.1065, -0.319, 1e-3},
           Row{"bullet/stops-ahead=off,stop-erp=0,solver=sequential-impulse,iterations=10", -0.183, -1.396,
               1e-3},
           Row{"bullet/stops-ahead=off,stop-erp=0.01,solver=sequential-impulse,iterations=10", -0.122, -0.608,
               1e-3},
           Row{"bullet/stops-ahead=off,stop-erp=0.05,solver=sequential-impulse,iterations=10", -0.107, -0.382,
               1e-3},
           Row{"bullet/stops-ahead=off,stop-erp=0.01,solver=sequential-impulse,iterations=200", -0.0999,
               -0.324, 1e-3},
           Row{"bullet-multibody/solver=sequential-impulse,iterations=10", -0.1124, -1.308, 1e-3},
           Row{"bullet-multibody/erp=0.2,solver=sequential-impulse,iterations=10", -0.0998, -0.721, 1e-3},
       }) {
    EXPECT_NEAR(last(engine_of(row.engine), leaning, 1. / 240, 2400)[1].position.y(), row.bob, row.within)
        << row.engine;
    EXPECT_NEAR(last(engine_of(row.engine), chain, 1. / 240, 2400)[3].position.y(), row.end, row.within)
        << row.engine;
  }
}

// Four arms fly from stop to stop, which only take: 35.3 J, of which nothing may come back.
TEST(JointStopsAlone, GiveNothingBackInAChain) {
  const core::Scene scene = found("thrown_chain.toml");
  struct Row {
    const char* engine;
    double rise, within;  // of the energy above the least before [J]
  };
  for (const Row& row : {
           Row{"ode", 0, 1e-2},
           Row{"ode-quick", 2.0, 0.1},
           Row{"bullet", 0, 1e-2},
           Row{"bullet/path=as-expert", 0, 1e-2},
           Row{"bullet-multibody", 0.06, 1e-2},
           Row{"bullet/path=as-shipped", 4.2, 0.1},
           Row{"bullet/solver=sequential-impulse", 0.2, 0.1},
           Row{"bullet/solver=sequential-impulse,iterations=10", 11.6, 0.1},
           Row{"bullet/stops-ahead=off,stop-erp=0,solver=sequential-impulse,iterations=10", 0, 1e-2},
           Row{"bullet/stops-ahead=off,stop-erp=0.01,solver=sequential-impulse,iterations=10", 0.32, 1e-2},
           Row{"bullet/stops-ahead=off,stop-erp=0.05,solver=sequential-impulse,iterations=10", 1.9, 0.1},
           Row{"bullet/stops-ahead=off,stop-erp=0.01,solver=sequential-impulse,iterations=200", 0.01, 1e-2},
           Row{"bullet-multibody/solver=sequential-impulse,iterations=10", 0.13, 1e-2},
           Row{"bullet-multibody/erp=0.2,solver=sequential-impulse,iterations=10", 0.315, 1e-2},
       }) {
    double least = std::numeric_limits<double>::infinity(), rise = 0;
    for (const core::State& state : play(engine_of(row.engine), scene, 1. / 240, 960, 1).states) {
      const double now = core::energy_scale(scene, state);
      least = std::min(least, now), rise = std::max(rise, now - least);
    }
    EXPECT_NEAR(rise, row.rise, row.within) << row.engine;
  }
}

}  // namespace
}  // namespace cylon::conformance
