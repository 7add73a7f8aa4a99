// Bodies, joints and shapes as DART has them.
#include "reference/simulators/dart/border/dart_parts.h"

#include <dart/collision/CollisionFilter.hpp>
#include <dart/collision/CollisionGroup.hpp>
#include <dart/collision/dart/DARTCollisionDetector.hpp>
#include <dart/constraint/BallJointConstraint.hpp>
#include <dart/constraint/ConstraintSolver.hpp>
#include <dart/constraint/WeldJointConstraint.hpp>
#include <dart/dynamics/BallJoint.hpp>
#include <dart/dynamics/BoxShape.hpp>
#include <dart/dynamics/EulerJoint.hpp>
#include <dart/dynamics/FreeJoint.hpp>
#include <dart/dynamics/PlanarJoint.hpp>
#include <dart/dynamics/PrismaticJoint.hpp>
#include <dart/dynamics/RevoluteJoint.hpp>
#include <dart/dynamics/ScrewJoint.hpp>
#include <dart/dynamics/Skeleton.hpp>
#include <dart/dynamics/SphereShape.hpp>
#include <dart/dynamics/UniversalJoint.hpp>
#include <dart/dynamics/WeldJoint.hpp>
#include <dart/math/Constants.hpp>

#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace cylon::simulators::dart_border {
namespace {

namespace dynamics = dart::dynamics;
using dynamics::BodyNode;
using Eigen::Isometry3d;
using Eigen::Vector3d;

// Asks the caller which shapes meet, in place of DART's rule for neighbours in a skeleton.
class Filter : public dart::collision::CollisionFilter {
 public:
  Filter(World::Meets meets, const std::unordered_map<const dynamics::ShapeFrame*, int>& shapes)
      : meets_(std::move(meets)), shapes_(shapes) {}

  bool ignoresCollision(const dart::collision::CollisionObject* a,
                        const dart::collision::CollisionObject* b) const override {
    return !meets_(shapes_.at(a->getShapeFrame()), shapes_.at(b->getShapeFrame()));
  }

 private:
  World::Meets meets_;
  const std::unordered_map<const dynamics::ShapeFrame*, int>& shapes_;
};

// A joint whose frame has the axes of the world where the scene starts, and the place of the joint.
template <class Joint>
typename Joint::Properties at_start(const Isometry3d& parent, const Isometry3d& body, const Vector& point) {
  Isometry3d place = Isometry3d::Identity();
  place.translation() = to_dart(point);
  typename Joint::Properties properties;
  properties.mT_ParentBodyToJoint = parent.inverse() * place;
  properties.mT_ChildBodyToJoint = body.inverse() * place;
  return properties;
}

template <class Joint>
std::pair<Joint*, BodyNode*> make(const dynamics::SkeletonPtr& skeleton, BodyNode* parent,
                                  const typename Joint::Properties& joint, const BodyNode::Properties& body) {
  typename Joint::Properties named = joint;
  named.mName = "joint of " + body.mName;
  return skeleton->createJointAndBodyNodePair<Joint>(parent, named, body);
}

// A coordinate of a joint, where it stands.
void hold(dynamics::Joint& joint, std::size_t coordinate, const Held& held) {
  const double start = joint.getPosition(coordinate);
  if (std::isfinite(held.lower) || std::isfinite(held.upper)) {
    joint.setPositionLowerLimit(coordinate, start + held.lower);
    joint.setPositionUpperLimit(coordinate, start + held.upper);
    joint.setLimitEnforcement(true);
  }
  joint.setCoulombFriction(coordinate, held.friction);
}

void hold(dynamics::Joint& joint, const Body& body) {
  for (std::size_t i = 0; i < joint.getNumDofs(); ++i) hold(joint, i, body.held[i]);
}

// With axes h of the parent and u of the body, theta apart, and n along  h x u,
//   R(h, first) R(n, third) R(u, second) = F Rx(first) Ry(third + b) Rz(-second) Ry(-b) F^T,  b = theta - pi/2,
// of which F has the columns h, n and h x n.
std::pair<dynamics::EulerJoint*, BodyNode*> make_gimbal(const dynamics::SkeletonPtr& skeleton,
                                                        BodyNode* parent, const Isometry3d& parent_pose,
                                                        const Isometry3d& pose, const Body& body,
                                                        const BodyNode::Properties& node) {
  const Vector3d h = to_dart(body.axis), u = to_dart(body.axis_2), n = h.cross(u).normalized();
  const double b = std::atan2(h.cross(u).norm(), h.dot(u)) - dart::math::constantsd::half_pi();
  Isometry3d frame = Isometry3d::Identity();
  frame.linear() << h, n, h.cross(n);
  auto gimbal = at_start<dynamics::EulerJoint>(parent_pose, pose, body.point);
  gimbal.mAxisOrder = dynamics::EulerJoint::AxisOrder::XYZ;
  gimbal.mT_ParentBodyToJoint = gimbal.mT_ParentBodyToJoint * frame;
  gimbal.mT_ChildBodyToJoint = gimbal.mT_ChildBodyToJoint * frame * Eigen::AngleAxisd(b, Vector3d::UnitY());
  const auto [joint, made] = make<dynamics::EulerJoint>(skeleton, parent, gimbal, node);
  joint->setPositions(Vector3d(0, b, 0));
  Eigen::Matrix3d axes;
  axes << h, n, -u;
  joint->setVelocities(axes.partialPivLu().solve(to_dart(body.turn_rate)));
  const Held &first = body.held[0], &second = body.held[1], &third = body.held[2];
  hold(*joint, 0, first);
  hold(*joint, 1, third);
  hold(*joint, 2, {-second.upper, -second.lower, second.friction});
  return {joint, made};
}

// DART gives each of equal names another one, with a message.
BodyNode::Properties properties(const Body& body, std::size_t index) {
  const auto& i = body.inertia;
  Eigen::Matrix3d moment;
  moment << i[0], i[1], i[2], i[3], i[4], i[5], i[6], i[7], i[8];
  BodyNode::AspectProperties one("body" + std::to_string(index));
  one.mInertia = dynamics::Inertia(body.mass, Vector3d::Zero(), moment);
  one.mGravityMode = body.falls;
  return BodyNode::Properties(one);
}

}  // namespace

void World::Parts::hang(const std::vector<Body>& bodies, std::size_t i) {
  if (nodes[i]) return;
  const Body& body = bodies[i];
  const Isometry3d pose = to_dart(body.start.orientation, body.start.position);
  BodyNode* parent = nullptr;
  Isometry3d parent_pose = Isometry3d::Identity();
  if (body.parent >= 0) {
    const std::size_t above = static_cast<std::size_t>(body.parent);
    hang(bodies, above);
    parent = nodes[above];
    parent_pose = to_dart(bodies[above].start.orientation, bodies[above].start.position);
  } else {
    skeletons.push_back(dynamics::Skeleton::create("skeleton" + std::to_string(skeletons.size())));
    skeletons.back()->setMobile(body.moves);
  }
  const dynamics::SkeletonPtr skeleton = parent ? parent->getSkeleton() : skeletons.back();
  switch (body.hang) {
    case Hang::freely: {
      const auto [joint, node] = make<dynamics::FreeJoint>(skeleton, parent, {}, properties(body, i));
      joint->setTransform(pose);
      // Its six speeds are those of the body in body axes, rotation first.
      Eigen::Vector6d speeds;
      speeds << pose.linear().transpose() * to_dart(body.start.spin),
          pose.linear().transpose() * to_dart(body.start.velocity);
      joint->setVelocities(speeds);
      nodes[i] = node;
      break;
    }
    case Hang::by_ball: {
      const auto [joint, node] = make<dynamics::BallJoint>(
          skeleton, parent, at_start<dynamics::BallJoint>(parent_pose, pose, body.point),
          properties(body, i));
      joint->setVelocities(to_dart(body.turn_rate));
      nodes[i] = node;
      break;
    }
    case Hang::by_gimbal:
      nodes[i] = make_gimbal(skeleton, parent, parent_pose, pose, body, properties(body, i)).second;
      break;
    case Hang::by_hinge: {
      auto hinge = at_start<dynamics::RevoluteJoint>(parent_pose, pose, body.point);
      hinge.mAxis = to_dart(body.axis);
      const auto [joint, node] = make<dynamics::RevoluteJoint>(skeleton, parent, hinge, properties(body, i));
      joint->setVelocity(0, to_dart(body.axis).dot(to_dart(body.turn_rate)));
      hold(*joint, body);
      nodes[i] = node;
      break;
    }
    case Hang::by_slider: {
      auto slider = at_start<dynamics::PrismaticJoint>(parent_pose, pose, body.point);
      slider.mAxis = to_dart(body.axis);
      const auto [joint, node] =
          make<dynamics::PrismaticJoint>(skeleton, parent, slider, properties(body, i));
      joint->setVelocity(0, to_dart(body.axis).dot(to_dart(body.slide_rate)));
      hold(*joint, body);
      nodes[i] = node;
      break;
    }
    case Hang::by_screw: {
      auto screw = at_start<dynamics::ScrewJoint>(parent_pose, pose, body.point);
      screw.mAxis = to_dart(body.axis);
      screw.mPitch = 2 * dart::math::constantsd::pi() * body.pitch;  // of a whole turn
      const auto [joint, node] = make<dynamics::ScrewJoint>(skeleton, parent, screw, properties(body, i));
      joint->setVelocity(0, to_dart(body.axis).dot(to_dart(body.turn_rate)));
      hold(*joint, body);
      nodes[i] = node;
      break;
    }
    case Hang::by_universal: {
      auto universal = at_start<dynamics::UniversalJoint>(parent_pose, pose, body.point);
      universal.mAxis = {to_dart(body.axis), to_dart(body.axis_2)};
      const auto [joint, node] =
          make<dynamics::UniversalJoint>(skeleton, parent, universal, properties(body, i));
      joint->setVelocity(0, to_dart(body.axis).dot(to_dart(body.turn_rate)));
      joint->setVelocity(1, to_dart(body.axis_2).dot(to_dart(body.turn_rate)));
      hold(*joint, body);
      nodes[i] = node;
      break;
    }
    case Hang::in_plane: {
      const Vector3d first = to_dart(body.axis_2), second = to_dart(body.axis).cross(first);
      auto planar = at_start<dynamics::PlanarJoint>(parent_pose, pose, body.point);
      planar.setArbitraryPlane(first, second);
      const auto [joint, node] = make<dynamics::PlanarJoint>(skeleton, parent, planar, properties(body, i));
      joint->setVelocities(Vector3d(first.dot(to_dart(body.slide_rate)), second.dot(to_dart(body.slide_rate)),
                                    to_dart(body.axis).dot(to_dart(body.turn_rate))));
      hold(*joint, body);
      nodes[i] = node;
      break;
    }
    case Hang::fixed:
      nodes[i] = make<dynamics::WeldJoint>(skeleton, parent,
                                           at_start<dynamics::WeldJoint>(parent_pose, pose, body.point),
                                           properties(body, i))
                     .second;
      break;
  }
}

void World::Parts::put_on(const Shape& shape) {
  dynamics::ShapePtr one;
  if (shape.sphere)
    one = std::make_shared<dynamics::SphereShape>(shape.size[0]);
  else
    one = std::make_shared<dynamics::BoxShape>(to_dart(shape.size));
  dynamics::ShapeNode* node =
      nodes[static_cast<std::size_t>(shape.body)]
          ->createShapeNodeWith<dynamics::CollisionAspect, dynamics::DynamicsAspect>(one);
  node->setRelativeTransform(to_dart(shape.orientation, shape.position));
  node->getDynamicsAspect()->setRestitutionCoeff(shape.restitution);
  node->getDynamicsAspect()->setFrictionCoeff(shape.friction);
  shapes.emplace(node, static_cast<int>(shapes.size()));
}

void World::Parts::close(const Loop& loop) {
  using namespace dart::constraint;
  BodyNode* first = nodes[static_cast<std::size_t>(loop.body)];
  BodyNode* second = loop.to < 0 ? nullptr : nodes[static_cast<std::size_t>(loop.to)];
  std::shared_ptr<DynamicJointConstraint> made;
  if (loop.turns)
    made = second ? std::make_shared<BallJointConstraint>(first, second, to_dart(loop.point))
                  : std::make_shared<BallJointConstraint>(first, to_dart(loop.point));
  else
    made = second ? std::make_shared<WeldJointConstraint>(first, second)
                  : std::make_shared<WeldJointConstraint>(first);
  world->getConstraintSolver()->addConstraint(made);
}

void World::Parts::enter(Meets meets) {
  dart::constraint::ConstraintSolver* solver = world->getConstraintSolver();
  solver->setCollisionDetector(dart::collision::DARTCollisionDetector::create());
  solver->getCollisionOption().maxNumContacts = std::numeric_limits<std::size_t>::max();
  solver->getCollisionOption().collisionFilter = std::make_shared<Filter>(std::move(meets), shapes);
  for (const dynamics::SkeletonPtr& skeleton : skeletons) world->addSkeleton(skeleton);
}

}  // namespace cylon::simulators::dart_border
