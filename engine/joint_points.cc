#include "engine/joint_points.h"

namespace cylon::engine {
namespace {

Vector3 mean_of_centres(const Joint& joint, const Model& model) {
  const auto weight = [&](int body) {
    return body == fixed_world || model.bodies[index(body)].locked ? Real(0)
                                                                   : model.bodies[index(body)].inverse_mass;
  };
  const Vector3& centre = model.motions[index(joint.body)].position;
  if (joint.to == fixed_world) return centre;
  const Vector3& other = model.motions[index(joint.to)].position;
  const Real a = weight(joint.body), b = weight(joint.to);
  return a + b > 0 ? Vector3((a * centre + b * other) / (a + b)) : Vector3((centre + other) / 2);
}

}  // namespace

Joint at_centres(Joint joint, const Model& model) {
  const bool turns = joint.type.turn == Joint::Turn::about_axis;
  if (!turns && joint.type.turn != Joint::Turn::never) return joint;
  if (joint.type.place == Joint::Place::at_length || joint.type.place == Joint::Place::along_normal)
    return joint;
  const Motion& body = model.motions[index(joint.body)];
  const Quaternion to = joint.to == fixed_world ? Quaternion(Quaternion::Identity())
                                                : model.motions[index(joint.to)].orientation;
  const Vector3 from = body.position + body.orientation * joint.anchor, h = to * joint.to_axis;
  const Vector3 mean = mean_of_centres(joint, model) - from, own = body.position - from;
  const Real along = h.dot(joint.type.place == Joint::Place::along_axis ? own : mean);
  if (turns) {
    joint.anchor += along * joint.axis, joint.to_anchor += along * joint.to_axis;
    return joint;
  }
  const Vector3& across = joint.type.place == Joint::Place::in_plane ? own : mean;
  const Vector3 way = to.conjugate() * Vector3(across + (along - h.dot(across)) * h);  // in the axes of `to`
  joint.anchor += joint.relative.conjugate() * way, joint.to_anchor += way;
  return joint;
}

}  // namespace cylon::engine
