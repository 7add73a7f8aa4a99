#include "reference/simulators/siconos/siconos_limits.h"

#include "harness/core/surfaces.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/applied/materials.h"

#include <fmt/format.h>

#include <variant>

namespace cylon::simulators {
namespace {

using core::Scene;
using Reason = std::optional<std::string>;

const core::Body& body(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }

// What holds nothing is no joint.
Reason against_joints(const Scene& scene) {
  const auto moves = [&](int i) { return i != core::world && !body(scene, i).locked; };
  for (const core::Joint& joint : scene.joints)
    if (moves(joint.body) || moves(joint.to))
      return fmt::format(
          "Siconos has joints in its library of mechanics alone, which this adapter leaves out; '{}' has one "
          "of "
          "type {}.",
          body(scene, joint.body).name, core::kind_of(joint.type).name);
  return {};
}

// Its library of mechanics collides other shapes, by Bullet with its margins: a box rests 6 mm low.
Reason against_shape(const core::Body& body) {
  if (std::holds_alternative<core::Sphere>(body.shape)) return {};
  return fmt::format(
      "Body '{}': the kernel of Siconos has no shapes; this adapter gives it the distances of spheres and "
      "planes "
      "alone.",
      body.name);
}

Reason against_contacts(const Scene& scene) {
  if (Reason reason = applied::without_material(scene)) return reason;
  Reason reason;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    reason = against_shape(body(scene, pair.body));
    if (!reason && pair.plane < 0) reason = against_shape(body(scene, pair.other));
    return reason.has_value();
  });
  return reason;
}

}  // namespace

Reason siconos_limit(const Scene& scene) {
  if (Reason reason = applied::without_mass("Siconos", scene)) return reason;
  if (Reason reason = applied::unmapped(scene)) return reason;
  if (Reason reason = against_joints(scene)) return reason;
  return against_contacts(scene);
}

}  // namespace cylon::simulators
