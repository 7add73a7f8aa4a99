// What the options and paths of Bullet and ODE do, against closed forms that share nothing with either
// engine.
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <map>
#include <numbers>

namespace cylon::conformance {
namespace {

constexpr double g = 9.81;

process::EngineChoice choose(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

// A body that nothing touches, with moments of inertia of its own.
core::Body body(const std::string& name, double mass, const Vector3& moments) {
  core::Body result;
  result.name = name, result.mass = mass, result.inertia = moments.asDiagonal();
  return result;
}

core::Scene thrown() {
  core::Scene scene;
  scene.bodies = {body("ball", 2, {0.3, 0.3, 0.3})};
  scene.bodies[0].initial.position = {1, 2, 3};
  scene.bodies[0].initial.velocity = {3, 4, 0.5};
  scene.forces = {core::UniformGravity{{0, -g, 0}}};
  return scene;
}

// Semi-implicit Euler is off by g T dt/2; Runge-Kutta 4 integrates a parabola exactly.
TEST(Expert, BulletsRungeKuttaFollowsParabola) {
  constexpr double dt = 1e-3, end = 0.8;
  const Vector3 exact = Vector3(1, 2, 3) + end * Vector3(3, 4, 0.5) - Vector3(0, g * end * end / 2, 0);
  const auto error = [&](const char* id) {
    return (last(choose(id), thrown(), dt, std::llround(end / dt))[0].position - exact).norm();
  };
  EXPECT_NEAR(error("bullet-multibody"), g * end * dt / 2, 1e-12);
  expect_within("parabola by rk4", error("bullet-multibody/integrator=runge-kutta-4"), 1e-12);
  expect_within("parabola as an expert", error("bullet/path=as-expert"), 1e-12);
}

// A rod on a hinge across z, its centre 0.5 m from the pivot, let go from the horizontal.
core::Scene hinged() {
  core::Scene scene;
  scene.bodies = {body("rod", 1, {0.01, 1.0 / 12, 1.0 / 12})};
  scene.bodies[0].initial.position = {0.5, 0, 0};
  scene.forces = {core::UniformGravity{{0, -g, 0}}};
  core::Joint joint;
  joint.type = core::JointType::hinge;
  joint.axis = Vector3::UnitZ();
  scene.joints = {joint};
  return scene;
}

// Angle of that rod at time t: angle'' = -(m g l/I) cos(angle), by 20000 steps of the Störmer-Verlet
// scheme, twice, and Richardson's extrapolation: an error below 1e-12.
double rod_angle(double t) {
  const double rate = g * 0.5 / (1.0 / 12 + 0.25);
  const auto verlet = [&](int steps) {
    const double h = t / steps;
    double angle = 0, speed = 0;
    for (int i = 0; i < steps; ++i) {
      speed -= h / 2 * rate * std::cos(angle);
      angle += h * speed;
      speed -= h / 2 * rate * std::cos(angle);
    }
    return angle;
  };
  return (4 * verlet(40000) - verlet(20000)) / 3;
}

TEST(Expert, BulletsRungeKuttaIsOfFourthOrderOnAHinge) {
  const double end = 2, exact = rod_angle(end);
  const auto error = [&](const char* id, std::int64_t steps) {
    const Vector3 at = last(choose(id), hinged(), end / static_cast<double>(steps), steps)[0].position;
    return std::abs(std::remainder(std::atan2(at.y(), at.x()) - exact, 2 * std::numbers::pi));
  };
  const double coarse = error("bullet-multibody/integrator=runge-kutta-4", 200),
               fine = error("bullet-multibody/integrator=runge-kutta-4", 400);
  expect_within("rod at 5 ms by rk4", fine, 2e-9);
  EXPECT_NEAR(std::log2(coarse / fine), 4, 0.4);
  EXPECT_NEAR(std::log2(error("bullet-multibody", 2000) / error("bullet-multibody", 4000)), 1, 0.1);
}

// A sphere towards a wall that is thinner than its way in a step.
core::Scene shot(double restitution) {
  core::Scene scene;
  scene.bodies = {body("bullet", 1, {0.004, 0.004, 0.004}), body("wall", 1, {1, 1, 1})};
  scene.bodies[0].shape = core::Sphere{0.1};
  scene.bodies[0].initial.position = {-1033.11, 0, 0};
  scene.bodies[0].initial.velocity = {1e4, 0, 0};
  scene.bodies[1].shape = core::Box{{0.01, 5, 5}};
  scene.bodies[1].locked = true;
  for (core::Body& one : scene.bodies) one.collide = true;
  scene.materials = {{{"*", "*"}, restitution, 0}};
  return scene;
}

TEST(Expert, BulletsContinuousDetectionStopsASphereAtAThinWall) {
  for (const char* id : {"bullet/ccd=0.9", "bullet/path=as-expert"}) {
    const core::State end = last(choose(id), shot(0.5), 1.0 / 60, 12);
    EXPECT_LT(end[0].position.x(), -0.11) << id;
    EXPECT_NEAR(end[0].velocity.x(), -5000, 1e-6) << id;
  }
  EXPECT_GT(last(choose("bullet"), shot(0.5), 1.0 / 60, 12)[0].position.x(), 100);
}

// A flat box that slides over the floor at an angle to the axes.
core::Scene sliding(double angle, double friction) {
  core::Scene scene;
  scene.bodies = {body("box", 1, {1.04 / 12, 2.0 / 12, 1.04 / 12})};
  scene.bodies[0].shape = core::Box{{0.5, 0.1, 0.5}};
  scene.bodies[0].collide = true;
  scene.bodies[0].initial.position = {0, 0.1, 0};
  scene.bodies[0].initial.velocity = {6 * std::cos(angle), 0, 6 * std::sin(angle)};
  scene.forces = {core::UniformGravity{{0, -g, 0}}};
  scene.planes = {{"floor", Vector3::UnitY(), 0}};
  scene.materials = {{{"*", "*"}, 0, friction}};
  return scene;
}

// Coulomb: v = v0 - mu g t, against the slip.  ODE's own two directions, at 30 degrees to it, brake each
// with mu N: by mu g (cos + sin) along the slip at first.
TEST(Expert, OdesFrictionAlongTheSlipIsCoulombs) {
  constexpr double angle = std::numbers::pi / 6, friction = 0.3, end = 1;
  const double speed = 6 - friction * g * end;
  const Vector3 exact = speed * Vector3(std::cos(angle), 0, std::sin(angle));
  const auto error = [&](const char* id) {
    return (last(choose(id), sliding(angle, friction), end / 240, 240)[0].velocity - exact).norm();
  };
  for (const char* id : {"ode/friction-direction=slip", "ode/path=as-expert"})
    expect_within(fmt::format("slip at 30 degrees, {}", id), error(id), 1e-6);
  // sqrt((6 cos - mu g)^2 + (6 sin - mu g)^2) with 6 sin = 3 and mu g = 2.943 m/s after a second: off by
  // 1.5 m/s.
  const Vector3 of_pyramid(6 * std::cos(angle) - friction * g, 0, 6 * std::sin(angle) - friction * g);
  EXPECT_NEAR(error("ode"), (of_pyramid - exact).norm(), 1e-6);
}

// Without dContactApprox1 mu is a force: four corners hold 4 mu newton, and slow a kilogram by that.
TEST(Expert, OdesCallbackAsShippedTakesFrictionForAForce) {
  constexpr double friction = 0.3, end = 1;
  const core::Vector3 v =
      last(choose("ode/path=as-shipped"), sliding(0, friction), end / 240, 240)[0].velocity;
  // The box starts at zero depth, so that corners may be missing in the first step.
  EXPECT_NEAR(v.x(), 6 - 4 * friction * end, 4 * friction / 240);
}

// A body on a spring of length `rest`, stretched by x along a general direction.
core::Scene on_spring(double stiffness, double damping, double rest, double x) {
  const Vector3 along = Vector3(1, -2, 2) / 3;
  core::Scene scene;
  scene.bodies = {body("bob", 1.7, {0.2, 0.2, 0.2})};
  scene.bodies[0].initial.position = (rest + x) * along;
  core::Spring spring;
  spring.stiffness = stiffness, spring.damping = damping, spring.rest_length = rest;
  scene.forces = {spring};
  return scene;
}

// Implicit Euler of m x'' = -k x - c x':  v' = (v - (h k/m) x)/(1 + h c/m + h^2 k/m),  x' = x + h v'.
double implicit_spring(double k, double c, double x, double h, int steps) {
  constexpr double mass = 1.7;
  double v = 0;
  for (int i = 0; i < steps; ++i) {
    v = (v - h * k / mass * x) / (1 + h * c / mass + h * h * k / mass);
    x += h * v;
  }
  return x;
}

TEST(Expert, OdesSoftJointsAreImplicitSprings) {
  struct Case {
    double stiffness, damping, rest;
  };
  for (const Case& c : {Case{1e6, 0, 0}, {1e6, 2000, 0}, {1e6, 30, 0.7}, {4e3, 500, 0.7}})
    for (const char* id : {"ode/springs=joint", "ode/springs=stiff", "ode/path=as-expert"}) {
      constexpr double h = 1.0 / 60, x = 0.05;
      const core::State end = last(choose(id), on_spring(c.stiffness, c.damping, c.rest, x), h, 5);
      // The rows of a joint have ODE's own rounding of 1e-10 in their softness.
      EXPECT_NEAR(end[0].position.norm() - c.rest, std::abs(implicit_spring(c.stiffness, c.damping, x, h, 5)),
                  1e-9)
          << id << ", k = " << c.stiffness << " N/m, c = " << c.damping << " N s/m";
    }
}

// A soft spring stays a force of the state before the step: semi-implicit Euler, whatever the path.
TEST(Expert, OdesSoftSpringsStayForces) {
  const core::Scene scene = on_spring(50, 0, 0.7, 0.05);
  EXPECT_EQ(
      difference(last(choose("ode/springs=stiff"), scene, 1e-3, 500), last(choose("ode"), scene, 1e-3, 500)),
      0);
}

// ---- The rules ----------------------------------------------------------------------------------

std::string set_to(const core::Terms& terms, const std::string& name) {
  for (const core::Setting& setting : terms.settings)
    if (setting.name == name) return setting.value;
  return "";
}

core::Terms terms(const char* id, const core::Scene& scene) { return play(choose(id), scene, 1e-3, 1).terms; }

// Two boxes, one on the other, of these masses.
core::Scene pile(double lower, double upper) {
  core::Scene scene = sliding(0, 0.5);
  scene.bodies[0].initial.velocity = Vector3::Zero();
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[0].name = "lower", scene.bodies[1].name = "upper";
  scene.bodies[0].mass = lower, scene.bodies[1].mass = upper;
  scene.bodies[1].initial.position.y() = 0.3;
  return scene;
}

TEST(Expert, BulletsRuleLooksAtTheSceneAlone) {
  const auto of = [](const core::Scene& scene) { return terms("bullet/path=as-expert", scene); };
  EXPECT_EQ(of(thrown()).integrator, "runge-kutta-4");
  EXPECT_EQ(of(hinged()).order, 4);
  core::Scene in_frame = thrown();
  in_frame.frame = core::Frame{{0.7, -0.4, 1.1}, Vector3::Zero()};
  EXPECT_EQ(of(in_frame).integrator, "runge-kutta-4");
  in_frame.frame->angular_velocity = {0.2, 0.5, -0.1};  // its forces are constant during a step
  EXPECT_EQ(of(in_frame).integrator, "semi-implicit-euler");
  EXPECT_EQ(terms("bullet-multibody/integrator=runge-kutta-4", in_frame).order, 1);
  EXPECT_EQ(of(on_spring(50, 0, 0.7, 0.05)).integrator, "semi-implicit-euler");
  EXPECT_EQ(set_to(of(sliding(0, 0.3)), "m_numIterations"), "200");
  EXPECT_EQ(set_to(of(sliding(0, 0.3)), "m_erp2"), "");
  EXPECT_EQ(set_to(of(shot(0.5)), "m_erp2"), "0");
  EXPECT_EQ(set_to(of(pile(1, 1)), "constraint solver"), "");
  EXPECT_EQ(set_to(of(pile(1, 2000)), "constraint solver"), "dantzig");
}

TEST(Expert, OdesRuleLooksAtTheSceneAlone) {
  const auto of = [](const core::Scene& scene) { return terms("ode/path=as-expert", scene); };
  EXPECT_EQ(set_to(of(pile(1, 1)), "solver"), "dWorldQuickStep");
  EXPECT_EQ(set_to(of(pile(1, 1)), "iterations"), "100");
  EXPECT_EQ(set_to(of(pile(1, 2000)), "solver"), "dWorldStep");
  EXPECT_EQ(set_to(of(hinged()), "solver"), "dWorldStep");
  EXPECT_EQ(set_to(of(shot(0.5)), "soft_erp"), "0");
  EXPECT_EQ(set_to(of(sliding(0, 0.3)), "contact_surface_layer"), "0.0001");
}

// Boxes that stand apart and may meet.
core::Scene apart() {
  core::Scene scene = pile(1, 1);
  scene.bodies[1].initial.position = {3, 0.1, 0};
  return scene;
}

TEST(Expert, OdesRuleTellsAStackFromBodiesThatMayMeet) {
  const core::Terms stack = terms("ode/path=as-expert", pile(1, 1)),
                    meet = terms("ode/path=as-expert", apart());
  EXPECT_EQ(set_to(stack, "solver"), "dWorldQuickStep");
  EXPECT_EQ(set_to(stack, "soft_cfm"), "");
  EXPECT_EQ(set_to(meet, "solver"), "dWorldStep");
  EXPECT_EQ(set_to(meet, "soft_cfm"), "1e-05");
  EXPECT_NE(set_to(stack, "contact_mode").find("dContactFDir1"), std::string::npos);
  EXPECT_EQ(set_to(meet, "contact_mode").find("dContactFDir1"), std::string::npos);
}

// As shipped, each setting has the engine's default, but what the scene states and one call a step.
TEST(Expert, AsShippedKeepsTheEnginesDefaults) {
  const core::Terms bullet = terms("bullet/path=as-shipped", shot(0.5));
  EXPECT_EQ(bullet.settings.size(), 3u);
  EXPECT_EQ(set_to(bullet, "activation state, canSleep"), "");
  const core::Terms ode = terms("ode/path=as-shipped", shot(0.5));
  for (const core::Setting& setting : ode.settings) {
    const bool left_to_caller = setting.engine_default == "none: set by the caller";
    if (left_to_caller || setting.name == "threading") continue;
    EXPECT_EQ(setting.value, setting.engine_default) << setting.name;
  }
  EXPECT_EQ(set_to(ode, "contact_mode"), "dContactBounce");
  EXPECT_EQ(set_to(ode, "bounce_vel"), "0");
  EXPECT_EQ(set_to(ode, "soft_cfm"), "");
}

// ---- What reports list ----------------------------------------------------------------------------

// What a run sets is listed once, as it was, also where the path sets it otherwise.
TEST(Listed, EachSettingOnceAndAsItRan) {
  struct Case {
    const char *id, *setting, *value;
  };
  for (const Case& c : {Case{"bullet/margin=0.03", "setMargin", "0.03"},
                        {"bullet/sleeping=on", "activation state, canSleep", "on"},
                        {"bullet/path=as-expert,solver=nncg", "constraint solver", "nncg"},
                        {"bullet/path=as-expert,iterations=30", "m_numIterations", "30"},
                        {"bullet-multibody/damping=0.1", "setLinearDamping, setAngularDamping", "0.1"},
                        {"bullet-multibody/max-coordinate-velocity=50", "setMaxCoordinateVelocity", "50"},
                        {"bullet-multibody/integrator=runge-kutta-4", "useRK4Integration", "on"},
                        {"ode/path=as-expert,surface-layer=0.002", "contact_surface_layer", "0.002"}}) {
    const core::Terms run = terms(c.id, pile(1, 2000));
    std::map<std::string, int> count;
    for (const core::Setting& setting : run.settings) ++count[setting.name];
    for (const auto& [name, times] : count) EXPECT_EQ(times, 1) << c.id << " lists " << name;
    EXPECT_EQ(set_to(run, c.setting), c.value) << c.id;
  }
}

// Each path of each engine lists what its rule sets.
TEST(Listed, PathsNameTheirRules) {
  const core::Engine bullet = process::describe(choose("bullet"), limits),
                     ode = process::describe(choose("ode"), limits);
  const auto value = [](const core::Engine& engine, const char* path, const char* name) {
    std::string found;
    for (const core::Path& one : engine.paths)
      if (one.name == path)
        for (const core::Setting& setting : one.settings)
          if (setting.name == name) found = setting.value;
    return found;
  };
  EXPECT_EQ(value(bullet, "as-expert", "constraint solver"), "dantzig");
  EXPECT_EQ(value(bullet, "as-expert", "m_numIterations"), "200");
  EXPECT_EQ(value(bullet, "as-expert", "useRK4Integration"), "on");
  EXPECT_EQ(value(ode, "as-expert", "solver"), "dWorldQuickStep");
  EXPECT_EQ(value(ode, "as-expert", "soft_erp"), "0");
  EXPECT_EQ(value(ode, "as-shipped", "rotation"), "infinitesimal");
}

// ---- Continuous detection ---------------------------------------------------------------------------

// A body of another shape in the place of shot()'s sphere.
core::Scene shot_of(const core::Shape& shape, const core::Matrix3& inertia) {
  core::Scene scene = shot(0.5);
  scene.bodies[0].shape = shape, scene.bodies[0].inertia = inertia;
  return scene;
}

// It is listed where it acts: a hull is swept, also turned against its principal axes; a cone is no single
// shape of Bullet's, nor is a box that is turned against them.
TEST(Listed, ContinuousDetectionWhereSomethingIsSwept) {
  const core::Hull octahedron = {
      {{0.1, 0, 0}, {-0.1, 0, 0}, {0, 0.12, 0}, {0, -0.12, 0}, {0, 0, 0.1}, {0, 0, -0.1}}};
  core::Matrix3 straight = Vector3(0.004, 0.005, 0.006).asDiagonal(), turned = straight;
  turned(0, 1) = turned(1, 0) = 0.001;
  struct Case {
    const char* name;
    core::Shape shape;
    core::Matrix3 inertia;
    bool swept;
  };
  for (const Case& c : {Case{"sphere", core::Sphere{0.1}, turned, true},
                        {"box", core::Box{{0.1, 0.1, 0.1}}, straight, true},
                        {"turned box", core::Box{{0.1, 0.1, 0.1}}, turned, false},
                        {"hull", octahedron, straight, true},
                        {"turned hull", octahedron, turned, true},
                        {"cone", core::Cone{0.1, 0.3}, straight, false},
                        {"rod", core::Rod{0.3}, straight, false}}) {
    const core::Scene scene = shot_of(c.shape, c.inertia);
    const std::string listed =
        set_to(terms("bullet/ccd=0.9", scene), "setCcdSweptSphereRadius, setCcdMotionThreshold");
    EXPECT_EQ(listed, c.swept ? "0.9" : "none") << c.name;
    const bool stops = last(choose("bullet/ccd=0.9"), scene, 1.0 / 60, 12)[0].position.x() < 0;
    EXPECT_EQ(stops, c.swept) << c.name;
  }
}

// ---- The order that Runge-Kutta 4 declares ------------------------------------------------------------

// With a spring on a free body of one inertia: forces are those of the step's beginning, so it is one.
TEST(Expert, BulletsRungeKuttaDeclaresItsOrder) {
  const char* const id = "bullet-multibody/integrator=runge-kutta-4";
  const auto declared = [&](const core::Scene& scene) { return terms(id, scene).order; };
  core::Scene on_ball = hinged();
  on_ball.joints[0].type = core::JointType::ball;
  core::Scene looped = on_ball;
  looped.joints.push_back(on_ball.joints[0]);
  looped.joints[1].point = {0, 0, 0.4};
  EXPECT_EQ(declared(thrown()), 4);
  EXPECT_EQ(declared(hinged()), 4);
  EXPECT_EQ(declared(on_ball), 2);
  EXPECT_EQ(declared(looped), 1);
  EXPECT_EQ(declared(sliding(0, 0.3)), 1);
  EXPECT_EQ(declared(three_bodies(153)), 1) << "free bases that turn";

  // x = rest + 0.05 cos(sqrt(k/m) t)
  const core::Scene spring = on_spring(50, 0, 0.7, 0.05);
  EXPECT_EQ(declared(spring), 1);
  const auto error = [&](const core::Scene& scene, std::int64_t steps) {
    const double x = last(choose(id), scene, 1.0 / static_cast<double>(steps), steps)[0].position.norm();
    return std::abs(x - 0.7 - 0.05 * std::cos(std::sqrt(50 / 1.7)));
  };
  EXPECT_NEAR(std::log2(error(spring, 2000) / error(spring, 4000)), 1, 0.2);
  // A top: it turns about its axis and falls.
  core::Scene top = on_ball;
  top.bodies[0].initial.angular_velocity = {6, 0, 0};
  const core::State reference = last(choose("in-house/integrator=rk8"), top, 1e-3, 1000);
  const auto top_error = [&](std::int64_t steps) {
    const core::State at = last(choose(id), top, 1.0 / static_cast<double>(steps), steps);
    return (at[0].position - reference[0].position).norm();
  };
  EXPECT_NEAR(std::log2(top_error(1000) / top_error(2000)), 2, 0.3);
}

}  // namespace
}  // namespace cylon::conformance
