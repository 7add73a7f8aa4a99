// Joints of rigid bodies as Bullet's constraints.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene.h"
#include "reference/simulators/bullet/bullet_settings.h"

#include <memory>
#include <optional>
#include <string>

class btRigidBody;
class btTypedConstraint;

namespace cylon::simulators {

/// Why Bullet has no joint of this kind, of rigid bodies or of links; or nothing.
std::optional<std::string> missing(const core::Joint&);

/// Why Bullet's constraints between rigid bodies cannot hold a joint that is not missing(), or nothing.
std::optional<std::string> unsupported(const core::Scene&, const core::Joint&, bool ahead);

/// Between the joint's body and `to`, of which one moves; `to` is null where it is the world.  Dry friction is given by
/// its impulse in a step of dt [s].  Requires that unsupported() says nothing.
std::unique_ptr<btTypedConstraint> make_joint(const core::Joint&, btRigidBody& body, btRigidBody* to,
                                              double dt, const BulletStops&);

/// The stops of that joint that are a constraint of their own, or null: those of sliders and cylindrical joints between
/// two bodies that move, and the friction of the angle of these.
std::unique_ptr<btTypedConstraint> make_stop(const core::Joint&, btRigidBody& body, btRigidBody* to,
                                             const BulletStops&);

/// What a constraint of joint j, whose body this is, did in the last step of dt [s].  Requires a btJointFeedback.
core::Reaction reaction(std::size_t j, const btTypedConstraint&, const btRigidBody& body, double dt);

}  // namespace cylon::simulators
