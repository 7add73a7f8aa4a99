// Rocket (Tsiolkovsky): m = m0 + mu t, the gas leaving with velocity c relative to the body, so that
// m v' = m g + F with the constant force F = mu c (+ a thrust given as a force).  With x = mu t/m0:
//
//     v = v0 + g t + F t/m0 ln(1 + x)/x
//     p = p0 + v0 t + g t^2/2 + F t^2/m0 ((1 + x) ln(1 + x) - x)/x^2
//
// Domain: gravity, one thrust per body or none, no spin (force and gas keep their direction), mass left at
// the horizon.  mu > 0 is a body that gathers mass arriving with velocity c.
#include "reference/exact/domain.h"
#include "reference/exact/mass_flow.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/variable_mass.h"

namespace cylon::exact {
namespace {

struct Rocket {
  WideState start;
  WideVector fall, push;  // g, F/m0
  Wide rate;              // mu/m0

  Rocket(const core::Scene& scene, std::size_t index) : fall(widen(gravity(scene, index))) {
    const core::Body& body = scene.bodies[index];
    const core::Thrust thrust = thrust_of(scene, index);
    start = {widen(body.initial.position), widen(body.initial.velocity), WideVector::Zero(),
             widen(body.initial.orientation)};
    const WideVector gas = widen(thrust.exhaust_velocity.value_or(core::Vector3::Zero()));
    push = start.orientation * WideVector(widen(thrust.force) + Wide(thrust.mass_rate) * gas) / body.mass;
    rate = Wide(thrust.mass_rate) / body.mass;
  }

  WideState at(Wide t) const {
    WideState s = start;
    const Wide x = rate * t;
    s.position += t * (start.velocity + t * (fall / 2 + push * log_integral(x)));
    s.velocity += t * (fall + push * log_ratio(x));
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Rocket> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth rocket(const core::Scene& scene, double horizon) {
  constexpr auto name = "rocket";
  check_variable_mass(name, scene, horizon);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Thrust thrust = thrust_of(scene, i);
    if (thrust.exchanged_velocity) {
      refuse(name,
             named(scene, static_cast<int>(i)) + " exchanges mass of a velocity in the world: accretion");
    }
    if (thrust.mass_rate != 0 && !thrust.exhaust_velocity) {
      refuse(name, named(scene, static_cast<int>(i)) + " changes its mass by matter of no stated velocity");
    }
  }
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Tsiolkovsky's rocket, dK/dt = m g + (dm/dt)(v + c)",
          .horizon = horizon};
}

}  // namespace cylon::exact
