// One moving thing of a Bullet world behind one interface: a btRigidBody or a link of a btMultiBody.
#pragma once

#include "harness/core/collision_filter.h"
#include "harness/core/scene.h"
#include "reference/simulators/bullet/bullet_settings.h"
#include "reference/simulators/bullet/bullet_surfaces.h"

#include <memory>

class btCollisionObject;
class btCollisionShape;
class btDiscreteDynamicsWorld;
class btRigidBody;

namespace cylon::simulators {

class BulletBody {
 public:
  virtual ~BulletBody() = default;

  /// Centre of mass and velocities as Bullet holds them after the step, not as it interpolates them.
  virtual core::BodyState state() const = 0;

  /// For the next step: force through the centre of mass [N] and torque about it [N m], world axes.
  virtual void push(const core::Vector3& force, const core::Vector3& torque) = 0;

  /// From the next step on [kg]; the inertia stays.
  virtual void set_mass(double mass) = 0;

  /// For the next step, after set_mass: what gravity of its own adds to the world's, where the object has none of
  /// its own [m/s^2].
  virtual void fall(const core::Vector3&) {}

  /// For joints; nothing for a multibody.
  virtual btRigidBody* rigid() { return nullptr; }
};

/// What a body needs besides its description.
struct Placing {
  btCollisionShape* shape = nullptr;  ///< In principal axes.
  core::PrincipalAxes principal;
  const Surfaces* surfaces = nullptr;
  int surface = 0;
  int owner = 0;  ///< The body's index; of plane p: -1 - p.
  core::CollisionFilter filter = {};
};

/// Adds a btRigidBody to the world, static when the body is locked.
std::unique_ptr<BulletBody> make_rigid(const core::Body&, const Placing&, const BulletSettings&,
                                       btDiscreteDynamicsWorld&);

/// Bullet's group and mask of what may touch something.
int collision_group(const Placing&);
int collision_mask(const Placing&);

/// Gives a collision object its surface, its contact threshold and a wakeful life.
void prepare(btCollisionObject&, const Placing&, const BulletSettings&);

}  // namespace cylon::simulators
