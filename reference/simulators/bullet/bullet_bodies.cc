#include "reference/simulators/bullet/bullet_bodies.h"

#include "reference/simulators/bullet/bullet_border.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <btBulletDynamicsCommon.h>

#include <stdexcept>

namespace cylon::simulators {
namespace {

// Bullet's body frame is turned from ours by the principal axes A: R_bullet = R A.
btTransform bullet_pose(const core::Body& body, const Placing& placing) {
  return to_bullet(body.initial.orientation * placing.principal.rotation, body.initial.position);
}

core::Quaternion our_orientation(const btQuaternion& orientation, const core::Quaternion& principal) {
  return (from_bullet(orientation) * principal.conjugate()).normalized();
}

class Rigid final : public BulletBody {
 public:
  Rigid(const core::Body& body, const Placing& placing, const BulletSettings& settings,
        btDiscreteDynamicsWorld& world)
      : principal_(placing.principal.rotation), body_(info(body, placing)) {
    prepare(body_, placing, settings);
    body_.setFlags(gyroscopic_flag(settings.gyroscopic));
    if (!body.locked) {
      body_.setLinearVelocity(to_bullet(body.initial.velocity));
      body_.setAngularVelocity(to_bullet(body.initial.angular_velocity));
    }
    if (body.collide)
      world.addRigidBody(&body_);
    else
      world.addRigidBody(&body_, 0, 0);
  }

  core::BodyState state() const override {
    const btTransform& pose = body_.getWorldTransform();
    return {from_bullet(pose.getOrigin()), our_orientation(pose.getRotation(), principal_),
            from_bullet(body_.getLinearVelocity()), from_bullet(body_.getAngularVelocity())};
  }

  void push(const core::Vector3& force, const core::Vector3& torque) override {
    body_.applyCentralForce(to_bullet(force));
    body_.applyTorque(to_bullet(torque));
  }

  btRigidBody* rigid() override { return &body_; }

 private:
  static btRigidBody::btRigidBodyConstructionInfo info(const core::Body& body, const Placing& placing) {
    const btVector3 moments = body.locked ? btVector3(0, 0, 0) : to_bullet(placing.principal.moments);
    btRigidBody::btRigidBodyConstructionInfo result(to_bullet(body.locked ? 0.0 : body.mass), nullptr,
                                                    placing.shape, moments);
    result.m_startWorldTransform = bullet_pose(body, placing);
    return result;
  }

  static int gyroscopic_flag(const std::string& gyroscopic) {
    if (gyroscopic == "none") return 0;
    if (gyroscopic == "explicit") return BT_ENABLE_GYROSCOPIC_FORCE_EXPLICIT;
    if (gyroscopic == "implicit-world") return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_WORLD;
    return BT_ENABLE_GYROSCOPIC_FORCE_IMPLICIT_BODY;
  }

  core::Quaternion principal_;
  btRigidBody body_;
};

class Multibody final : public BulletBody {
 public:
  Multibody(const core::Body& body, const core::Joint* joint, const Placing& placing,
            const BulletSettings& settings, btMultiBodyDynamicsWorld& world)
      : principal_(placing.principal.rotation),
        link_(joint ? 0 : -1),
        multibody_(joint ? 1 : 0, to_bullet(joint ? 0.0 : body.mass),
                   joint ? btVector3(0, 0, 0) : to_bullet(placing.principal.moments), joint != nullptr,
                   false) {
    const btTransform pose = bullet_pose(body, placing);
    if (joint)
      hang(body, *joint, placing, pose);
    else
      free(body, pose);
    multibody_.setLinearDamping(0);
    multibody_.setAngularDamping(0);
    multibody_.setMaxCoordinateVelocity(to_bullet(no_limit));
    multibody_.setUseGyroTerm(settings.gyroscopic != "none");
    multibody_.setHasSelfCollision(false);
    if (body.collide) collide(placing, settings, pose, world);
    world.addMultiBody(&multibody_);
  }

  core::BodyState state() const override {
    const btQuaternion base = multibody_.getWorldToBaseRot();
    if (link_ < 0)
      return {from_bullet(multibody_.getBasePos()), our_orientation(base.inverse(), principal_),
              from_bullet(multibody_.getBaseVel()), from_bullet(multibody_.getBaseOmega())};
    btVector3 spin[2], velocity[2];  // of the base and the link, each in its own axes
    multibody_.compTreeLinkVelocities(spin, velocity);
    const btQuaternion orientation = (multibody_.getParentToLocalRot(0) * base).inverse();
    return {from_bullet(multibody_.localPosToWorld(0, btVector3(0, 0, 0))),
            our_orientation(orientation, principal_), from_bullet(quatRotate(orientation, velocity[1])),
            from_bullet(quatRotate(orientation, spin[1]))};
  }

  void push(const core::Vector3& force, const core::Vector3& torque) override {
    if (link_ < 0) {
      multibody_.addBaseForce(to_bullet(force));
      multibody_.addBaseTorque(to_bullet(torque));
    } else {
      multibody_.addLinkForce(0, to_bullet(force));
      multibody_.addLinkTorque(0, to_bullet(torque));
    }
  }

 private:
  void free(const core::Body& body, const btTransform& pose) {
    multibody_.finalizeMultiDof();
    multibody_.setBaseWorldTransform(pose);
    multibody_.setBaseVel(to_bullet(body.initial.velocity));
    multibody_.setBaseOmega(to_bullet(body.initial.angular_velocity));
  }

  // The base stands at the joint's point, turned as the body is at the start, so the joint starts at zero.
  void hang(const core::Body& body, const core::Joint& joint, const Placing& placing,
            const btTransform& pose) {
    const btVector3 moments = to_bullet(placing.principal.moments);
    const btVector3 to_centre =
        quatRotate(pose.getRotation().inverse(), pose.getOrigin() - to_bullet(joint.point));
    const btVector3 spin = quatRotate(pose.getRotation().inverse(), to_bullet(body.initial.angular_velocity));
    const btVector3 axis = quatRotate(pose.getRotation().inverse(), to_bullet(joint.axis));
    const btQuaternion aligned = btQuaternion::getIdentity();
    const btScalar mass = to_bullet(body.mass);
    btScalar rates[] = {spin.x(), spin.y(), spin.z()};
    switch (joint.type) {
      case core::JointType::ball:
        multibody_.setupSpherical(0, mass, moments, -1, aligned, btVector3(0, 0, 0), to_centre);
        break;
      case core::JointType::hinge:
        multibody_.setupRevolute(0, mass, moments, -1, aligned, axis, btVector3(0, 0, 0), to_centre);
        rates[0] = spin.dot(axis);
        break;
      case core::JointType::distance:
      case core::JointType::fixed:
        throw std::logic_error("the multibody path was asked for a joint that it refuses");
    }
    multibody_.finalizeMultiDof();
    multibody_.setBaseWorldTransform(btTransform(pose.getRotation(), to_bullet(joint.point)));
    multibody_.setJointVelMultiDof(0, rates);
  }

  void collide(const Placing& placing, const BulletSettings& settings, const btTransform& pose,
               btMultiBodyDynamicsWorld& world) {
    collider_ = std::make_unique<btMultiBodyLinkCollider>(&multibody_, link_);
    collider_->setCollisionShape(placing.shape);
    collider_->setWorldTransform(pose);
    prepare(*collider_, placing, settings);
    if (link_ < 0)
      multibody_.setBaseCollider(collider_.get());
    else
      multibody_.getLink(0).m_collider = collider_.get();
    world.addCollisionObject(collider_.get(), btBroadphaseProxy::DefaultFilter, btBroadphaseProxy::AllFilter);
  }

  core::Quaternion principal_;
  int link_;  // -1: the base
  btMultiBody multibody_;
  std::unique_ptr<btMultiBodyLinkCollider> collider_;
};

}  // namespace

void prepare(btCollisionObject& object, const Placing& placing, const BulletSettings& settings) {
  // Read by the combination callbacks.
  object.setUserPointer(const_cast<Surfaces*>(placing.surfaces));  // NOLINT(*-const-cast): only read
  object.setUserIndex(placing.surface);
  object.setUserIndex2(placing.owner);  // whom contacts belong to
  object.setActivationState(DISABLE_DEACTIVATION);
  const double threshold = settings.number.at("contact-threshold");
  if (threshold < no_limit) object.setContactProcessingThreshold(to_bullet(threshold));
}

std::unique_ptr<BulletBody> make_rigid(const core::Body& body, const Placing& placing,
                                       const BulletSettings& settings, btDiscreteDynamicsWorld& world) {
  return std::make_unique<Rigid>(body, placing, settings, world);
}

std::unique_ptr<BulletBody> make_multibody(const core::Body& body, const core::Joint* joint,
                                           const Placing& placing, const BulletSettings& settings,
                                           btMultiBodyDynamicsWorld& world) {
  return std::make_unique<Multibody>(body, joint, placing, settings, world);
}

}  // namespace cylon::simulators
