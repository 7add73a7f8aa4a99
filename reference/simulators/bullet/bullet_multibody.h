// Bodies and the joints between them as btMultiBody: reduced coordinates.
#pragma once

#include "harness/core/scene.h"
#include "reference/simulators/bullet/bullet_bodies.h"
#include "reference/simulators/bullet/bullet_tree.h"

#include <memory>
#include <vector>

class btMultiBodyConstraint;
class btMultiBodyDynamicsWorld;

namespace cylon::simulators {

/// Adds one btMultiBody to the world: the bodies of the tree, of which body i goes into bodies[i].
/// `placings` in the order of the scene's bodies.  The joints that close loops, the stops and the dry friction of
/// a step of dt [s] become constraints, added to `constraints`.
void make_multibody(const core::Scene&, const Tree&, const std::vector<Placing>& placings,
                    const BulletSettings&, double dt, btMultiBodyDynamicsWorld&,
                    std::vector<std::unique_ptr<BulletBody>>& bodies,
                    std::vector<std::unique_ptr<btMultiBodyConstraint>>& constraints);

}  // namespace cylon::simulators
