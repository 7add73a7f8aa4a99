#include "harness/core/force_law.h"
#include "harness/core/solid.h"
#include "harness/study/relations.h"

#include <algorithm>
#include <cmath>

namespace cylon::study {

using core::Vector3;

Scales scales(const core::Scene& scene, double duration) {
  Vector3 centre = Vector3::Zero();
  for (const core::Body& b : scene.bodies)
    centre += b.initial.position / static_cast<double>(scene.bodies.size());
  double length = 0, first = 0, turning = 0;
  const double gravity = core::strongest_gravity(scene);
  const auto reach = [&](const Vector3& p) { length = std::max(length, (p - centre).norm()); };
  for (const core::Body& b : scene.bodies) {
    reach(b.initial.position);
    length = std::max(length, core::bounding_radius(b.shape));
    first = std::max(first, b.initial.velocity.norm());
    turning = std::max(turning, b.initial.angular_velocity.norm());
    if (b.collide)
      for (const core::Plane& p : scene.planes)
        length = std::max(length, std::abs(p.normal.dot(b.initial.position) - p.offset));
  }
  for (const core::Joint& j : scene.joints)
    if (!core::kind_of(j.type).joins_centres() || j.to == core::world) reach(j.point);
  for (const core::Force& f : scene.forces) {
    if (const auto* k = std::get_if<core::Spring>(&f)) {
      length = std::max(length, k->rest_length);
      if (k->to == core::world) reach(k->to_anchor);
    }
  }
  if (length == 0) length = std::max(first * duration, gravity * duration * duration / 2);
  if (length == 0) length = 1;

  // v^2 = 2 g L, and what each force adds.
  double squared = std::max({first * first, 2 * gravity * length, std::pow(turning * length, 2)});
  for (const core::Force& f : scene.forces)
    squared = std::max(squared, core::squared_speed(f, scene, length));
  const double speed = squared > 0 ? std::sqrt(squared) : length / duration;
  const bool impacts = core::any_touching_pair(scene, [](const core::Pair&) { return true; });
  return {impacts, length, speed, std::max(turning, speed / length)};
}

double apart(const core::State& a, const core::State& b, const Scales& unit) {
  double worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    // |q - q'| with the sign that is nearer; NaN in a quaternion stays one.
    const double plus = (a[i].orientation.coeffs() - b[i].orientation.coeffs()).norm(),
                 minus = (a[i].orientation.coeffs() + b[i].orientation.coeffs()).norm();
    const double turn = 4 * std::asin(std::min(1.0, std::min(plus, minus) / 2));
    double place = (a[i].position - b[i].position).norm() / unit.length,
           velocity = (a[i].velocity - b[i].velocity).norm() / unit.speed,
           spin = (a[i].angular_velocity - b[i].angular_velocity).norm() / unit.angular_velocity;
    if (unit.impacts && std::isfinite(velocity) && std::isfinite(spin)) velocity = spin = 0;
    for (const double d : {place, velocity, spin, std::isnan(plus) ? plus : turn})
      if (!(d <= worst)) worst = d;
    if (std::isnan(worst)) return worst;
  }
  return worst;
}

}  // namespace cylon::study
