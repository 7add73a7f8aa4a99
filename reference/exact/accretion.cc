// A body whose mass m = m0 + mu t comes from, or goes to, surroundings of velocity u in the world:
// d(m v)/dt = m g + mu u.  With y = v - u, d(m y)/dt = m g, x = mu t/m0:
//
//     v = u + (y0 + g t (1 + x/2))/(1 + x)
//     p = p0 + u t + y0 t ln(1 + x)/x + g t^2 (x + x^2/2 - ln(1 + x))/(2 x^2)
//
// Domain: gravity, one thrust per body or none with `exchanged_velocity` and no force, no spin, mass left at
// the horizon.
#include "reference/exact/domain.h"
#include "reference/exact/mass_flow.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"
#include "reference/exact/variable_mass.h"

namespace cylon::exact {
namespace {

struct Drop {
  WideState start;
  WideVector fall, surroundings;  // g, u
  Wide rate;                      // mu/m0

  Drop(const core::Scene& scene, std::size_t index) : fall(widen(gravity(scene, index))) {
    const core::Body& body = scene.bodies[index];
    const core::Thrust thrust = thrust_of(scene, index);
    start = {widen(body.initial.position), widen(body.initial.velocity), WideVector::Zero(),
             widen(body.initial.orientation)};
    surroundings = widen(thrust.exchanged_velocity.value_or(core::Vector3::Zero()));
    rate = Wide(thrust.mass_rate) / body.mass;
  }

  WideState at(Wide t) const {
    WideState s = start;
    const Wide x = rate * t;
    const WideVector relative = start.velocity - surroundings;
    s.position += t * (surroundings + relative * log_ratio(x) + t * fall * weight_integral(x));
    s.velocity = surroundings + (relative + fall * (t * (1 + x / 2))) / (1 + x);
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Drop> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth accretion(const core::Scene& scene, double horizon) {
  constexpr auto name = "accretion";
  check_variable_mass(name, scene, horizon);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Thrust thrust = thrust_of(scene, i);
    const std::string of = named(scene, static_cast<int>(i));
    if (thrust.exhaust_velocity) refuse(name, of + " throws mass out relative to itself: rocket");
    if (!thrust.force.isZero(0.0)) refuse(name, of + " has a thrust besides");
    if (thrust.mass_rate != 0 && !thrust.exchanged_velocity) {
      refuse(name, of + " changes its mass by matter of no stated velocity");
    }
  }
  return {
      .state = solve(scene),
      .error = rounding_error(scene, solve, horizon),
      .source = "momentum with mass that enters or leaves at a given velocity, d(m v)/dt = m g + (dm/dt) u",
      .horizon = horizon};
}

}  // namespace cylon::exact
