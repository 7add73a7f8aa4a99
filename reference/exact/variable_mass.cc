#include "reference/exact/variable_mass.h"

#include "reference/exact/domain.h"

namespace cylon::exact {

core::Thrust thrust_of(const core::Scene& scene, std::size_t index) {
  for (const core::Force& force : scene.forces) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    if (thrust && thrust->body == static_cast<int>(index)) return *thrust;
  }
  return {};
}

void check_variable_mass(std::string_view solution, const core::Scene& scene, double horizon) {
  check_bodies(solution, scene, horizon);
  check_forces(solution, scene, {"gravity", "thrust"});
  check_no_joints(solution, scene);
  check_no_contacts(solution, scene);
  std::vector<bool> pushed(scene.bodies.size(), false);
  for (const core::Force& force : scene.forces) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    if (!thrust) continue;
    const auto index = static_cast<std::size_t>(thrust->body);
    const std::string of = named(scene, thrust->body);
    if (pushed[index]) refuse(solution, of + " has two thrusts");
    pushed[index] = true;
    if (!(scene.bodies[index].mass + thrust->mass_rate * horizon > 0)) {
      refuse(solution, of + " has no mass left before the horizon");
    }
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].initial.angular_velocity.isZero(0.0)) {
      refuse(solution, named(scene, static_cast<int>(i)) + " turns, and its inertia changes");
    }
  }
}

}  // namespace cylon::exact
