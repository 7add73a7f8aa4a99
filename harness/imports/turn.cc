#include "harness/imports/steps.h"

#include <utility>

namespace cylon::imports {
namespace {

using foreign::Matrix3;
using foreign::Pose;
using foreign::Quaternion;
using foreign::Solid;
using foreign::Vector3;

// P, the turn of -90 degrees about x.
void turn(Vector3& v) { v = {v.x(), v.z(), 0.0 - v.y()}; }  // no -0
// P q P^-1: the axis of q turns, its angle stays.
void turn(Quaternion& q) { q = Quaternion(q.w(), q.x(), q.z(), 0.0 - q.y()); }
void turn(Pose& pose) { turn(pose.position), turn(pose.turn); }
// P I P^T.
void turn(Matrix3& i) {
  Matrix3 m;
  m << i(0, 0), i(0, 2), 0.0 - i(0, 1),  //
      i(2, 0), i(2, 2), 0.0 - i(2, 1),   //
      0.0 - i(1, 0), 0.0 - i(1, 2), i(1, 1);
  i = m;
}

// From an axis along z to one along y, by the turn that takes y to z.
void stand_along_y(Solid& solid) {
  constexpr double half = 0.70710678118654752440;  // cos and sin of 45 degrees
  if (solid.kind == "capsule" || solid.kind == "cylinder" || solid.kind == "plane")
    solid.pose.turn = solid.pose.turn * Quaternion(half, half, 0, 0);
}

void turn(Solid& solid) {
  turn(solid.pose);
  for (Vector3& vertex : solid.vertices) turn(vertex);
  if (solid.kind == "box") std::swap(solid.size.y(), solid.size.z());
}

}  // namespace

void turn_up(foreign::Model& model, bool keep_axes) {
  if (keep_axes) {
    for (foreign::Body& body : model.bodies)
      for (Solid& solid : body.solids) stand_along_y(solid);
    return;
  }
  turn(model.gravity);
  for (foreign::Body& body : model.bodies) {
    turn(body.inertia), turn(body.pose), turn(body.velocity), turn(body.spin);
    if (body.gravity) turn(*body.gravity);
    for (Solid& solid : body.solids) turn(solid);
  }
  for (foreign::Joint& joint : model.joints) {
    turn(joint.point);
    for (foreign::Freedom& freedom : joint.freedoms) turn(freedom.axis);
  }
}

}  // namespace cylon::imports
