// Joints of rigid bodies as Bullet's constraints.
#pragma once

#include "harness/core/scene.h"

#include <memory>
#include <optional>
#include <string>

class btRigidBody;
class btTypedConstraint;

namespace cylon::simulators {

/// Why Bullet has no joint of this kind, of rigid bodies or of links; or nothing.
std::optional<std::string> missing(const core::Joint&);

/// Why Bullet's constraints between rigid bodies cannot hold a joint that is not missing(), or nothing.
std::optional<std::string> unsupported(const core::Scene&, const core::Joint&);

/// Between the joint's body and `to`, of which one moves; `to` is null where it is the world.  Dry friction is given by
/// its impulse in a step of dt [s]; BulletSettings::whole_stops.  Requires that unsupported() says nothing.
std::unique_ptr<btTypedConstraint> make_joint(const core::Joint&, btRigidBody& body, btRigidBody* to,
                                              double dt, bool whole_stops);

}  // namespace cylon::simulators
