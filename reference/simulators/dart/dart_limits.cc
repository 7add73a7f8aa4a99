#include "reference/simulators/dart/dart_limits.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forces.h"
#include "reference/applied/forest.h"
#include "reference/applied/masses.h"
#include "reference/applied/materials.h"
#include "reference/applied/parts.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::simulators {
namespace {

using core::JointType;
using core::Scene;
using Reason = std::optional<std::string>;

// Both of dart/constraint/ContactConstraint.cpp:50 and :51; up to it a coefficient counts as zero.
constexpr double least_coefficient = 1e-3;
// Two spheres whose centres are nearer have no normal (collision/dart/DARTCollide.cpp:52 and :1342: 1e-6 m^2).
constexpr double nearest_centres = 1e-3;

const core::Body& body(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }

// ---- Joints -------------------------------------------------------------------------------------------

// What hangs a body from another, and what closes a loop; a kind that stands in neither is not known here.
bool hangs(JointType type) {
  return type != JointType::cylindrical && type != JointType::distance && type != JointType::rectangular &&
         type != JointType::offset_universal;
}
bool closes(JointType type) { return core::kind_of(type).turns_freely() || type == JointType::fixed; }

bool holds(const core::JointCoordinate& c) { return core::has_limit(c) || c.friction != 0; }

// Stops and dry friction.
Reason against_coordinates(const Scene& scene, const core::Joint& joint) {
  Reason reason;
  core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
    if (core::has_limit(c) && c.restitution > 0)
      reason = fmt::format(
          "The joint of '{}' bounces from its limits, and DART has no restitution there "
          "(constraint/JointConstraint.cpp).",
          body(scene, joint.body).name);
  });
  return reason;
}

// The displacements of a planar joint are of axes that `to` carries, DART's of those of the parent.
Reason against_hanging(const Scene& scene, const applied::Forest& forest, const core::Joint& joint,
                       std::size_t index) {
  const auto moves = [&](int i) { return i != core::world && !body(scene, i).locked; };
  if (joint.type != JointType::planar || !moves(joint.to) ||
      forest.nodes[static_cast<std::size_t>(joint.to)].joint != static_cast<int>(index))
    return {};
  for (const core::JointDisplacement& c : joint.displacements)
    if (holds(c))
      return fmt::format(
          "The planar joint of '{}' hangs '{}' from it, and the displacements that DART holds are of the "
          "parent's axes (dart/dynamics/PlanarJoint.cpp).",
          body(scene, joint.body).name, body(scene, joint.to).name);
  return {};
}

Reason against_joints(const Scene& scene) {
  const auto moves = [&](int i) { return i != core::world && !body(scene, i).locked; };
  const applied::Forest forest = applied::forest_of(scene);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const core::Joint& joint = scene.joints[j];
    if (!moves(joint.body) && !moves(joint.to)) continue;  // holds nothing
    const core::JointKind& kind = core::kind_of(joint.type);
    if (kind.has_length())
      return fmt::format(
          "DART has no constraint that keeps a distance, such as that of '{}' (dart/constraint/).",
          body(scene, joint.body).name);
    if (!hangs(joint.type))
      return fmt::format(
          "DART has no joint that turns about an axis and slides along it (dart/dynamics/), such as the {} "
          "one of '{}'.",
          kind.name, body(scene, joint.body).name);
    if (Reason reason = against_coordinates(scene, joint)) return reason;
    if (Reason reason = against_hanging(scene, forest, joint, j)) return reason;
  }
  for (const std::size_t j : forest.loops) {
    const core::Joint& joint = scene.joints[j];
    if (!closes(joint.type))
      return fmt::format(
          "The {} of '{}' closes a loop, for which DART has a ball and a weld alone (dart/constraint/).",
          core::kind_of(joint.type).name, body(scene, joint.body).name);
    if (std::ranges::any_of(joint.angles, holds))
      return fmt::format(
          "The {} of '{}' closes a loop, and DART's ball for that has no limits and no friction "
          "(constraint/BallJointConstraint.cpp).",
          core::kind_of(joint.type).name, body(scene, joint.body).name);
  }
  return {};
}

// ---- Contacts -----------------------------------------------------------------------------------------

bool collided(const core::Primitive& shape) {
  return std::holds_alternative<core::Sphere>(shape) || std::holds_alternative<core::Box>(shape);
}

Reason against_shapes(const core::Body& body) {
  for (const core::Part& part : applied::parts_of(body.shape))
    if (!collided(part.shape))
      return fmt::format(
          "Body '{}': DART's own detector collides spheres and boxes alone "
          "(collision/dart/DARTCollisionDetector.cpp:228).",
          body.name);
  return {};
}

double largest_radius(const core::Body& body) {
  double radius = 0;
  for (const core::Part& part : applied::parts_of(body.shape))
    if (const auto* sphere = std::get_if<core::Sphere>(&part.shape))
      radius = std::max(radius, sphere->radius);
  return radius;
}

Reason against(const Scene& scene, const core::Pair& pair, const core::Material& material) {
  const core::Body& one = body(scene, pair.body);
  const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                             : body(scene, pair.other).name;
  if (Reason reason = against_shapes(one)) return reason;
  const auto counts_as_zero = [](double x) { return x > 0 && x <= least_coefficient; };
  for (const auto& [what, value] :
       {std::pair{"restitution", material.restitution}, std::pair{"friction", material.friction}})
    if (counts_as_zero(value))
      return fmt::format(
          "DART takes a {} of at most {} for none (constraint/ContactConstraint.cpp:50); that of '{}' and "
          "'{}' is {}.",
          what, least_coefficient, one.name, other, value);
  if (pair.plane >= 0) return {};
  if (Reason reason = against_shapes(body(scene, pair.other))) return reason;
  const double radius = largest_radius(one), radius_of_other = largest_radius(body(scene, pair.other));
  if (radius > 0 && radius_of_other > 0 && radius + radius_of_other <= nearest_centres)
    return fmt::format(
        "DART has no contact of two spheres whose centres are within {} m "
        "(collision/dart/DARTCollide.cpp:1342), which is all of a contact of '{}' and '{}'.",
        nearest_centres, one.name, other);
  return {};
}

Reason against_contacts(const Scene& scene) {
  if (Reason reason = applied::without_material(scene)) return reason;
  const core::Surfaces surfaces = core::surfaces(scene);
  Reason reason;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    const int other = pair.plane >= 0 ? surfaces.of_plane[static_cast<std::size_t>(pair.plane)]
                                      : surfaces.of_body[static_cast<std::size_t>(pair.other)];
    const int row = surfaces.material(surfaces.of_body[static_cast<std::size_t>(pair.body)], other);
    reason = against(scene, pair, scene.materials[static_cast<std::size_t>(row)]);
    return reason.has_value();
  });
  return reason;
}

}  // namespace

Reason dart_limit(const Scene& scene) {
  if (Reason reason = applied::without_mass("DART", scene)) return reason;
  if (Reason reason = applied::unmapped(scene)) return reason;
  if (Reason reason = against_joints(scene)) return reason;
  return against_contacts(scene);
}

}  // namespace cylon::simulators
