// Bodies and the joints between them as btMultiBody: reduced coordinates.
#pragma once

#include "harness/core/scene.h"
#include "reference/simulators/bullet/bullet_bodies.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class btMultiBodyConstraint;
class btMultiBodyDynamicsWorld;

namespace cylon::simulators {

/// The place of a body in the tree that its joints make.
struct TreePlace {
  int joint = -1;   ///< Through which it hangs on its parent, of the scene's joints; -1: a free base.
  int parent = -1;  ///< A body; the world where there is none.
};

/// The bodies that joints connect with `first`, parents before children.  The root hangs from the world by
/// the first joint that does, else it is free and the first body by index.
struct Tree {
  std::vector<int> bodies;
  std::vector<TreePlace> places;  ///< In the same order.
  std::vector<int> loops;         ///< Joints that close a loop.
};
Tree tree_of(const core::Scene&, int first);

/// Whether each moving body hangs from the world by joints without loops, or is alone and without gyroscopic
/// torque: what btMultiBody's Runge-Kutta 4 integrates to its order.  Of a free base it takes the
/// orientation of the step's beginning in all four stages.
bool all_hung(const core::Scene&);

/// Whether joints close a loop.
bool has_loops(const core::Scene&);

/// Why the joints of a scene cannot be expressed by btMultiBody, or nothing.
std::optional<std::string> untreelike(const core::Scene&);

/// Adds one btMultiBody to the world: the bodies of the tree, of which body i goes into bodies[i].
/// `placings` in the order of the scene's bodies.  The joints that close loops become constraints, added to
/// `loops`.
void make_multibody(const core::Scene&, const Tree&, const std::vector<Placing>& placings,
                    const BulletSettings&, btMultiBodyDynamicsWorld&,
                    std::vector<std::unique_ptr<BulletBody>>& bodies,
                    std::vector<std::unique_ptr<btMultiBodyConstraint>>& loops);

}  // namespace cylon::simulators
