#include "reference/simulators/ode/ode_limits.h"

#include "harness/core/overloaded.h"

#include <fmt/format.h>

#include <variant>

namespace cylon::simulators {
namespace {

using core::Overloaded;
using core::Scene;
using Reason = std::optional<std::string>;

const core::Body& body(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }

// What a shape is that ODE has no primitive for; nullptr where it has one.
const char* missing(const core::Shape& shape) {
  return std::visit(
      Overloaded{[](const core::Cone&) { return "a cone"; },
                 [](const core::Rod&) { return "a rod, which has no thickness"; },
                 [](const core::Disc&) { return "a disc, which has no thickness"; },
                 [](const core::Hull&) { return "a hull that is given without faces"; },
                 [](const core::Mesh&) { return "a mesh as a solid (only as a surface)"; },
                 [](const core::Compound& compound) -> const char* {
                   for (const core::Part& part : compound.parts)
                     if (const char* what = std::visit([](const auto& s) { return missing(s); }, part.shape))
                       return what;
                   return nullptr;
                 },
                 [](const std::monostate&) -> const char* { return nullptr; },
                 [](const core::Sphere&) -> const char* { return nullptr; },
                 [](const core::Box&) -> const char* { return nullptr; },
                 [](const core::Capsule&) -> const char* { return nullptr; },
                 [](const core::Cylinder&) -> const char* { return nullptr; }},
      shape);
}

// ODE aborts the process on a mass or an inertia that is not positive.
Reason against(const core::Body& body) {
  if (body.locked) return {};
  if (!(body.mass > 0))
    return fmt::format("ODE needs a mass above zero; '{}' has {} kg.", body.name, body.mass);
  const double least = core::principal_axes(body.inertia).moments.minCoeff();
  if (!(least > 0))
    return fmt::format("ODE needs principal moments above zero; '{}' has one of {} kg m^2.", body.name,
                       least);
  return {};
}

Reason against(const Scene& scene, const core::Force& force) {
  if (const auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->mass_rate != 0)
    return fmt::format("ODE does not support a body of changing mass, such as '{}'.",
                       body(scene, thrust->body).name);
  if (std::holds_alternative<core::Water>(force)) return "ODE has no water.";
  return {};
}

Reason against(const Scene& scene, const core::Pair& pair) {
  for (const int i : {pair.body, pair.other}) {
    if (i == core::world) continue;
    if (const char* what = missing(body(scene, i).shape))
      return fmt::format("ODE cannot collide {}; body '{}' is one.", what, body(scene, i).name);
  }
  if (core::material_of(scene, pair)) return {};
  const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                             : body(scene, pair.other).name;
  return fmt::format("'{}' may touch '{}', but the scene has no material for them.",
                     body(scene, pair.body).name, other);
}

}  // namespace

Reason ode_limit(const Scene& scene) {
  if (scene.frame) return "ODE's world is an inertial frame; the scene is given in a moving one.";
  for (const core::Body& one : scene.bodies)
    if (Reason reason = against(one)) return reason;
  for (const core::Force& force : scene.forces)
    if (Reason reason = against(scene, force)) return reason;
  for (const core::Pair& pair : core::touching_pairs(scene))
    if (Reason reason = against(scene, pair)) return reason;
  return {};
}

}  // namespace cylon::simulators
