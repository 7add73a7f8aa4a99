#include "reference/exact/steady_spin.h"

namespace cylon::exact {

SteadySpin::SteadySpin(const core::Scene& scene, std::size_t index)
    : orientation(widen(scene.bodies[index].initial.orientation)),
      angular_velocity(widen(scene.bodies[index].initial.angular_velocity)) {
  const WideVector w = orientation.conjugate() * angular_velocity;
  const Wide moment = w.dot(scene.bodies[index].inertia.cast<Wide>() * w) / w.squaredNorm();
  for (const core::Force& force : scene.forces) {
    const auto* drag = std::get_if<core::Drag>(&force);
    if (!drag || drag->body != static_cast<int>(index) || w.isZero(0)) continue;
    decay += drag->momentum;
    if (drag->angular > 0) decay += drag->angular / moment;
  }
}

}  // namespace cylon::exact
