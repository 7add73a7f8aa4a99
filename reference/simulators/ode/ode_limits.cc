#include "reference/simulators/ode/ode_limits.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"
#include "reference/applied/forces.h"
#include "reference/applied/masses.h"
#include "reference/applied/materials.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <variant>

namespace cylon::simulators {
namespace {

using core::Overloaded;
using core::Scene;
using Reason = std::optional<std::string>;

const core::Body& body(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }

// Why a shape, of a body that is locked or not, cannot collide; nullptr where it can.  Classes of geoms: ode/collision.h:877.
const char* missing(const core::Shape& shape, bool locked) {
  using What = const char*;
  return std::visit(
      Overloaded{[](const core::Cone&) -> What { return "ODE has no cone (ode/collision.h:877)"; },
                 [](const core::Rod&) -> What {
                   return "ODE has no solid without thickness, such as a rod (ode/collision.h:877)";
                 },
                 [](const core::Disc&) -> What {
                   return "ODE has no solid without thickness, such as a disc (ode/collision.h:877)";
                 },
                 [](const core::Hull&) -> What {
                   return "this adapter maps no hull, for which dCreateConvex would need the faces "
                          "(ode/collision.h:965)";
                 },
                 [&](const core::Mesh&) -> What {
                   if (locked) return nullptr;
                   return "ODE collides a mesh as a surface, not as a solid (ode/collision_trimesh.h:253)";
                 },
                 [&](const core::Compound& compound) -> What {
                   for (const core::Part& part : compound.parts)
                     if (What what =
                             std::visit([&](const auto& s) { return missing(s, locked); }, part.shape))
                       return what;
                   return nullptr;
                 },
                 [](const auto&) -> What { return nullptr; }},
      shape);
}

Reason against(const Scene& scene, const core::Pair& pair) {
  for (const int i : {pair.body, pair.other}) {
    if (i == core::world) continue;
    if (const char* what = missing(body(scene, i).shape, body(scene, i).locked))
      return fmt::format("Body '{}': {}.", body(scene, i).name, what);
  }
  if (core::material_of(scene, pair)) return {};
  return applied::no_material(scene, pair);
}

Reason against(const Scene& scene, const core::Joint& joint) {
  Reason reason;
  core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
    if (joint.type == core::JointType::gimbal && (core::has_limit(c) || c.friction != 0))
      reason = fmt::format(
          "ODE's ball has no limits and no friction (ode/src/joints/ball.cpp), and its motor of Euler angles "
          "leaves the axes as long as the sine of the angle between them "
          "(ode/src/joints/amotor.cpp, dxJointAMotor::getInfo2); the gimbal joint of '{}' has some.",
          body(scene, joint.body).name);
  });
  for (const core::JointAngle& c : joint.angles)
    for (const auto& stop : {c.lower, c.upper})
      if (stop && !(std::abs(*stop - c.start) < std::numbers::pi))
        reason = fmt::format(
            "ODE's stops of an angle lie within half a turn (ode/src/joints/joint.cpp, "
            "dxJointLimitMotor::set); the joint of '{}' has one at {} rad from its start.",
            body(scene, joint.body).name, *stop - c.start);
  return reason;
}

}  // namespace

Reason ode_limit(const Scene& scene) {
  for (const core::Joint& joint : scene.joints)
    if (Reason reason = against(scene, joint)) return reason;
  // ODE aborts the process on a mass or an inertia that is not positive.
  if (Reason reason = applied::without_mass("ODE", scene)) return reason;
  if (Reason reason = applied::unmapped(scene)) return reason;
  for (const core::Pair& pair : core::touching_pairs(scene))
    if (Reason reason = against(scene, pair)) return reason;
  return {};
}

}  // namespace cylon::simulators
