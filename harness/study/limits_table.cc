// Table of the limit families: quantity, range, failure criterion and theoretical value.
#include "harness/study/limits_scenes.h"
#include "harness/study/limits_theory.h"

#include <array>
#include <cmath>
#include <numbers>

namespace cylon::study {
namespace {

using Theory = std::optional<double>;
using Name = std::string_view;

Theory nothing(Name, Name) { return std::nullopt; }
Theory oscillation(Name, Name integrator) { return stable_oscillation(integrator); }
// Two equal masses: (w dt)^2 = 2 k dt^2/m.
Theory stiffness(Name, Name integrator) {
  const Theory h = stable_oscillation(integrator);
  return h ? Theory(*h * *h / 2) : std::nullopt;
}
Theory damping(Name, Name integrator) { return stable_damping(integrator); }
Theory spring_run(Name, Name integrator) { return steps_until(integrator, 0.1, 0.5); }

// Bullet cuts a turn of more than pi/4 a step to 2 atan((x/(pi/4)) tan(pi/8)) (btTransformUtil); the turn at
// which that is a hundredth of x, or of a radian, too little.
Theory cut_turn(Name engine, Name) {
  if (engine != "bullet") return std::nullopt;
  constexpr double quarter = std::numbers::pi / 4;
  double low = quarter, high = 2;
  const auto off = [&](double x) {
    return x - 2 * std::atan(x / quarter * std::tan(quarter / 2)) - 0.01 * std::min(x, 1.0);
  };
  while (high - low > 1e-12) (off((low + high) / 2) > 0 ? high : low) = (low + high) / 2;
  return low;
}

constexpr Range up(double low, double high, int per_decade = 3) {
  return {.low = low, .high = high, .per_decade = per_decade};
}
constexpr Range down(double low, double high, int per_decade = 2) {
  return {.low = low, .high = high, .downward = true, .per_decade = per_decade};
}
constexpr Range counted(double low, double high) { return {.low = low, .high = high, .whole = true}; }

constexpr std::array table = {
    Family{"spring", "largest w dt of a spring", "", "the energy grows over 2000 steps", up(0.01, 100),
           spring_probe, oscillation},
    Family{"stiffness", "largest k dt^2/m of two bodies on a spring", "", "the energy grows over 2000 steps",
           up(1e-4, 1e4, 2), stiffness_probe, stiffness},
    Family{"damping", "largest c dt/m of a damper", "", "the speed grows over 2000 steps", up(0.01, 100),
           damping_probe, damping},
    Family{"spring-run", "largest number of steps on a spring at w dt = 0.1", "",
           "position error of half a radius", counted(10, 1e5), spring_run_probe, spring_run},
    Family{"turn", "largest rotation of a ball in one step", "rad",
           "the angle has an error of 1 %, or the spin is limited", up(0.01, 1000), turn_probe, cut_turn},
    Family{"tumble", "largest w dt of a tumbling brick", "",
           "energy or angular momentum has an error of 5 % within 20 rad", up(1e-3, 100), tumble_probe,
           nothing},
    Family{"origin", "largest distance from the origin", "m",
           "an orbit of 1.5 m differs by 1 % from the same orbit at the origin", up(1, 1e18, 1), origin_probe,
           nothing},
    Family{"mass-ratio", "largest mass ratio of a heavy cube on a light cube", "",
           "a cube moves by 5 mm within 2 s at 1/240 s", up(1, 1e8, 2), mass_ratio_probe, nothing},
    Family{"stack",
           "highest stack of cubes",
           "",
           "a cube moves by 5 cm within 2 s at 1/60 s",
           {.low = 1, .high = 64, .whole = true, .per_decade = 6},
           stack_probe,
           nothing},
    Family{"tunnel", "largest speed at a wall of 0.1 m", "m/s",
           "one of eight balls of 0.1 m ends behind the wall at 1/60 s", up(1, 1e5), tunnel_probe, nothing},
    Family{"small", "smallest radius of a ball that bounces", "m",
           "the rebound height differs from e^2 h by 10 %", down(1e-15, 1, 1), size_probe, nothing},
    Family{"large", "largest radius of a ball that bounces", "m",
           "the rebound height differs from e^2 h by 10 %", up(1, 1e15, 1), size_probe, nothing},
    Family{"restitution-low", "smallest restitution", "", "the rebound speed has an error of 10 %",
           down(1e-12, 0.5, 1), low_restitution_probe, nothing},
    Family{"restitution-high", "smallest 1 - restitution", "", "the lost speed has an error of 10 %",
           down(1e-12, 0.5, 1), high_restitution_probe, nothing},
    Family{"slow-bounce", "smallest speed that bounces", "m/s", "the rebound does not follow the restitution",
           down(1e-9, 10, 1), slow_bounce_probe, nothing},
    Family{"rest-run",
           "largest number of steps of a box at rest at 1/60 s",
           "",
           "creep: it moved by 1 mm",
           {.low = 10, .high = 1e5, .whole = true, .per_decade = 1},
           rest_run_probe,
           nothing},
};

}  // namespace

std::span<const Family> families() { return table; }

}  // namespace cylon::study
