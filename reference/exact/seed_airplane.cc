// Body with a constant thrust in body axes that turns steadily about a principal axis n with the rate w: with
// f the thrust's acceleration at t = 0, f = f_n + f_a along and across n,
//
//     p = p0 + v0 t + (g + f_n) t^2/2 + f_a Re Z + n x f_a Im Z,   Z = int int exp(i w t) = [0, 0, i w]
//     v = v0 + (g + f_n) t + f_a Re Z' + n x f_a Im Z',            Z' = [0, i w]
//
// with the divided differences of exponential.h, which are right for any w, none included.
// Domain: gravity and thrusts of constant mass, each body's spin steady, no joint or contact.
#include "reference/exact/domain.h"
#include "reference/exact/exponential.h"
#include "reference/exact/flight.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {
namespace {

constexpr auto name = "seed_airplane";

struct Airplane {
  Flight flight;
  WideVector across, over;  // f_a, n x f_a
  Wide rate;

  Airplane(const core::Scene& scene, std::size_t index)
      : flight(scene.bodies[index].initial, gravity(scene, index)), rate(flight.angular_velocity.norm()) {
    WideVector push = WideVector::Zero();
    for (const core::Force& force : scene.forces) {
      const auto* thrust = std::get_if<core::Thrust>(&force);
      if (thrust && thrust->body == static_cast<int>(index)) push += widen(thrust->force);
    }
    push = flight.orientation * push / Wide(scene.bodies[index].mass);
    const WideVector n = rate > 0 ? WideVector(flight.angular_velocity / rate) : WideVector(0, 0, 0);
    const WideVector along = rate > 0 ? WideVector(n.dot(push) * n) : push;
    flight.acceleration += along;
    across = push - along;
    over = n.cross(across);
  }

  WideState at(Wide t) const {
    WideState s = flight.at(t);
    const WideComplex turning(0, rate);
    const WideComplex place = exponential_difference(0, 0, turning, t);
    const WideComplex speed = exponential_difference(0, turning, t);
    s.position += across * place.real() + over * place.imag();
    s.velocity += across * speed.real() + over * speed.imag();
    return s;
  }
};

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Airplane> motions;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) motions.emplace_back(scene, i);
  return together(std::move(motions));
}

}  // namespace

core::Truth seed_airplane(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity", "thrust"});
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (const core::Force& force : scene.forces) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    if (thrust && thrust->mass_rate != 0) refuse(name, named(scene, thrust->body) + " changes its mass");
  }
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_steady_spin(name, scene, i, horizon);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Newton's law with a force that turns at a constant rate, integrated twice",
          .horizon = horizon};
}

}  // namespace cylon::exact
