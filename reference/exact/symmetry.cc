#include "reference/exact/symmetry.h"

#include "reference/exact/domain.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::exact {

Symmetry symmetry(const core::Matrix3& inertia, const core::Vector3& hint) {
  const core::PrincipalAxes principal = core::principal_axes(inertia);
  const WideQuaternion rotation = widen(principal.rotation);
  Symmetry best = {
      .axis = {}, .transverse = 0, .axial = 0, .difference = std::numeric_limits<Wide>::infinity()};
  Wide best_alignment = 0;
  for (int i = 0; i < 3; ++i) {
    const Wide a = principal.moments[(i + 1) % 3], b = principal.moments[(i + 2) % 3];
    const WideVector axis = rotation * WideVector::Unit(i);
    const Symmetry candidate = {.axis = axis,
                                .transverse = (a + b) / 2,
                                .axial = principal.moments[i],
                                .difference = a == b ? 0 : std::abs(a - b) / std::max(a, b)};
    const Wide alignment = std::abs(axis.dot(widen(hint)));
    const bool both_equal =
        candidate.difference < 1e-7L && best.difference < 1e-7L;  // a sphere: every axis serves
    if (both_equal ? alignment > best_alignment : candidate.difference < best.difference) {
      best = candidate;
      best_alignment = alignment;
    }
  }
  return best;
}

void add_difference(const core::Scene& scene, double horizon, core::StateError& error) {
  for (const core::Body& body : scene.bodies) {
    const Symmetry s = symmetry(body.inertia);
    if (s.difference == 0) continue;
    const WideVector w = widen(body.initial.orientation).conjugate() * widen(body.initial.angular_velocity);
    const Wide rate = w.norm(), against = std::abs(w.dot(s.axis) * (1 - s.axial / s.transverse));
    const Wide time = std::min<Wide>(horizon, against > 0 ? 1 / against : horizon);
    const Wide growth = s.difference * (1 + rate * time);
    error.orientation += static_cast<double>(growth * rate * horizon);
    error.angular_velocity += static_cast<double>(growth * rate);
  }
}

void check_symmetric(std::string_view solution, const core::Scene& scene, int index) {
  const Symmetry s = symmetry(scene.bodies.at(static_cast<std::size_t>(index)).inertia);
  if (!(s.transverse > 0) || !(s.axial >= 0))
    refuse(solution, named(scene, index) + " has a moment of inertia that is not positive");
  if (s.difference > 1e-12L) refuse(solution, named(scene, index) + " has no two equal principal moments");
}

}  // namespace cylon::exact
