// Plug-ins behind cylon/force.h on the in-house engine: laws of docs/examples/force, and laws that no one should write.
#include "harness/core/input_error.h"
#include "harness/core/simulator.h"
#include "harness/scenario/scenario.h"
#include "tests/paths.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <memory>
#include <string>

namespace cylon {
namespace {

std::string library(const char* name) { return fmt::format("{}/{}.so", binary_dir, name); }

std::unique_ptr<core::Simulator> engine() {
  auto simulator = core::make_simulator();
  simulator->admit("laws", library("example_laws"));
  simulator->admit("odd", library("odd_laws"));
  simulator->admit("later", library("later_laws"));
  simulator->admit("text", std::string(source_dir) + "/README.md");
  simulator->admit("none", std::string(binary_dir) + "/none.so");
  simulator->admit("other", library("libcylon-mpi"));
  return simulator;
}

core::Scene scene(const std::string& rest, const std::string& of_body = "") {
  return scenario::parse(
             "duration = 1\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1.3\nposition = [0.4, 0.7, -0.2]\n"
             "velocity = [0.3, -0.1, 0.5]\nangular_velocity = [1.2, -0.7, 0.9]\n"
             "inertia = [0.5, 0.7, 1.0]\n" +
                 of_body + rest,
             "plugin.toml")
      .scene;
}

std::string table(const std::string& plugin, const std::string& law, const std::string& parameters = "",
                  const std::string& bodies = "\"a\"") {
  return fmt::format("[[plugin_force]]\nplugin = \"{}\"\nlaw = \"{}\"\nbodies = [{}]\n", plugin, law,
                     bodies) +
         (parameters.empty() ? "" : fmt::format("parameters = {{ {} }}\n", parameters));
}

core::State after(const core::Scene& scene, const core::Setup& setup, int steps) {
  const auto simulator = engine();
  const core::Loaded loaded = simulator->load_if_supported(scene, setup);
  EXPECT_EQ(loaded.unsupported.value_or(""), "");
  simulator->advance(steps);
  core::State state;
  simulator->read(state);
  return state;
}

double apart(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    worst = std::max({worst, (a[i].position - b[i].position).norm(), (a[i].velocity - b[i].velocity).norm(),
                      (a[i].angular_velocity - b[i].angular_velocity).norm(),
                      (a[i].orientation.coeffs() - b[i].orientation.coeffs()).norm()});
  return worst;
}

const core::Setup by_rk4 = {.dt = 0.01, .integrator = "rk4"};

// The laws of the engine's own tables, through C and back: to rounding.
TEST(Plugin, ThatCopiesGravityFallsAsGravityDoes) {
  const std::string axes = "gravity = [0.3, -9.81, 0.7]\n";
  const core::Scene own =
      scenario::parse(axes +
                          "duration = 1\nstep = 0.01\n[[body]]\nname = \"a\"\nmass = 1.3\n"
                          "position = [0.4, 0.7, -0.2]\nvelocity = [0.3, -0.1, 0.5]\n"
                          "angular_velocity = [1.2, -0.7, 0.9]\ninertia = [0.5, 0.7, 1.0]\n",
                      "own.toml")
          .scene;
  const core::Scene user = scene(table("odd", "fall", "x = 0.3, z = 0.7"));  // y by default
  EXPECT_LT(apart(after(own, by_rk4, 100), after(user, by_rk4, 100)), 1e-12);
  const core::Scene other = scene(table("odd", "fall", "x = 0.3, y = -9.8, z = 0.7"));
  EXPECT_GT(apart(after(own, by_rk4, 100), after(other, by_rk4, 100)), 1e-3);
}

// A law that reads orientation, inertia and angular velocity.
TEST(Plugin, ThatCopiesDragOfTheSpinIsThatDrag) {
  const core::Scene own = scene("[[drag]]\nbody = \"a\"\nmomentum = 0.4\n"),
                    user = scene(table("odd", "slow_down", "c = 0.4"));
  EXPECT_LT(apart(after(own, by_rk4, 100), after(user, by_rk4, 100)), 1e-12);
  EXPECT_GT(apart(after(scene(""), by_rk4, 100), after(user, by_rk4, 100)), 0.1);
}

// x = A cn(w t, k): tests/engine/user_force_test.cc has the formula.
TEST(Plugin, DuffingFollowsJacobisFunction) {
  const auto scenario =
      scenario::load(std::filesystem::path(source_dir) / "docs/examples/force/duffing.toml");
  const double a = 3.0 / 2, b = 20.0 / 2, start = 0.7, w = std::sqrt(a + b * start * start),
               k = std::sqrt(b / 2) * start / w;
  for (const int steps : {100, 237, 400}) {
    const double t = 0.01 * steps;
    double phi = w * t;
    for (int i = 0; i < 50; ++i)
      phi -= (std::ellint_1(k, phi) - w * t) * std::sqrt(1 - std::pow(k * std::sin(phi), 2));
    const core::State state = after(scenario.scene, {.dt = 0.01}, steps);
    EXPECT_NEAR(state[0].position.x(), start * std::cos(phi), 1e-9) << t;
  }
}

// F = -c |v| v along a line:  v = v0/(1 + c v0 t/m),  x = x0 + (m/c) ln(1 + c v0 t/m)
TEST(Plugin, FastDragFollowsItsFormula) {
  const core::Scene s = scene(table("laws", "fast_drag", "c = 0.8"));
  const core::State end = after(s, {.dt = 0.01}, 100);
  const core::Vector3 v = s.bodies[0].initial.velocity, x = s.bodies[0].initial.position;
  const double v0 = v.norm(), q = 1 + 0.8 * v0 / 1.3;
  EXPECT_LT((end[0].velocity - v / q).norm(), 1e-10);
  EXPECT_LT((end[0].position - (x + 1.3 / 0.8 * std::log(q) * v / v0)).norm(), 1e-10);
}

TEST(Plugin, IsRefusedWithTheReason) {
  const struct {
    std::string scene;
    const char* says;
  } rows[] = {
      {table("own", "fall"), "--plugin own=FILE"},
      {table(library("odd_laws"), "fall"), "let it take part by --plugin"},  // a name is no file
      {table("later", "fall"), "was compiled with version 2 of cylon/force.h, and this engine takes 1"},
      {table("text", "fall"), "cannot be loaded: "},
      {table("none", "fall"), "cannot be loaded: "},
      {table("odd", "fal"), "has no law 'fal', did you mean 'fall'?"},
      {table("odd", "fall", "u = 1"), "has no parameter 'u'"},
      {table("laws", "duffing"), "needs the parameter 'cubic'"},
      {table("odd", "slow_down", "c = 11"), "c = 11, but must be in [0, 10]"},
      {table("odd", "never"), "law 'never' of plug-in 'odd': it never acts"},
      {table("odd", "three"), "acts on 2 to 3 bodies, not on 1"},
  };
  const auto simulator = engine();
  for (const auto& row : rows) {
    const std::string reason =
        simulator->load_if_supported(scene(row.scene), by_rk4).unsupported.value_or("");
    EXPECT_NE(reason.find(row.says), std::string::npos) << row.scene << reason;
  }
  EXPECT_THROW(simulator->admit("odd", "twice.so"), std::invalid_argument);
}

TEST(Plugin, ThatIsNotFiniteEndsTheRun) {
  const auto simulator = engine();
  ASSERT_FALSE(
      simulator->load_if_supported(scene(table("odd", "break_down", "when = 0.5")), by_rk4).unsupported);
  simulator->advance(50);
  try {
    simulator->advance(50);
    FAIL() << "it goes on";
  } catch (const core::GaveUp& reason) {
    const std::string text = reason.what();
    EXPECT_NE(text.find("law 'break_down' of plug-in 'odd' gives no finite force on body 'a' at t = 0.5"),
              std::string::npos)
        << text;
  }
}

// What a file may not say.
TEST(Plugin, RefusalsOfTheReader) {
  const struct {
    std::string text;
    const char* says;
  } rows[] = {
      {table("p", "l", "", ""), "must name one body at least"},
      {table("p", "l", "", "\"a\", \"a\""), "'a' is named twice"},
      {table("p", "l", "", "\"b\""), "no body has that name"},
      {table("p", "l", "k = \"x\""), "k must be a number"},
      {table("p", "l", "k = inf"), "must be finite"},
      {"[[plugin_force]]\nplugin = \"p\"\nbodies = [\"a\"]\n", "needs 'law'"},
      {table("p", "l") + "[[claim]]\nconserves = \"energy\"\ntolerance = { absolute = 1, reason = \"r\" }\n",
       "whose potential energy is not known"},
      {table("p", "l") + "[[claim]]\nfollows = \"projectile\"\nobservable = \"position\"\n"
                         "tolerance = { absolute = 1, reason = \"r\" }\n",
       "plugin_force"},
  };
  for (const auto& row : rows) {
    std::string said;
    try {
      scene(row.text);
    } catch (const core::InputError& error) {
      said = error.what();
    }
    EXPECT_NE(said.find(row.says), std::string::npos) << row.text << said;
  }
}

}  // namespace
}  // namespace cylon
