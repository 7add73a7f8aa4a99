// Each solver of contacts with friction: that it is the one which Siconos has, that it finds what NSGS finds and the exact
// motion, and what its own tolerance leaves.
#include "reference/simulators/siconos/siconos_settings.h"

#include "harness/core/simulator.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

namespace cylon::simulators {
namespace {

using siconos_border::Body;
using siconos_border::Contact;
using siconos_border::FrictionSolver;
using siconos_border::Motion;
using siconos_border::Partner;
using siconos_border::Vector;
using siconos_border::World;

constexpr double g = 9.81, radius = 0.5, mu = 0.3;

Body ball(const Vector& position, const Vector& velocity, double mass, double inertia) {
  Body one;
  one.mass = mass;
  one.inertia = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia};
  one.start.position = position, one.start.velocity = velocity;
  return one;
}
Contact on_floor(int body, double restitution = 0, double friction = mu) {
  return {body, radius, Partner::plane, -1, {0, 1, 0}, 0, restitution, friction};
}
Contact between(int body, int other) {
  return {body, radius, Partner::moving_sphere, other, {}, radius, 0, 2 * mu};
}

struct RoughScene {
  const char* name;
  std::vector<Body> bodies;
  std::vector<Contact> contacts;
  double time;                     // [s]
  Vector gravity = {0, -g, 0};     // [m/s2]
  double distance = std::nan("");  // that body 0 goes along the floor, exactly [m]
};

// A nanometre deep: where a gap is a rounding above zero, Siconos has no contact in that step.
constexpr double touching = radius * (1 - 1e-9);
constexpr double speed = 3, solid = 0.4 * radius * radius;  // [m/s], I/m of a sphere [m2]

// x = v t - mu g t^2/2 while it slips, until v t = 2/7 v/(mu g); then 5/7 v.
double slipped_then_rolled(double t) {
  const double ends = 2 * speed / (7 * mu * g);
  return speed * ends - mu * g * ends * ends / 2 + (t - ends) * speed * 5 / 7;
}

std::vector<RoughScene> rough_scenes(double mass) {
  const double inertia = mass * solid, a = 0.2;
  const Vector start = {0, touching, 0}, moving = {0.8 * speed, 0, 0.6 * speed};
  std::vector<RoughScene> all = {
      // Of so large an inertia that it does not turn: as a box.
      {"slides",
       {ball(start, moving, mass, 1e9 * mass)},
       {on_floor(0)},
       0.5,
       {0, -g, 0},
       speed * 0.5 - mu * g / 8},
      {"slips, then rolls",
       {ball(start, moving, mass, inertia)},
       {on_floor(0)},
       1.5,
       {0, -g, 0},
       slipped_then_rolled(1.5)},
      {"rolls down",
       {ball(start, {}, mass, inertia)},
       {on_floor(0)},
       0.5,
       {g * std::sin(a) * 0.8, -g * std::cos(a), g * std::sin(a) * 0.6},
       g * std::sin(a) * 5 / 56},
      {"bounces",
       {ball({0, radius + 0.0123, 0}, {1, -2, 0}, mass, inertia)},
       {on_floor(0, 0.7, 0.1)},
       0.05,
       {},
       std::nan("")},
  };
  RoughScene pile{"four balls that lean on each other", {}, {}, 0.3};
  for (int k = 0; k < 3; ++k) {
    const double angle = 2 * std::numbers::pi * k / 3, out = 2 * touching / std::sqrt(3);
    pile.bodies.push_back(ball({out * std::cos(angle), touching, out * std::sin(angle)}, {}, mass, inertia));
  }
  pile.bodies.push_back(ball({0, touching * (1 + 2 * std::sqrt(2. / 3)), 0}, {}, mass, inertia));
  for (int i = 0; i < 4; ++i) pile.contacts.push_back(on_floor(i, 0, 2 * mu));
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) pile.contacts.push_back(between(i, j));
  all.push_back(pile);
  return all;
}

constexpr double step = 1e-3;

// The motions at the end, and how many steps the solver left unsolved.
struct End {
  std::vector<Motion> motions;
  std::int64_t unsolved = 0;
  std::optional<FrictionSolver> solver;
};

End end_of(const RoughScene& scene, siconos_border::Settings settings) {
  settings.dt = step;
  World world(scene.bodies, scene.contacts, settings);
  const long steps = std::lround(scene.time / step);
  for (long n = 0; n < steps; ++n) {
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const double m = scene.bodies[i].mass;
      world.push(i, {m * scene.gravity[0], m * scene.gravity[1], m * scene.gravity[2]}, {});
    }
    world.step();
  }
  End end;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) end.motions.push_back(world.motion(i));
  end.unsolved = world.complaints().of_solver, end.solver = world.solver();
  return end;
}

double apart(const End& a, const End& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.motions.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      most = std::max({most, std::abs(a.motions[i].position[k] - b.motions[i].position[k]),
                       std::abs(a.motions[i].velocity[k] - b.motions[i].velocity[k])});
  return most;
}

siconos_border::Settings with(std::size_t solver) {
  siconos_border::Settings settings;
  settings.solver = solver;
  return settings;
}

TEST(SiconosSolvers, AreThoseThatARunAsksFor) {
  const RoughScene scene = rough_scenes(1).front();
  const std::vector<FrictionSolver>& solvers = siconos_border::friction_solvers();
  for (std::size_t k = 0; k < solvers.size(); ++k) {
    const std::optional<FrictionSolver> own = end_of(scene, with(k)).solver;
    ASSERT_TRUE(own) << solvers[k].name;
    EXPECT_EQ(own->name, solvers[k].name);
    EXPECT_EQ(own->tolerance, solvers[k].tolerance) << own->name;
    EXPECT_EQ(own->iterations, solvers[k].iterations) << own->name;
    siconos_border::Settings asked = with(k);
    asked.solver_tolerance = 3e-7, asked.solver_iterations = 7777;
    const std::optional<FrictionSolver> has = end_of(scene, asked).solver;
    EXPECT_EQ(has->name, solvers[k].name);
    EXPECT_EQ(has->tolerance, 3e-7) << has->name;
    EXPECT_EQ(has->iterations, 7777) << has->name;
  }
  RoughScene smooth = scene;
  smooth.contacts[0].friction = 0;
  EXPECT_FALSE(end_of(smooth, {}).solver);
}

// The residual of a step is relative to the speeds of contacts, here of bodies of a kilogram: a tolerance moves the speed by
// as large a part in each step at most.
TEST(SiconosSolvers, FindWhatNsgsFindsAndTheExactMotion) {
  const std::vector<FrictionSolver>& solvers = siconos_border::friction_solvers();
  constexpr double tolerance = 1e-10;
  for (const RoughScene& scene : rough_scenes(1))
    for (const double theta : {0.5, 1.})
      for (std::size_t k = 0; k < solvers.size(); ++k) {
        SCOPED_TRACE(std::string(solvers[k].name) + " " + scene.name + " " + std::to_string(theta));
        siconos_border::Settings settings = with(k);
        settings.theta = theta, settings.solver_tolerance = tolerance, settings.solver_iterations = 100000;
        const End end = end_of(scene, settings);
        settings.solver = 0;
        const End nsgs = end_of(scene, settings);
        EXPECT_EQ(end.unsolved, 0);
        const double each = tolerance * speed, steps = scene.time / step;
        EXPECT_LE(apart(end, nsgs), steps * each * std::max(1., scene.time));  // measured: at most 0.08 of it
        if (std::isnan(scene.distance)) continue;
        const Vector& x = end.motions[0].position;
        // One step of slip or of g is between the schemes and the exact motion.
        EXPECT_NEAR(std::hypot(x[0], x[2]), scene.distance, g * scene.time * step);
      }
}

TEST(SiconosSolvers, SolveEachStepWithWhatTheyHaveByThemselves) {
  const std::vector<FrictionSolver>& solvers = siconos_border::friction_solvers();
  for (const RoughScene& scene : rough_scenes(1))
    for (const double theta : {0.5, 1.})
      for (std::size_t k = 0; k < solvers.size(); ++k) {
        siconos_border::Settings settings = with(k);
        settings.theta = theta;
        EXPECT_EQ(end_of(scene, settings).unsolved, 0)
            << solvers[k].name << " " << scene.name << " " << theta;
      }
}

TEST(SiconosSolvers, GiveTheSameBitsAgain) {
  const RoughScene pile = rough_scenes(1).back();
  for (std::size_t k = 0; k < siconos_border::friction_solvers().size(); ++k)
    EXPECT_EQ(apart(end_of(pile, with(k)), end_of(pile, with(k))), 0) << k;
}

// What docs/engines.md says of tolerances: the residual adds impulses to velocities, and of balls of a gram the impulses are
// below it.  Two solvers throw such a pile apart, and report no failure; with a tolerance of 1e-10 they hold it.
TEST(SiconosSolvers, OwnTolerancesHoldNothingOfAGram) {
  const RoughScene pile = rough_scenes(1e-3).back();
  const std::vector<FrictionSolver>& solvers = siconos_border::friction_solvers();
  for (const char* name : {"fixed-point-projection", "extragradient"}) {
    const auto found = std::ranges::find(solvers, name, &FrictionSolver::name);
    ASSERT_NE(found, solvers.end());
    siconos_border::Settings settings = with(static_cast<std::size_t>(found - solvers.begin()));
    const End own = end_of(pile, settings);
    EXPECT_GT(own.motions[0].position[1], 1) << name;
    EXPECT_EQ(own.unsolved, 0) << name;
    settings.solver_tolerance = 1e-10;
    EXPECT_NEAR(end_of(pile, settings).motions[0].position[1], touching, 1e-9) << name;
  }
}

// The settings of a run say which solver it had, with what, and where that does nothing.
TEST(SiconosSolvers, AreToldWithTheirOwnValues) {
  const auto told = [](bool rough, std::map<std::string, std::string> options) {
    const SiconosKind kind{true, false, rough};
    const core::Setup setup{.dt = 1e-3, .options = std::move(options)};
    std::string all;
    for (const core::Setting& one :
         siconos_terms(siconos_settings(siconos_engine("4"), setup, kind), kind).settings)
      if (one.name.find("SICONOS") != std::string::npos)
        all += one.name + " = " + one.value + " (" + one.engine_default + "): " + one.reason + "\n";
    return all;
  };
  EXPECT_EQ(told(true, {}), "");
  EXPECT_EQ(told(true, {{"solver", "admm"}, {"solver-iterations", "50"}}),
            "FrictionContact(3, SICONOS_FRICTION_3D_...) = admm (nsgs): asked for by the run\n"
            "SICONOS_DPARAM_TOL = 1e-06 (1e-06): that solver's own\n"
            "SICONOS_IPARAM_MAX_ITER = 50 (20000): asked for by the run\n");
  EXPECT_EQ(told(false, {{"solver", "admm"}}),
            "FrictionContact(3, SICONOS_FRICTION_3D_...) = admm (nsgs): asked for by the run; it does "
            "nothing here, "
            "where no pair has friction\n");
}

}  // namespace
}  // namespace cylon::simulators
