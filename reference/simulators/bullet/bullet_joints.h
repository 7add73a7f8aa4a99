// Joints of rigid bodies as Bullet's constraints.
#pragma once

#include "harness/core/scene.h"

#include <memory>
#include <optional>
#include <string>

class btRigidBody;
class btTypedConstraint;

namespace cylon::simulators {

/// Why Bullet cannot hold a joint, or nothing.
std::optional<std::string> unsupported(const core::Joint&);

/// Between a and b; the world where b is null.
std::unique_ptr<btTypedConstraint> make_joint(const core::Joint&, btRigidBody& a, btRigidBody* b);

}  // namespace cylon::simulators
