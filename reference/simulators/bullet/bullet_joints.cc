#include "reference/simulators/bullet/bullet_joints.h"

#include "reference/simulators/bullet/bullet_border.h"

#include <btBulletDynamicsCommon.h>

namespace cylon::simulators {
namespace {

// A joint at a point of the world, x along its axis, seen from a body.
btTransform frame_in(const btRigidBody& body, const core::Joint& joint) {
  const auto turn = core::turn_between(core::Vector3::UnitX(), joint.axis);
  return body.getWorldTransform().inverse() * to_bullet(turn, joint.point);
}

}  // namespace

std::optional<std::string> unsupported(const core::Joint& joint) {
  if (joint.type != core::JointType::distance) return std::nullopt;
  return "Bullet has no joint that keeps a distance "
         "(BulletDynamics/ConstraintSolver/btTypedConstraint.h:34).";
}

std::unique_ptr<btTypedConstraint> make_joint(const core::Joint& joint, btRigidBody& a, btRigidBody* b) {
  const btVector3 point = to_bullet(joint.point), axis = to_bullet(joint.axis);
  const auto local = [&](const btRigidBody& body) { return body.getWorldTransform().invXform(point); };
  const auto local_axis = [&](const btRigidBody& body) {
    return body.getWorldTransform().getBasis().transpose() * axis;
  };
  switch (joint.type) {
    case core::JointType::ball:
      if (b) return std::make_unique<btPoint2PointConstraint>(a, *b, local(a), local(*b));
      return std::make_unique<btPoint2PointConstraint>(a, local(a));
    case core::JointType::hinge:
      if (b)
        return std::make_unique<btHingeConstraint>(a, *b, local(a), local(*b), local_axis(a), local_axis(*b));
      return std::make_unique<btHingeConstraint>(a, local(a), local_axis(a));
    case core::JointType::fixed: {
      btRigidBody& other = b ? *b : btTypedConstraint::getFixedBody();
      return std::make_unique<btFixedConstraint>(a, other, frame_in(a, joint), frame_in(other, joint));
    }
    case core::JointType::distance:
    case core::JointType::slider:
    case core::JointType::cylindrical:
    case core::JointType::planar:
    case core::JointType::universal:
    case core::JointType::screw:
      break;
  }
  return nullptr;
}

}  // namespace cylon::simulators
