#include "reference/simulators/bullet/bullet_joints.h"

#include "harness/core/joint_coordinates.h"
#include "reference/simulators/bullet/bullet_border.h"
#include "reference/simulators/bullet/bullet_tree.h"

#include <BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h>
#include <btBulletDynamicsCommon.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cylon::simulators {
namespace {

using core::JointType;
using core::Vector3;
using Reason = std::optional<std::string>;

constexpr double no_stop =
    1e12;  // [m], for a displacement with one stop; a rate of no_stop/dt is still a float

// A frame of the world with these columns, seen from a body.
btTransform frame_in(const btRigidBody& body, const Vector3& x, const Vector3& y, const Vector3& origin) {
  core::Matrix3 columns;
  columns << x, y, x.cross(y);
  return body.getWorldTransform().inverse() * to_bullet(core::Quaternion(columns), origin);
}
// x along the axis.
btTransform frame_in(const btRigidBody& body, const core::Joint& joint, const Vector3& origin) {
  const auto turn = core::turn_between(Vector3::UnitX(), joint.axis);
  return body.getWorldTransform().inverse() * to_bullet(turn, origin);
}
// z along it.
btTransform hinge_frame_in(const btRigidBody& body, const core::Joint& joint) {
  const auto turn = core::turn_between(Vector3::UnitZ(), joint.axis);
  return body.getWorldTransform().inverse() * to_bullet(turn, joint.point);
}

bool limited(const core::Joint& joint) {
  const auto is = [](const core::JointCoordinate& c) { return core::has_limit(c); };
  return std::ranges::any_of(joint.displacements, is) || std::ranges::any_of(joint.angles, is);
}
bool resists(const core::JointCoordinate& c) { return core::has_limit(c) || c.friction != 0; }

// ---- Hinges -------------------------------------------------------------------------------------------

// Bullet's angle is that of its first body against the second, 0 where the frames agree: of `body`, as the scene's.
std::unique_ptr<btTypedConstraint> make_hinge(const core::Joint& joint, btRigidBody& body, btRigidBody* to,
                                              double dt, const BulletStops& stops) {
  const btVector3 point = to_bullet(joint.point), axis = to_bullet(joint.axis);
  const auto local = [&](const btRigidBody& b) { return b.getWorldTransform().invXform(point); };
  const auto local_axis = [&](const btRigidBody& b) {
    return b.getWorldTransform().getBasis().transpose() * axis;
  };
  if (!resisted(joint)) {
    if (!to) return std::make_unique<btHingeConstraint>(body, local(body), local_axis(body));
    return std::make_unique<btHingeConstraint>(body, *to, local(body), local(*to), local_axis(body),
                                               local_axis(*to));
  }
  btRigidBody& other = to ? *to : btTypedConstraint::getFixedBody();
  auto hinge = std::make_unique<btHingeConstraint>(body, other, hinge_frame_in(body, joint),
                                                   hinge_frame_in(other, joint));
  const core::JointAngle& c = joint.angles[0];
  // Softness has no effect, the bias factor multiplies the rate after a stop, and the relaxation is its restitution.
  if (core::has_limit(c)) {
    if (stops.erp) hinge->setParam(BT_CONSTRAINT_STOP_ERP, to_bullet(*stops.erp));
    hinge->setLimit(to_bullet(*c.lower - c.start), to_bullet(*c.upper - c.start), btScalar(0.9), 1,
                    to_bullet(c.restitution));
  }
  if (c.friction != 0) hinge->enableAngularMotor(true, 0, to_bullet(c.friction * dt));  // an impulse
  return hinge;
}

// ---- Six freedoms -------------------------------------------------------------------------------------

// A joint of six freedoms whose first body is `to`, as its displacements are those of the second along axes of the
// first.  All are locked by themselves but the turns.
class SixFreedoms {
 public:
  SixFreedoms(btRigidBody& to, btRigidBody& body, const btTransform& in_to, const btTransform& in_body,
              std::optional<double> erp)
      : erp_(erp), made_(std::make_unique<btGeneric6DofSpring2Constraint>(to, body, in_to, in_body, RO_XYZ)) {
    for (int i = 3; i < 6; ++i) made_->setLimit(i, 0, 0);
  }

  // Displacement i along the axis i of `to`.
  void slides(int i, const core::JointCoordinate& c) const {
    frees(i, c, c.lower ? *c.lower - c.start : -no_stop, c.upper ? *c.upper - c.start : no_stop);
  }
  // The angle about axis i; Bullet counts the turn of the first body against the second.
  void turns(int i, const core::JointCoordinate& c) const {
    core::JointCoordinate other = c;
    core::reverse(other);
    frees(3 + i, other, other.lower.value_or(0) - other.start, other.upper.value_or(0) - other.start);
  }

  // Locks nothing.
  void frees_all() const {
    for (int i = 0; i < 6; ++i) made_->setLimit(i, 1, -1);
  }

  std::unique_ptr<btTypedConstraint> made() { return std::move(made_); }

 private:
  void frees(int i, const core::JointCoordinate& c, double lower, double upper) const {
    made_->setLimit(i, 1, -1);  // none
    if (core::has_limit(c)) {
      made_->setLimit(i, to_bullet(lower), to_bullet(upper));
      made_->setBounce(i, to_bullet(c.restitution));
      if (erp_) made_->setParam(BT_CONSTRAINT_STOP_ERP, to_bullet(*erp_), i);
    }
    if (c.friction == 0) return;
    made_->enableMotor(i, true);
    made_->setTargetVelocity(i, 0);
    made_->setMaxMotorForce(i, to_bullet(c.friction));
  }

  std::optional<double> erp_;  // of its stops; nothing: Bullet's own
  std::unique_ptr<btGeneric6DofSpring2Constraint> made_;
};

template <class Coordinate>
core::JointCoordinate acting(const std::vector<Coordinate>& list, core::Ordinal which) {
  const auto found = std::ranges::find(list, which, &core::JointCoordinate::which);
  return found == list.end() ? core::JointCoordinate{.which = which} : core::JointCoordinate(*found);
}

// Where the joint's frames stand at the start.  A slider is the same joint about any point, and a cylindrical one about any
// of its axis: about the centre of mass of the body that moves, or near it, its rows hardly touch each other.
Vector3 origin_of(const core::Joint& joint, const btRigidBody& body, const btRigidBody& to) {
  const btRigidBody& moves = body.isStaticObject() ? to : body;
  const Vector3 centre = from_bullet(moves.getCenterOfMassPosition());
  if (joint.type == JointType::slider) return centre;
  if (joint.type == JointType::cylindrical)
    return joint.point + joint.axis.dot(centre - joint.point) * joint.axis;
  return joint.point;
}

std::unique_ptr<btTypedConstraint> make_six(const core::Joint& joint, btRigidBody& body, btRigidBody& to,
                                            std::optional<double> erp) {
  const Vector3 origin = origin_of(joint, body, to);
  const auto first = core::Ordinal::first, second = core::Ordinal::second;
  const auto displacement = [&](core::Ordinal which) { return acting(joint.displacements, which); };
  const auto angle = [&](core::Ordinal which) { return acting(joint.angles, which); };
  if (joint.type == JointType::universal) {
    // Of  Rz(first) Rx(second)  from `to` to `body`: Bullet takes its angles in the order z, y, x, and y is the one that
    // must not come near a quarter turn.
    const Vector3 &x = *joint.axis_2, y = joint.axis.cross(x);
    SixFreedoms six(to, body, frame_in(to, x, y, origin), frame_in(body, x, y, origin), erp);
    six.turns(2, angle(first)), six.turns(0, angle(second));
    return six.made();
  }
  if (core::kind_of(joint.type).place == core::JointPlace::in_plane) {
    SixFreedoms six(to, body, frame_in(to, joint.axis, *joint.axis_2, origin),
                    frame_in(body, joint.axis, *joint.axis_2, origin), erp);
    six.slides(1, displacement(first)), six.slides(2, displacement(second));
    if (joint.type == JointType::planar) six.turns(0, angle(first));
    return six.made();
  }
  SixFreedoms six(to, body, frame_in(to, joint, origin), frame_in(body, joint, origin), erp);
  if (joint.type != JointType::hinge) six.slides(0, displacement(first));
  if (joint.type != JointType::slider) six.turns(0, angle(first));
  return six.made();
}

// ---- Two bodies that move -----------------------------------------------------------------------------

// The joint of six freedoms pushes each of two bodies at its own point, which a displacement takes apart: a couple that
// nobody exerts.  Bullet's slider pushes both along one line.  Its own limits do not bounce: the bounce has the wrong sign.
std::unique_ptr<btTypedConstraint> make_slider(const core::Joint& joint, btRigidBody& body, btRigidBody& to,
                                               const BulletStops& stops) {
  auto slider = std::make_unique<btSliderConstraint>(to, body, frame_in(to, joint, joint.point),
                                                     frame_in(body, joint, joint.point), true);
  const core::JointCoordinate c = acting(joint.displacements, core::Ordinal::first);
  if (core::has_limit(c) && !stops.ahead) {
    if (stops.erp) slider->setParam(BT_CONSTRAINT_STOP_ERP, to_bullet(*stops.erp), 0);
    slider->setLowerLinLimit(to_bullet(c.lower ? *c.lower - c.start : -no_stop));
    slider->setUpperLinLimit(to_bullet(c.upper ? *c.upper - c.start : no_stop));
  }
  if (c.friction != 0) {
    slider->setPoweredLinMotor(true);
    slider->setMaxLinMotorForce(to_bullet(c.friction));
  }
  const bool turns = joint.type == JointType::cylindrical;
  slider->setLowerAngLimit(turns ? 1 : 0);
  slider->setUpperAngLimit(turns ? -1 : 0);
  return slider;
}

// ---- What Bullet does not have ------------------------------------------------------------------------

Reason against_stops(const core::JointAngle& c, const std::string& of) {
  if (!core::has_limit(c)) return {};
  if (!c.lower || !c.upper)
    return fmt::format(
        "Bullet stops an angle on both sides or on none "
        "(BulletDynamics/ConstraintSolver/btTypedConstraint.h:471), "
        "and {} has one stop.",
        of);
  for (const double stop : {*c.lower, *c.upper})
    if (!(std::abs(stop - c.start) < std::numbers::pi))
      return fmt::format(
          "Bullet's stops of an angle lie within half a turn (LinearMath/btScalar.h:781); {} has one at {} "
          "rad from "
          "its start.",
          of, stop - c.start);
  return {};
}

Reason against_two_movers(const core::Joint& joint, const std::string& of, bool ahead) {
  if (core::kind_of(joint.type).place == core::JointPlace::in_plane)
    return fmt::format(
        "Bullet's joint of six freedoms pushes each of two moving bodies at its own point "
        "(BulletDynamics/ConstraintSolver/btGeneric6DofSpring2Constraint.h:311), and {} would turn them.",
        of);
  if (joint.type != JointType::slider && joint.type != JointType::cylindrical) return {};
  for (const core::JointDisplacement& c : joint.displacements)
    if (core::has_limit(c) && c.restitution > 0 && !ahead)
      return fmt::format(
          "Bullet's slider between two moving bodies does not bounce: the rate after a stop has the wrong "
          "sign "
          "(BulletDynamics/ConstraintSolver/btSliderConstraint.h:204); {} has a restitution.",
          of);
  for (const core::JointAngle& c : joint.angles)
    if (core::has_limit(c) && !ahead)
      return fmt::format(
          "This adapter maps no stops of the angle of {}, whose bodies both move, without stops-ahead.", of);
  return {};
}

}  // namespace

Reason missing(const core::Joint& joint) {
  if (joint.type == JointType::distance)
    return "Bullet has no joint that keeps a distance "
           "(BulletDynamics/ConstraintSolver/btTypedConstraint.h:34).";
  if (joint.type == JointType::screw)
    return "Bullet has no screw (BulletDynamics/ConstraintSolver/btTypedConstraint.h:34).";
  return {};
}

Reason unsupported(const core::Scene& scene, const core::Joint& joint, bool ahead) {
  const auto body = [&](int i) -> const core::Body& { return scene.bodies[static_cast<std::size_t>(i)]; };
  const auto still = [&](int i) { return i == core::world || body(i).locked; };
  const std::string of =
      fmt::format("the {} joint of '{}'", core::kind_of(joint.type).name, body(joint.body).name);
  for (const core::JointAngle& c : joint.angles) {
    if (joint.type == JointType::gimbal && resists(c))
      return fmt::format("This adapter maps no stops and no friction of {}, which Bullet holds as a ball.",
                         of);
    if (Reason reason = against_stops(c, of)) return reason;
  }
  if (!still(joint.body) && !still(joint.to)) return against_two_movers(joint, of, ahead);
  if (core::kind_of(joint.type).place != core::JointPlace::in_plane || still(joint.to)) return {};
  for (const core::JointDisplacement& c : joint.displacements)
    if (resists(c))
      return fmt::format(
          "Bullet's joint of six freedoms pushes '{}' at its own point, and the stops and the friction of {} "
          "act at "
          "that of '{}'.",
          body(joint.to).name, of, body(joint.body).name);
  return {};
}

std::unique_ptr<btTypedConstraint> make_joint(const core::Joint& joint, btRigidBody& body, btRigidBody* to,
                                              double dt, const BulletStops& stops) {
  const btVector3 point = to_bullet(joint.point);
  const auto local = [&](const btRigidBody& b) { return b.getWorldTransform().invXform(point); };
  btRigidBody& other = to ? *to : btTypedConstraint::getFixedBody();
  const bool both = !body.isStaticObject() && !other.isStaticObject();
  switch (joint.type) {
    case JointType::ball:
    case JointType::gimbal:  // of which the angles are counted
      if (to) return std::make_unique<btPoint2PointConstraint>(body, *to, local(body), local(*to));
      return std::make_unique<btPoint2PointConstraint>(body, local(body));
    case JointType::hinge:
      return stops.ahead && limited(joint) ? make_six(joint, body, other, stops.erp)
                                           : make_hinge(joint, body, to, dt, stops);
    case JointType::fixed:
      return std::make_unique<btFixedConstraint>(body, other, frame_in(body, joint, joint.point),
                                                 frame_in(other, joint, joint.point));
    case JointType::slider:
    case JointType::cylindrical:
      return both ? make_slider(joint, body, other, stops) : make_six(joint, body, other, stops.erp);
    case JointType::planar:
    case JointType::rectangular:
    case JointType::universal:
      return make_six(joint, body, other, stops.erp);
    case JointType::distance:
    case JointType::screw:
    case JointType::offset_universal:
      break;
  }
  return nullptr;
}

// Rows along and about the axis alone: the points where they push the two lie on one line along it, whatever the
// displacement.
std::unique_ptr<btTypedConstraint> make_stop(const core::Joint& joint, btRigidBody& body, btRigidBody* to,
                                             const BulletStops& stops) {
  const bool both = to && !body.isStaticObject() && !to->isStaticObject();
  const bool slides = joint.type == JointType::slider || joint.type == JointType::cylindrical;
  core::JointCoordinate along = acting(joint.displacements, core::Ordinal::first);
  const core::JointCoordinate about = acting(joint.angles, core::Ordinal::first);
  along.friction = 0;                                          // which the slider has
  if (!stops.ahead) along.lower.reset(), along.upper.reset();  // the same
  if (!both || !slides || !(core::has_limit(along) || resists(about))) return nullptr;
  const Vector3 origin = origin_of(joint, body, *to);
  SixFreedoms six(*to, body, frame_in(*to, joint, origin), frame_in(body, joint, origin), stops.erp);
  six.frees_all();
  six.slides(0, along), six.turns(0, about);
  return six.made();
}

core::Reaction reaction(std::size_t j, const btTypedConstraint& constraint, const btRigidBody& body,
                        double dt) {
  const btRigidBody &a = constraint.getRigidBodyA(), &b = constraint.getRigidBodyB();
  const btJointFeedback& told = *constraint.getJointFeedback();
  const bool on_a = !a.isStaticObject();  // some joints push the two at different points: of one that moves
  const double sign = on_a == (&a == &body) ? 1 : -1;
  return {j, from_bullet((on_a ? a : b).getCenterOfMassPosition()),
          sign * dt * from_bullet(on_a ? told.m_appliedForceBodyA : told.m_appliedForceBodyB),
          sign * dt * from_bullet(on_a ? told.m_appliedTorqueBodyA : told.m_appliedTorqueBodyB)};
}

}  // namespace cylon::simulators
