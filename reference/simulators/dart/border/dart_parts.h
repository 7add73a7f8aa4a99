// The objects of DART in a world.  Included on this side of the border only.
#pragma once

#include "reference/simulators/dart/border/dart_world.h"

#include <dart/collision/CollisionObject.hpp>
#include <dart/constraint/PgsBoxedLcpSolver.hpp>
#include <dart/dynamics/BodyNode.hpp>
#include <dart/dynamics/ShapeNode.hpp>
#include <dart/simulation/World.hpp>

#include <unordered_map>

namespace cylon::simulators::dart_border {

inline Eigen::Vector3d to_dart(const Vector& v) { return {v[0], v[1], v[2]}; }
inline Vector from_dart(const Eigen::Vector3d& v) { return {v.x(), v.y(), v.z()}; }
inline Eigen::Isometry3d to_dart(const Turn& q, const Vector& position) {
  Eigen::Isometry3d pose = Eigen::Isometry3d::Identity();
  pose.linear() = Eigen::Quaterniond(q[0], q[1], q[2], q[3]).toRotationMatrix();
  pose.translation() = to_dart(position);
  return pose;
}

struct World::Parts {
  void set_solver(const Settings&);
  /// A body as a node of DART, its parent first; what hangs from the world begins a skeleton.
  void hang(const std::vector<Body>&, std::size_t body);
  void put_on(const Shape&);
  void close(const Loop&);
  /// Gives the skeletons to the world, and the shapes to the detector.
  void enter(Meets);

  int shape_of(const dart::collision::CollisionObject* object) const {
    return shapes.at(object->getShapeFrame());
  }

  dart::simulation::WorldPtr world = dart::simulation::World::create();
  std::vector<dart::dynamics::BodyNode*> nodes;  // by body; a skeleton owns them
  std::vector<dart::dynamics::SkeletonPtr> skeletons;
  std::unordered_map<const dart::dynamics::ShapeFrame*, int> shapes;
  std::shared_ptr<Unsolved> unsolved = std::make_shared<Unsolved>();
};

}  // namespace cylon::simulators::dart_border
