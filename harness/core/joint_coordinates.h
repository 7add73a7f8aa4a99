// The free coordinates of joints: their values and rates, of a state, and what acts along them.
// Knows no engine.
#pragma once

#include "harness/core/held_joint.h"
#include "harness/core/truth.h"

namespace cylon::core {

/// The direction of a displacement that a joint leaves free, unit: world axes at t = 0, carried by `to`.
Vector3 direction_of(const Joint&, Ordinal);

/// A displacement of a joint that leaves it free [m]:  with d from the point on `to` to that on `body` and axes as `to`
/// carries them,  axis . d;  of a planar joint  axis_2 . d  and  (axis x axis_2) . d.  0 at t = 0.
double joint_displacement(const HeldJoint&, Ordinal, const State&);
/// Its rate [m/s].
double joint_displacement_rate(const HeldJoint&, Ordinal, const State&);

/// An angle of a joint that leaves it free [rad], in [-pi, pi] and 0 at t = 0: of `body` against `to` about the axis,
/// right-handed; of a universal joint the two of  R(axis, first) R(axis_2, second)  and of a gimbal the three of
/// R(axis, first) R(axis x axis_2, third) R(axis_2, second),  of which the third is how much the angle between the two
/// axes has grown.  A state does not tell whole turns.  Of a gimbal with parallel axes: not a number.
double joint_angle(const HeldJoint&, Ordinal, const State&);
/// Its rate [rad/s]: that of the relative spin along angle_direction().
double joint_angle_rate(const HeldJoint&, Ordinal, const State&);
/// Along which the spin of `body` against that of `to` changes an angle, and a torque on `body` works on it; world axes.
/// Unit but for a gimbal's first and second, 1/sin of the angle between its axes.
Vector3 angle_direction(const HeldJoint&, Ordinal, const State&);

/// 1/sin of the angle between the axes of a gimbal: what its first and its second angle make of small turns; of every other
/// joint 1.
double angle_sharpness(const HeldJoint&, const State&);

/// Where the spring of a coordinate is without force [m, rad], and how fast that moves: the right derivative.
double target(const JointCoordinate&, double time);
double target_rate(const JointCoordinate&, double time);

/// Whether the target moves.
bool target_moves(const JointCoordinate&);

/// Whether a force acts that the smooth law states; limits and dry friction are others.
bool has_force(const JointCoordinate&);
bool has_limit(const JointCoordinate&);
bool has_rotor(const JointCoordinate&);

/// The same coordinate counted the other way: q -> -q.
void reverse(JointCoordinate&);

/// Calls visit(coordinate) for each coordinate of the joint on which something acts: displacements, then angles.
template <class AJoint, class Visit>
void for_each_coordinate(AJoint& joint, Visit&& visit) {
  for (auto& coordinate : joint.displacements) visit(coordinate);
  for (auto& coordinate : joint.angles) visit(coordinate);
}

/// Whether something acts along a coordinate of the joint.
inline bool acted_on(const Joint& joint) { return !joint.displacements.empty() || !joint.angles.empty(); }

/// Whether it lets its bodies turn about its point and counts no angle: a ball, or a gimbal on which nothing acts.
inline bool is_ball(const Joint& joint) {
  return joint.type == JointType::ball || (joint.type == JointType::gimbal && !acted_on(joint));
}

/// The joint of a scene that begins with `state` and holds it as `held` does: its point and its axes as they are now,
/// the coordinates counted on.
Joint joint_at(const HeldJoint& held, const State&);

/// Whether something acts along a coordinate of some joint of the scene that satisfies the predicate.
template <class Predicate>
bool any_coordinate(const Scene& scene, Predicate predicate) {
  bool found = false;
  for (const Joint& joint : scene.joints)
    for_each_coordinate(joint,
                        [&](const JointCoordinate& coordinate) { found = found || predicate(coordinate); });
  return found;
}

/// Sum of size(U) over the springs with a target at rest and the constant forces of a joint [J]:
///   U = stiffness (q - target)^2 / 2 - force q.
/// An angle is that of joint_angle() + start; of more turns: turns.h.
double joint_potential(
    const HeldJoint&, const State&, double (*size)(double) = [](double u) { return u; });

/// Sum of the kinetic energies of the rotors on the coordinates of a joint, armature q'^2/2 [J].
double rotor_energy(const HeldJoint&, const State&);

/// First-order bound on the error of rotor_energy that an error of the state makes [J].
double rotor_energy_error(const HeldJoint&, const State&, const StateError&);

/// First-order bound on the error of joint_potential that an error of the state makes [J].
double joint_potential_error(const HeldJoint&, const State&, const StateError&);

}  // namespace cylon::core
