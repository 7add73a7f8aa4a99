#include "reference/simulators/bullet/bullet_multibody.h"

#include "harness/core/joint_coordinates.h"
#include "reference/simulators/bullet/bullet_border.h"

#include <BulletDynamics/Featherstone/btMultiBody.h>
#include <BulletDynamics/Featherstone/btMultiBodyDynamicsWorld.h>
#include <BulletDynamics/Featherstone/btMultiBodyFixedConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h>
#include <BulletDynamics/Featherstone/btMultiBodyJointMotor.h>
#include <BulletDynamics/Featherstone/btMultiBodyLinkCollider.h>
#include <BulletDynamics/Featherstone/btMultiBodyPoint2Point.h>
#include <btBulletDynamicsCommon.h>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace cylon::simulators {
namespace {

constexpr btScalar no_stop = btScalar(1e12);  // [m, rad], where there is one stop

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Whether constraints act on the links of a tree, besides the joints from which they hang.
bool constrained(const core::Scene& scene, const Tree& tree) {
  return !tree.loops.empty() || std::ranges::any_of(tree.places, [&](const TreePlace& place) {
    return place.joint >= 0 && resisted(scene.joints[at(place.joint)]);
  });
}

// One btMultiBody: the base, which is the root or stands still, and the links.
class TreeBody {
 public:
  TreeBody(const core::Scene& scene, const Tree& tree, const std::vector<Placing>& placings,
           const BulletSettings& settings, btMultiBodyDynamicsWorld& world)
      : hung_(tree.places[0].joint >= 0),
        multibody_(static_cast<int>(tree.bodies.size()) - (hung_ ? 0 : 1),
                   to_bullet(hung_ ? 0.0 : scene.bodies[at(tree.bodies[0])].mass),
                   hung_ ? btVector3(0, 0, 0) : to_bullet(placings[at(tree.bodies[0])].principal.moments),
                   hung_, settings.on("sleeping")) {
    for (std::size_t i = 0; i < tree.bodies.size(); ++i)
      if (link(i) >= 0) set_up(scene, tree, placings, i);
    multibody_.finalizeMultiDof();
    const core::Body& root = scene.bodies[at(tree.bodies[0])];
    const btTransform pose = pose_to_bullet(root, placings[at(tree.bodies[0])].principal);
    if (hung_) {
      // The base stands at the joint's point, turned as the root is at the start, so the joint starts at
      // zero.
      const core::Joint& joint = scene.joints[at(tree.places[0].joint)];
      multibody_.setBaseWorldTransform(btTransform(pose.getRotation(), to_bullet(joint.point)));
    } else {
      multibody_.setBaseWorldTransform(pose);
      multibody_.setBaseVel(to_bullet(root.initial.velocity));
      multibody_.setBaseOmega(to_bullet(root.initial.angular_velocity));
    }
    for (std::size_t i = 0; i < tree.bodies.size(); ++i)
      if (link(i) >= 0) set_rates(scene, tree, placings, i);
    multibody_.setLinearDamping(to_bullet(settings.number.at("damping")));
    multibody_.setAngularDamping(to_bullet(settings.number.at("damping")));
    multibody_.setMaxCoordinateVelocity(to_bullet(settings.number.at("max-coordinate-velocity")));
    multibody_.setUseGyroTerm(settings.gyroscopic != "none");
    multibody_.useRK4Integration(settings.runge_kutta);
    multibody_.setHasSelfCollision(tree.bodies.size() > 1);
    for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
      const core::Body& body = scene.bodies[at(tree.bodies[i])];
      const Placing& placing = placings[at(tree.bodies[i])];
      if (body.collide || constrained(scene, tree))
        collide(link(i), pose_to_bullet(body, placing.principal), placing, body.collide, settings, world);
    }
    world.addMultiBody(&multibody_);
  }

  // The i-th body of the tree is this link; -1: the base.
  int link(std::size_t i) const { return static_cast<int>(i) - (hung_ ? 0 : 1); }

  core::BodyState state(int link, const core::Quaternion& principal) const {
    const btQuaternion base = multibody_.getWorldToBaseRot();
    if (link < 0)
      return {from_bullet(multibody_.getBasePos()), orientation_from_bullet(base.inverse(), principal),
              from_bullet(multibody_.getBaseVel()), from_bullet(multibody_.getBaseOmega())};
    // Of the base and the links, each in its own axes.
    const std::size_t all = at(multibody_.getNumLinks()) + 1;
    std::vector<btVector3> spin(all), velocity(all);
    multibody_.compTreeLinkVelocities(spin.data(), velocity.data());
    const btQuaternion orientation = to_local(link, base).inverse();
    return {from_bullet(multibody_.localPosToWorld(link, btVector3(0, 0, 0))),
            orientation_from_bullet(orientation, principal),
            from_bullet(quatRotate(orientation, velocity[at(link) + 1])),
            from_bullet(quatRotate(orientation, spin[at(link) + 1]))};
  }

  void push(int link, const core::Vector3& force, const core::Vector3& torque) {
    if (link < 0) {
      multibody_.addBaseForce(to_bullet(force));
      multibody_.addBaseTorque(to_bullet(torque));
    } else {
      multibody_.addLinkForce(link, to_bullet(force));
      multibody_.addLinkTorque(link, to_bullet(torque));
    }
  }

  // The articulated inertias of each step are made of these.
  void set_mass(int link, double mass) {
    if (link < 0)
      multibody_.setBaseMass(to_bullet(mass));
    else
      multibody_.getLink(link).m_mass = to_bullet(mass);
  }

  // btMultiBodyDynamicsWorld adds m g of the world to the base and to each link, and knows no other gravity.
  void fall(int link, const core::Vector3& more) {
    const btScalar mass = link < 0 ? multibody_.getBaseMass() : multibody_.getLinkMass(link);
    const btVector3 force = mass * to_bullet(more);
    link < 0 ? multibody_.addBaseForce(force) : multibody_.addLinkForce(link, force);
  }

  btMultiBody& multibody() { return multibody_; }

 private:
  // World to link: the turn of each joint after that of its parent.
  btQuaternion to_local(int link, const btQuaternion& base) const {
    const btQuaternion parent =
        multibody_.getParent(link) < 0 ? base : to_local(multibody_.getParent(link), base);
    return multibody_.getParentToLocalRot(link) * parent;
  }

  // Vectors in the axes of the frames that they are used in: those of the parent's and of the link's centre.
  void set_up(const core::Scene& scene, const Tree& tree, const std::vector<Placing>& placings,
              std::size_t i) {
    const int child = tree.bodies[i], parent = tree.places[i].parent;
    const core::Joint& joint = scene.joints[at(tree.places[i].joint)];
    const Placing& placing = placings[at(child)];
    const btTransform pose = pose_to_bullet(scene.bodies[at(child)], placing.principal);
    const btVector3 point = to_bullet(joint.point);
    btQuaternion turn = btQuaternion::getIdentity();  // parent to child; the base of a hung root is aligned
    btVector3 to_point(0, 0, 0),
        to_child = quatRotate(pose.getRotation().inverse(), pose.getOrigin() - point);
    int parent_link = -1;
    if (parent != core::world) {
      const btTransform of_parent = pose_to_bullet(scene.bodies[at(parent)], placings[at(parent)].principal);
      turn = pose.getRotation().inverse() * of_parent.getRotation();
      to_point = quatRotate(of_parent.getRotation().inverse(), point - of_parent.getOrigin());
      to_child = quatRotate(of_parent.getRotation().inverse(), pose.getOrigin() - of_parent.getOrigin());
      parent_link = link(at(
          static_cast<int>(std::find(tree.bodies.begin(), tree.bodies.end(), parent) - tree.bodies.begin())));
    }
    const btVector3 to_centre = quatRotate(pose.getRotation().inverse(), pose.getOrigin() - point);
    const btVector3 axis = quatRotate(pose.getRotation().inverse(), to_bullet(joint.axis));
    const btScalar mass = to_bullet(scene.bodies[at(child)].mass);
    const btVector3 moments = to_bullet(placing.principal.moments);
    switch (joint.type) {
      case core::JointType::ball:
      case core::JointType::gimbal:  // of which the angles are counted
        multibody_.setupSpherical(link(i), mass, moments, parent_link, turn, to_point, to_centre);
        return;
      case core::JointType::hinge:
        multibody_.setupRevolute(link(i), mass, moments, parent_link, turn, axis, to_point, to_centre);
        return;
      case core::JointType::fixed:
        multibody_.setupFixed(link(i), mass, moments, parent_link, turn, to_point, to_centre);
        return;
      case core::JointType::slider:
        multibody_.setupPrismatic(link(i), mass, moments, parent_link, turn, axis, to_point, to_centre,
                                  false);
        return;
      case core::JointType::planar:  // about the centre of mass, which moves as any point does
        multibody_.setupPlanar(link(i), mass, moments, parent_link, turn, axis, to_child);
        return;
      case core::JointType::distance:
      case core::JointType::cylindrical:
      case core::JointType::universal:
      case core::JointType::screw:
      case core::JointType::rectangular:
      case core::JointType::offset_universal:
        throw std::logic_error("the multibody path was asked for a joint that it refuses");
    }
  }

  void set_rates(const core::Scene& scene, const Tree& tree, const std::vector<Placing>& placings,
                 std::size_t i) {
    const int child = tree.bodies[i], parent = tree.places[i].parent;
    const core::Joint& joint = scene.joints[at(tree.places[i].joint)];
    if (joint.type == core::JointType::fixed) return;
    if (joint.type == core::JointType::slider) {
      const double rate = core::joint_displacement_rate(core::held_joint(scene, joint), core::Ordinal::first,
                                                        core::initial_state(scene));
      multibody_.setJointVel(link(i), to_bullet(joint.body == child ? rate : -rate));
      return;
    }
    const btQuaternion to_child =
        pose_to_bullet(scene.bodies[at(child)], placings[at(child)].principal).getRotation().inverse();
    core::Vector3 relative = scene.bodies[at(child)].initial.angular_velocity;
    if (parent != core::world) relative -= scene.bodies[at(parent)].initial.angular_velocity;
    const btVector3 spin = quatRotate(to_child, to_bullet(relative));
    const btVector3 axis = quatRotate(to_child, to_bullet(joint.axis));
    if (joint.type == core::JointType::planar) {
      const core::BodyState& start = scene.bodies[at(child)].initial;
      core::Vector3 velocity = start.velocity;
      if (parent != core::world) {
        const core::BodyState& from = scene.bodies[at(parent)].initial;
        velocity -= from.velocity + from.angular_velocity.cross(start.position - from.position);
      }
      const btVector3 slip = quatRotate(to_child, to_bullet(velocity));
      const btMultibodyLink& made = multibody_.getLink(link(i));
      const btScalar rates[] = {spin.dot(axis), slip.dot(made.getAxisBottom(1)),
                                slip.dot(made.getAxisBottom(2))};
      multibody_.setJointVelMultiDof(link(i), rates);
      return;
    }
    const btScalar rates[] = {core::kind_of(joint.type).turns_freely() ? spin.x() : spin.dot(axis), spin.y(),
                              spin.z()};
    multibody_.setJointVelMultiDof(link(i), rates);
  }

  // Bullet solves a constraint with the island of its ends' colliders, and leaves it out where they have
  // none: what cannot touch has one all the same in a tree with constraints, in no group.
  void collide(int link, const btTransform& pose, const Placing& placing, bool touches,
               const BulletSettings& settings, btMultiBodyDynamicsWorld& world) {
    colliders_.push_back(std::make_unique<btMultiBodyLinkCollider>(&multibody_, link));
    btMultiBodyLinkCollider& collider = *colliders_.back();
    collider.setCollisionShape(placing.shape);
    collider.setWorldTransform(pose);
    prepare(collider, placing, settings);
    if (link < 0)
      multibody_.setBaseCollider(&collider);
    else
      multibody_.getLink(link).m_collider = &collider;
    if (touches)
      world.addCollisionObject(&collider, collision_group(placing), collision_mask(placing));
    else
      world.addCollisionObject(&collider, 0, 0);
  }

  bool hung_;  // from the world
  btMultiBody multibody_;
  std::vector<std::unique_ptr<btMultiBodyLinkCollider>> colliders_;
};

// A body of the scene: a link of its tree.
class Link final : public BulletBody {
 public:
  Link(std::shared_ptr<TreeBody> tree, int link, core::Quaternion principal)
      : tree_(std::move(tree)), link_(link), principal_(std::move(principal)) {}

  core::BodyState state() const override { return tree_->state(link_, principal_); }
  void push(const core::Vector3& force, const core::Vector3& torque) override {
    tree_->push(link_, force, torque);
  }
  void set_mass(double mass) override { tree_->set_mass(link_, mass); }
  void fall(const core::Vector3& more) override { tree_->fall(link_, more); }

 private:
  std::shared_ptr<TreeBody> tree_;
  int link_;
  core::Quaternion principal_;
};

// A place in the tree seen from the joint that would close a loop.
struct End {
  int link = -1;
  btTransform pose;
};

// A constraint that holds the joint's point of link a at that of link b, or of the world where b is null.
std::unique_ptr<btMultiBodyConstraint> closing(const core::Joint& joint, btMultiBody& body, const End& a,
                                               const End* b) {
  const btVector3 point = to_bullet(joint.point);
  const btVector3 in_a = a.pose.invXform(point), in_b = b ? b->pose.invXform(point) : point;
  const btMatrix3x3 turn_a = a.pose.getBasis().transpose();
  const btMatrix3x3 turn_b = b ? b->pose.getBasis().transpose() : btMatrix3x3::getIdentity();
  btRigidBody* const world = nullptr;
  switch (joint.type) {
    case core::JointType::ball:
    case core::JointType::gimbal:
      if (b) return std::make_unique<btMultiBodyPoint2Point>(&body, a.link, &body, b->link, in_a, in_b);
      return std::make_unique<btMultiBodyPoint2Point>(&body, a.link, world, in_a, in_b);
    case core::JointType::fixed:
      if (b)
        return std::make_unique<btMultiBodyFixedConstraint>(&body, a.link, &body, b->link, in_a, in_b, turn_a,
                                                            turn_b);
      return std::make_unique<btMultiBodyFixedConstraint>(&body, a.link, world, in_a, in_b, turn_a, turn_b);
    case core::JointType::hinge:
    case core::JointType::distance:
    case core::JointType::slider:
    case core::JointType::cylindrical:
    case core::JointType::planar:
    case core::JointType::universal:
    case core::JointType::screw:
    case core::JointType::rectangular:
    case core::JointType::offset_universal:
      break;
  }
  throw std::logic_error("the multibody path was asked to close a loop by a joint that it refuses");
}

}  // namespace

void make_multibody(const core::Scene& scene, const Tree& tree, const std::vector<Placing>& placings,
                    const BulletSettings& settings, double dt, btMultiBodyDynamicsWorld& world,
                    std::vector<std::unique_ptr<BulletBody>>& bodies,
                    std::vector<std::unique_ptr<btMultiBodyConstraint>>& constraints) {
  const auto body = std::make_shared<TreeBody>(scene, tree, placings, settings, world);
  for (std::size_t i = 0; i < tree.bodies.size(); ++i) {
    const int of_scene = tree.bodies[i];
    bodies[at(of_scene)] =
        std::make_unique<Link>(body, body->link(i), placings[at(of_scene)].principal.rotation);
  }
  const auto end = [&](int of_scene) {
    const auto place = std::find(tree.bodies.begin(), tree.bodies.end(), of_scene) - tree.bodies.begin();
    return End{body->link(static_cast<std::size_t>(place)),
               pose_to_bullet(scene.bodies[at(of_scene)], placings[at(of_scene)].principal)};
  };
  const auto add = [&](std::unique_ptr<btMultiBodyConstraint> constraint, btScalar most) {
    constraint->setMaxAppliedImpulse(most);  // 100 N s by itself
    world.addMultiBodyConstraint(constraint.get());
    constraints.push_back(std::move(constraint));
  };
  // The coordinate of a link is that of its body against its parent, 0 at the start.
  for (std::size_t i = 0; i < tree.places.size(); ++i) {
    if (tree.places[i].joint < 0) continue;
    const core::Joint& joint = scene.joints[at(tree.places[i].joint)];
    core::JointCoordinate c = coordinate_of(joint);
    if (joint.body != tree.bodies[i]) core::reverse(c);
    if (core::has_limit(c))
      add(std::make_unique<btMultiBodyJointLimitConstraint>(
              &body->multibody(), body->link(i), c.lower ? to_bullet(*c.lower - c.start) : -no_stop,
              c.upper ? to_bullet(*c.upper - c.start) : no_stop),
          BT_LARGE_FLOAT);
    if (c.friction != 0) {
      const btScalar most = to_bullet(c.friction * dt);
      add(std::make_unique<btMultiBodyJointMotor>(&body->multibody(), body->link(i), 0, most), most);
    }
  }
  for (const int j : tree.loops) {
    const core::Joint& joint = scene.joints[at(j)];
    const bool turned = still(scene, joint.body);
    const End a = end(turned ? joint.to : joint.body);
    const int other = turned ? joint.body : joint.to;
    if (still(scene, other)) {
      add(closing(joint, body->multibody(), a, nullptr), BT_LARGE_FLOAT);
    } else {
      const End b = end(other);
      add(closing(joint, body->multibody(), a, &b), BT_LARGE_FLOAT);
    }
  }
}

}  // namespace cylon::simulators
