// Scenes that the equations of this folder do not cover.
#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"
#include "reference/certified/builder.h"

#include <fmt/format.h>

#include <cmath>

namespace cylon::certified {
namespace {

std::string name_of(const core::Scene& scene, int body) {
  return fmt::format("body '{}'", scene.bodies[static_cast<std::size_t>(body)].name);
}

void check_contacts(const core::Scene& scene) {
  core::Pair found;
  const bool touches = core::any_touching_pair(scene, [&](const core::Pair& pair) {
    found = pair;
    return true;
  });
  if (!touches) return;
  refuse(fmt::format("{} may touch, and a blow is not smooth (collide = false rules it out)",
                     names_of(scene, found)));
}

void check_thrust(const core::Scene& scene, const core::Thrust& thrust) {
  if (thrust.mass_rate != 0 && !thrust.exhaust_velocity && !thrust.exchanged_velocity)
    refuse(fmt::format("the mass of {} changes by {} kg/s, but at which velocity is not said",
                       name_of(scene, thrust.body), thrust.mass_rate));
}

// A reference to a body that files must state is not one to the world.
void check_bodies(const core::Force& any_force) {
  std::visit(
      []<class Kind>(const Kind& force) {
        core::for_each_field(force, []<class Value>(const auto& field, const Value& value) {
          if constexpr (std::is_same_v<Value, int>)
            if (field.about.required && value == core::world)
              refuse(fmt::format("{} needs a body as its '{}'", core::Element<Kind>::name, field.key));
        });
      },
      any_force);
}

// What acts along a joint and is no smooth law.
void check_joints(const core::Scene& scene) {
  for (const core::Joint& joint : scene.joints) {
    const auto refuse_joint = [&](const char* what) {
      refuse(fmt::format("the {} joint of {} has {}", core::kind_of(joint.type).name,
                         name_of(scene, joint.body), what));
    };
    if (core::kind_of(joint.type).has_second_axis() && !joint.axis_2) refuse_joint("no second axis");
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
      if (core::has_limit(c)) refuse_joint("limits, and a blow is not smooth");
      if (c.friction != 0) refuse_joint("dry friction, which is not smooth");
      if (c.quadratic_damping != 0)
        refuse_joint("quadratic damping, which is not smooth where the rate is 0");
      if (!c.target_times.empty()) refuse_joint("a target between the times of a table, which has kinks");
    });
  }
}

void check_masses(const core::Scene& scene, double horizon) {
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    double rate = 0;
    for (const core::Force& force : scene.forces)
      if (const auto* thrust = std::get_if<core::Thrust>(&force);
          thrust && static_cast<std::size_t>(thrust->body) == i)
        rate += thrust->mass_rate;
    if (!(scene.bodies[i].mass + rate * horizon > 0))
      refuse(fmt::format("{} has lost all its mass after {} s", name_of(scene, static_cast<int>(i)),
                         -scene.bodies[i].mass / rate));
  }
}

}  // namespace

std::string names_of(const core::Scene& scene, const core::Pair& pair) {
  const std::string other = pair.plane >= 0
                                ? "plane '" + scene.planes[static_cast<std::size_t>(pair.plane)].name + "'"
                                : name_of(scene, pair.other);
  return fmt::format("{} and {}", name_of(scene, pair.body), other);
}

void refuse(const std::string& condition) { throw core::OutOfDomain("certified: " + condition); }

void check_domain(const core::Scene& scene, double horizon, Blows blows) {
  if (!(horizon > 0) || !std::isfinite(horizon)) refuse("the horizon must be positive and finite");
  if (scene.bodies.empty()) refuse("there is no body");
  if (blows == Blows::refused) check_contacts(scene);
  check_masses(scene, horizon);
  check_joints(scene);
  const bool turning = scene.frame && scene.frame->turns();
  for (const core::Force& force : scene.forces) {
    if (std::holds_alternative<core::Water>(force)) refuse("water has a surface, which is no smooth law");
    if (std::holds_alternative<core::PluginForce>(force))
      refuse("the law of a plug-in is code, and no formula");
    if (const auto* thrust = std::get_if<core::Thrust>(&force)) check_thrust(scene, *thrust);
    if (const auto* drag = std::get_if<core::Drag>(&force); drag && drag->momentum != 0 && turning)
      refuse("a drag on the angular momentum is not defined in a turning frame");
    check_bodies(force);
  }
}

}  // namespace cylon::certified
