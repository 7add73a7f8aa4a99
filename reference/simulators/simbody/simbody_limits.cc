#include "reference/simulators/simbody/simbody_limits.h"

#include "reference/applied/forces.h"
#include "reference/applied/forest.h"
#include "reference/applied/masses.h"

#include <fmt/format.h>

namespace cylon::simulators {
namespace {

using core::Scene;
using Reason = std::optional<std::string>;

const std::string& name_of(const Scene& scene, int body) {
  return scene.bodies[static_cast<std::size_t>(body)].name;
}

// A contact of Simbody is a force of penetration, by Hertz or an elastic foundation: it needs a stiffness, which no
// scene states and Simbody has no value for (simbody/internal/ContactSurface.h:91).
Reason against_contacts(const Scene& scene) {
  Reason reason;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                               : name_of(scene, pair.other);
    reason = fmt::format(
        "'{}' and '{}' may touch, and a contact of Simbody is compliant: it needs a stiffness and a "
        "dissipation, "
        "which the scene does not state and for which Simbody has no value "
        "(simbody/internal/ContactSurface.h:91).",
        name_of(scene, pair.body), other);
    return true;
  });
  return reason;
}

bool closes(core::JointType type) {
  return type == core::JointType::ball || type == core::JointType::gimbal || type == core::JointType::hinge ||
         type == core::JointType::fixed || type == core::JointType::distance;
}

Reason against_joints(const Scene& scene) {
  for (const core::Joint& joint : scene.joints)
    if (core::kind_of(joint.type).has_length() && !(joint.length > 0))
      return fmt::format(
          "Simbody's rod has a length above zero (simbody/internal/Constraint_Rod.h:46); that of '{}' is {} "
          "m.",
          name_of(scene, joint.body), joint.length);
  for (const std::size_t j : applied::forest_of(scene).loops)
    if (const core::Joint& joint = scene.joints[j]; !closes(joint.type))
      return fmt::format(
          "The {} of '{}' closes a loop, which this adapter does with balls, hinges, welds and rods alone.",
          core::kind_of(joint.type).name, name_of(scene, joint.body));
  return {};
}

}  // namespace

Reason simbody_limit(const Scene& scene) {
  if (Reason reason = applied::without_mass("Simbody", scene)) return reason;
  // SimTKcommon/internal/MassProperties.h:542
  if (Reason reason = applied::without_triangle("Simbody", scene)) return reason;
  if (Reason reason = applied::unmapped(scene)) return reason;
  if (Reason reason = against_joints(scene)) return reason;
  return against_contacts(scene);
}

}  // namespace cylon::simulators
