// Bodies in uniform gravity that keep their spin: p = p0 + v0 t + g t^2/2 and q = rot(w t) q0.
// Domain: gravity alone, no contact or joint, each body without spin or turning about a principal axis.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/rounding.h"
#include "reference/exact/solutions.h"

namespace cylon::exact {
namespace {

std::function<core::State(double)> solve(const core::Scene& scene) {
  std::vector<Flight> flights;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    flights.emplace_back(scene.bodies[i].initial, gravity(scene, i));
  return together(std::move(flights));
}

}  // namespace

core::Truth projectile(const core::Scene& scene, double horizon) {
  constexpr auto name = "projectile";
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_no_joints(name, scene);
  check_no_contacts(name, scene);
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i) check_steady_spin(name, scene, i, horizon);
  return {.state = solve(scene),
          .error = rounding_error(scene, solve, horizon),
          .source = "Galilei's parabola, p = p0 + v0 t + g t^2/2; a free principal axis keeps its direction",
          .horizon = horizon};
}

}  // namespace cylon::exact
