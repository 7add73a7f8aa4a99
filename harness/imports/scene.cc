#include "harness/imports/steps.h"

namespace cylon::imports {

core::Scene scene_of(foreign::Model& model) {
  core::Scene scene;
  for (const foreign::Body& from : model.bodies) {
    if (is_ground(from)) break;  // only planes from here on
    core::Body& body = scene.bodies.emplace_back();
    body.name = from.name;
    body.locked = from.locked;
    body.initial = {from.pose.position, from.pose.turn.normalized(), from.velocity, from.spin};
    if (from.locked) {
      body.initial.velocity = body.initial.angular_velocity = core::Vector3::Zero();
      continue;
    }
    body.mass = from.mass;
    body.inertia = from.inertia;
    body.gravity = from.gravity;
    if (from.linear_drag != 0 || from.angular_drag != 0)
      scene.forces.push_back(core::Drag{.body = static_cast<int>(scene.bodies.size()) - 1,
                                        .linear = from.linear_drag,
                                        .angular = from.angular_drag});
  }
  if (!model.gravity.isZero(0)) scene.forces.push_back(core::UniformGravity{model.gravity});
  scene.joints = joints_of(model);
  add_contacts(model, scene);
  return scene;
}

}  // namespace cylon::imports
