#include "reference/simulators/bullet/bullet_bodies.h"

#include "reference/simulators/bullet/bullet_border.h"
#include "reference/simulators/bullet/bullet_knobs.h"
#include "reference/simulators/bullet/bullet_shapes.h"

#include <btBulletDynamicsCommon.h>

namespace cylon::simulators {
namespace {

class Rigid final : public BulletBody {
 public:
  Rigid(const core::Body& body, const Placing& placing, const BulletSettings& settings,
        btDiscreteDynamicsWorld& world)
      : principal_(placing.principal.rotation),
        moments_(to_bullet(placing.principal.moments)),
        body_(info(body, placing)) {
    prepare(body_, placing, settings);
    body_.setFlags(gyroscopic_flag(settings.gyroscopic));
    if (body.gravity) {  // the world's is for those without
      body_.setFlags(body_.getFlags() | BT_DISABLE_WORLD_GRAVITY);
      body_.setGravity(to_bullet(*body.gravity));
    }
    // The motion threshold is below the radius at which a sphere could skip what it touches.
    const double sphere = swept_radius(body.shape, placing.principal.rotation);
    if (settings.on("ccd") && !body.locked && sphere > 0) {
      body_.setCcdSweptSphereRadius(to_bullet(settings.number.at("ccd") * sphere));
      body_.setCcdMotionThreshold(to_bullet(sphere / 2));
    }
    if (!body.locked) {
      body_.setLinearVelocity(to_bullet(body.initial.velocity));
      body_.setAngularVelocity(to_bullet(body.initial.angular_velocity));
    }
    if (body.collide)
      world.addRigidBody(&body_, collision_group(placing), collision_mask(placing));
    else
      world.addRigidBody(&body_, 0, 0);
  }

  core::BodyState state() const override {
    const btTransform& pose = body_.getWorldTransform();
    return {from_bullet(pose.getOrigin()), orientation_from_bullet(pose.getRotation(), principal_),
            from_bullet(body_.getLinearVelocity()), from_bullet(body_.getAngularVelocity())};
  }

  void push(const core::Vector3& force, const core::Vector3& torque) override {
    body_.applyCentralForce(to_bullet(force));
    body_.applyTorque(to_bullet(torque));
  }

  // Gravity acts on the new mass as well.
  void set_mass(double mass) override { body_.setMassProps(to_bullet(mass), moments_); }

  btRigidBody* rigid() override { return &body_; }

 private:
  static btRigidBody::btRigidBodyConstructionInfo info(const core::Body& body, const Placing& placing) {
    const btVector3 moments = body.locked ? btVector3(0, 0, 0) : to_bullet(placing.principal.moments);
    btRigidBody::btRigidBodyConstructionInfo result(to_bullet(body.locked ? 0.0 : body.mass), nullptr,
                                                    placing.shape, moments);
    result.m_startWorldTransform = pose_to_bullet(body, placing.principal);
    return result;
  }

  static int gyroscopic_flag(const std::string& gyroscopic) {
    if (gyroscopic == "none") return 0;
    if (gyroscopic == "explicit") return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
    if (gyroscopic == "implicit-world") return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
    return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
  }

  core::Quaternion principal_;
  btVector3 moments_;
  btRigidBody body_;
};

}  // namespace

void prepare(btCollisionObject& object, const Placing& placing, const BulletSettings& settings) {
  // Read by the combination callbacks.
  object.setUserPointer(const_cast<Surfaces*>(placing.surfaces));  // NOLINT(*-const-cast): only read
  object.setUserIndex(placing.surface);
  object.setUserIndex2(placing.owner);  // whom contacts belong to
  if (!settings.on("sleeping")) object.setActivationState(DISABLE_DEACTIVATION);
  const double threshold = settings.number.at("contact-threshold");
  if (threshold < no_limit) object.setContactProcessingThreshold(to_bullet(threshold));
}

// Bits that Bullet keeps in an int.
int collision_group(const Placing& placing) { return static_cast<int>(placing.filter.groups); }
int collision_mask(const Placing& placing) { return static_cast<int>(placing.filter.mask); }

std::unique_ptr<BulletBody> make_rigid(const core::Body& body, const Placing& placing,
                                       const BulletSettings& settings, btDiscreteDynamicsWorld& world) {
  return std::make_unique<Rigid>(body, placing, settings, world);
}

}  // namespace cylon::simulators
