// The smooth scenes S4 to S8 with their errors, truths and the ratios that are to be shown.
#pragma once

#include "harness/core/scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

namespace cylon::bench {

using Error = std::function<double(const core::State&, const core::State&)>;
using Truth = std::function<core::State(double)>;

struct Target {
  double error, bullet, ode;  ///< Ratios; 0: none.
};

struct Case {
  std::string name, unit, text;
  double duration;
  std::string solution;  ///< Of the catalogue; "chain": normal modes.
  Error error;
  std::vector<std::string> bullets;
  std::vector<Target> targets;
  double budget = 2;  ///< CPU of a reference's run [s].
};

inline double place_error(const core::State& a, const core::State& b) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = (a[i].position - b[i].position).norm();
    worst = std::isfinite(d) ? std::max(worst, d) : INFINITY;
  }
  return worst;
}
inline double turn_error(const core::State& a, const core::State& b) {
  return 2 * std::asin(std::min(1.0, (a[0].orientation.conjugate() * b[0].orientation).vec().norm()));
}
inline double axis_error(const core::State& a, const core::State& b) {
  const core::Vector3 y = core::Vector3::UnitY();
  const core::Vector3 u = a[0].orientation * y, v = b[0].orientation * y;
  return std::atan2(u.cross(v).norm(), u.dot(v));
}

inline constexpr int beads = 10;
inline constexpr double stiffness = 100, spacing = 1;

// Beads on a line between two walls, springs at rest length: in each the normal modes
//   u_j = sum_n sin(n pi j/(N+1)) (a_n cos w_n t + b_n sin w_n t),  w_n = 2 sqrt(k/m) sin(n pi/(2 (N+1)))
inline double displaced(int j) { return j == 1 ? 0.1 : j == 4 ? -0.07 : j == 8 ? 0.05 : 0; }
inline double pushed(int j) { return j == 3 ? 0.5 : j == 9 ? -0.3 : 0; }

inline core::State chain_state(double t) {
  core::State state(beads);
  const long double pi = std::acos(-1.0L);
  std::vector<long double> u(beads);
  for (int n = 1; n <= beads; ++n) {
    long double a = 0, b = 0;
    const long double w =
        2 * std::sqrt(static_cast<long double>(stiffness)) * std::sin(n * pi / (2 * (beads + 1)));
    for (int j = 1; j <= beads; ++j) {
      const long double s = std::sin(n * j * pi / (beads + 1)) * 2 / (beads + 1);
      a += s * static_cast<long double>(displaced(j));
      b += s * static_cast<long double>(pushed(j)) / w;
    }
    for (int j = 1; j <= beads; ++j)
      u[static_cast<std::size_t>(j - 1)] +=
          std::sin(n * j * pi / (beads + 1)) * (a * std::cos(w * t) + b * std::sin(w * t));
  }
  for (int j = 1; j <= beads; ++j) {
    const auto i = static_cast<std::size_t>(j - 1);
    state[i].position = {spacing * j + static_cast<double>(u[i]), 0, 0};
  }
  return state;
}

inline std::string chain_text() {
  std::string text;
  for (int j = 1; j <= beads; ++j)
    text += fmt::format("[[body]]\nname = \"b{}\"\nmass = 1\nposition = [{}, 0, 0]\nvelocity = [{}, 0, 0]\n",
                        j, spacing * j + displaced(j), pushed(j));
  for (int j = 0; j <= beads; ++j) {
    const bool first = j == 0, last = j == beads;
    text += fmt::format("[[spring]]\nbody = \"b{}\"\n{}\nstiffness = {}\nrest_length = {}\n", first ? 1 : j,
                        first  ? "pin = [0, 0, 0]"
                        : last ? fmt::format("pin = [{}, 0, 0]", spacing * (beads + 1))
                               : fmt::format("to = \"b{}\"", j + 1),
                        stiffness, spacing);
  }
  return text;
}

inline std::vector<Case> cases() {
  const char* top = R"(gravity = [0, -9.81, 0]
[[body]]
name = "top"
mass = 1
inertia = [0.02, 0.01, 0.02]
position = [-0.15, 0.25980762113533160, 0]
orientation = [0.96592582628906829, 0, 0, 0.25881904510252074]
angular_velocity = [-30, 51.961524227066320, 0]
[[joint]]
type = "ball"
body = "top"
point = [0, 0, 0]
)";
  const auto spring = [](const char* p, const char* v, double k, double rest) {
    return fmt::format(
        "[[body]]\nname = \"p\"\nmass = 1\nposition = {}\nvelocity = {}\n"
        "[[spring]]\nbody = \"p\"\npin = [0, 0, 0]\nstiffness = {}\nrest_length = {}\n",
        p, v, k, rest);
  };
  const auto spun = [](const char* inertia, const char* w) {
    return fmt::format("[[body]]\nname = \"b\"\nmass = 1\ninertia = {}\nangular_velocity = {}\n", inertia, w);
  };
  const std::vector<std::string> rigid = {"bullet", "bullet-float"};
  return {
      {"1 S4 spring",
       "m",
       spring("[1, 0, 0]", "[0, 2, 3]", 100, 0),
       60,
       "spring_zero_length",
       place_error,
       rigid,
       {{1e-2, 500, 250}, {1e-4, 3500, 1900}, {1e-6, 0, 0}}},
      {"2 S5 spring with rest length",
       "m",
       spring("[1.5, 0, 0]", "[0, 3, 0]", 50, 1),
       20,
       "spring_orbit",
       place_error,
       rigid,
       {{1e-2, 100, 50}, {1e-4, 4000, 1900}, {1e-6, 0, 0}}},
      {"3 chain of 10",
       "m",
       chain_text(),
       60,
       "chain",
       place_error,
       rigid,
       {{1e-2, 500, 270}, {1e-4, 3000, 1500}, {1e-6, 0, 0}}},
      {"4 S6 free symmetric top",
       "rad",
       spun("[1, 1, 2]", "[1, 0, 10]"),
       20,
       "free_symmetric_top",
       turn_error,
       rigid,
       {{1e-2, 8000, 18000}}},
      {"5 S7 Dzhanibekov",
       "rad",
       spun("[1, 2, 3]", "[0.01, 5, 0.01]"),
       60,
       "free_asymmetric_top",
       turn_error,
       rigid,
       {{1e-2, 0, 0}, {1e-6, 0, 0}, {1e-9, 0, 0}}},
      {"6 S8 heavy top",
       "rad",
       top,
       10,
       "heavy_top",
       axis_error,
       {"bullet-multibody", "bullet-multibody-float", "bullet"},
       {{1e-2, 400, 0}, {1e-4, 4500, 0}, {1e-8, 0, 0}},
       2.2},
  };
}

}  // namespace cylon::bench
