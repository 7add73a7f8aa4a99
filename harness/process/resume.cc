#include "harness/process/resume.h"

#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <utility>

namespace cylon::process {

std::optional<std::string> not_resumable(const core::Scene& scene) {
  for (const core::Force& force : scene.forces) {
    if (const auto* drive = std::get_if<core::Drive>(&force); drive && drive->frequency != 0)
      return "a drive's force depends on the time, and a scene can only start at t = 0";
    if (const auto* water = std::get_if<core::Water>(&force); water && water->wave != 0 && water->speed != 0)
      return "the water's waves depend on the time, and a scene can only start at t = 0";
    if (std::holds_alternative<core::PluginForce>(force))
      return "a plug-in's force may depend on the time, and a scene can only start at t = 0";
  }
  if (core::any_coordinate(scene, core::target_moves))
    return "a target of a joint depends on the time, and a scene can only start at t = 0";
  return std::nullopt;
}

core::Scene resumed(const core::Scene& given, const std::vector<core::HeldJoint>& joints, core::State state,
                    double t) {
  core::Scene scene = given;
  for (const core::Force& force : scene.forces)
    if (const auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->mass_rate != 0)
      scene.bodies[static_cast<std::size_t>(thrust->body)].mass += thrust->mass_rate * t;
  for (std::size_t i = 0; i < state.size(); ++i) {
    if (scene.bodies[i].locked)
      state[i] = scene.bodies[i].initial;
    else
      state[i].orientation.normalize();
  }
  fit(scene, joints, state);
  for (std::size_t i = 0; i < state.size(); ++i) scene.bodies[i].initial = state[i];
  scene.joints.clear();
  for (const core::HeldJoint& joint : joints) scene.joints.push_back(core::joint_at(joint, state));
  return scene;
}

}  // namespace cylon::process
