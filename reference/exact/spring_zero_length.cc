// Harmonic motion about a point: p = c + (p0 - c) cos wt + (v0/w) sin wt, w^2 = k/m.
// Several springs on one body are one, k = sum k_i, c = (sum k_i pin_i + m g)/k; gravity only shifts c.
// Domain: each body on undamped springs of no rest length from its centre to pins in the world, its spin
// steady.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {
namespace {

struct Harmonic {
  Flight flight;
  WideVector centre;
  Wide rate;

  Harmonic(const core::Scene& scene, std::size_t index)
      : flight(scene.bodies[index].initial, core::Vector3::Zero()) {
    const Wide mass = scene.bodies[index].mass;
    Wide stiffness = 0;
    WideVector pull = mass * widen(gravity(scene, index));
    for (const core::Force& force : scene.forces) {
      const auto* spring = std::get_if<core::Spring>(&force);
      if (!spring || spring->body != static_cast<int>(index)) continue;
      stiffness += spring->stiffness;
      pull += Wide(spring->stiffness) * widen(spring->to_anchor);
    }
    centre = pull / stiffness;
    rate = std::sqrt(stiffness / mass);
  }

  WideState at(Wide t) const {
    WideState s = flight.at(t);
    const Wide c = std::cos(rate * t), sine = std::sin(rate * t);
    const WideVector offset = flight.position - centre;
    s.position = centre + offset * c + flight.velocity / rate * sine;
    s.velocity = flight.velocity * c - offset * (rate * sine);
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Harmonic> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth spring_zero_length(const core::Scene& scene, double horizon) {
  constexpr auto name = "spring_zero_length";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "spring"});
  check_springs(name, scene);
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_steady_spin(name, scene, i, horizon);
  check_no_rest_length(name, scene);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Landau & Lifshitz, Mechanics, section 23: the space oscillator",
          .horizon = horizon};
}

}  // namespace cylon::exact
