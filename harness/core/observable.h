// Physical quantities as functions of Scene and State, computed here and never asked of an engine.
#pragma once

#include "harness/core/event.h"
#include "harness/core/scene.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::core {

enum class Quantity {
  position,            ///< Of each body [m].
  velocity,            ///< Of each body [m/s].
  orientation,         ///< Of each body; distance 4 asin(|q - q'|/2) after the sign fix, in [0, pi] [rad].
  axis,                ///< Symmetry axis of each body in world axes; distance is the angle [rad].
  angular_velocity,    ///< Of each body, world axes [rad/s].
  linear_momentum,     ///< Total, or of one body [kg m/s].
  angular_momentum,    ///< Total, or of one body, about `about` [kg m^2/s].
  energy,              ///< Kinetic plus potential of the scene's forces [J].
  kinetic_energy,      ///< Total, or of one body [J].
  energy_share,        ///< How a gas shares its kinetic energy: equipartition.h.
  normal_gap,          ///< min(0, gap) of each touching pair: 0 while apart, minus the depth inside [m].
  joint_gap,           ///< Distance between the two anchors of each joint, less its length [m].
  angular_joint_gap,   ///< Angle by which each joint's bodies are turned as it forbids [rad].
  joint_displacement,  ///< Of each joint that leaves one free: joint_coordinates.h [m].
  joint_displacement_rate,   ///< [m/s]
  joint_angle,               ///< The same [rad]; distance in [0, pi].
  joint_angle_rate,          ///< [rad/s]
  momentum_balance,          ///< Of each body over the last step: force_balance.h [N].
  angular_momentum_balance,  ///< The same of its spin [N m].
  joint_force,               ///< Of each joint on its body, mean over the last step: joint_force.h [N].
  joint_torque,              ///< The same about the joint's point [N m].
  event                      ///< A number of one event: event.h.
};

/// Whether it is the force or the torque of joints.
constexpr bool of_joint_forces(Quantity quantity) {
  return quantity == Quantity::joint_force || quantity == Quantity::joint_torque;
}

/// Whether it is of a run's last step and not of a state: a balance, or what joints exert.
constexpr bool of_last_step(Quantity quantity) {
  return quantity == Quantity::momentum_balance || quantity == Quantity::angular_momentum_balance ||
         of_joint_forces(quantity);
}

/// Whether it is a coordinate of joints or its rate.
constexpr bool of_joints(Quantity quantity) {
  return quantity >= Quantity::joint_displacement && quantity <= Quantity::joint_angle_rate;
}

/// Whether statistical mechanics expects a value of it, and how far chance takes it from there.
constexpr bool of_chance(Quantity quantity) { return quantity == Quantity::energy_share; }

enum class Component { all, x, y, z, horizontal };

/// The axes that are meant: 0, 1, 2.
std::span<const int> axes(Component);
/// v without the components that are not meant.
Vector3 only(const Vector3& v, Component);

struct Observable {
  Quantity quantity = Quantity::position;
  std::optional<int> body;  ///< Absent: all bodies; the worst counts (momenta, energies: the sum).
  Component component = Component::all;  ///< Of vectors; horizontal drops y.
  Vector3 about = Vector3::Zero();       ///< Angular momentum and apsides [m].
  std::optional<int> to;                 ///< Apsides: the other body, in place of `about`.
  std::optional<int> joint;              ///< Of joints: absent: all that have one; the worst counts.
  Ordinal which = Ordinal::first;        ///< Of the coordinates of a joint.
  EventKind event = EventKind::bounce;
  int index = 1;
  EventQuantity event_quantity = EventQuantity::time;
};

/// The words of the scenario file: "position", "linear_momentum", …
std::string_view name(Quantity);
std::string_view unit(const Observable&);

/// A scene may have no such quantity: no joints, no body with a symmetry axis, no touching pair, a
/// shape whose gap is not computed.  The reason, or nothing when it has.
std::optional<std::string> undefined_in(const Observable&, const Scene&);

/// One entry per body or joint (one for totals), four numbers each: a vector (w = 0), a scalar (in x), a
/// quaternion; normal_gap: one per overlapping pair, its gap, body, other and plane.  Not for events.
using Values = std::vector<Eigen::Vector4d>;
void evaluate(const Observable&, const Scene&, const State&, Values&);

/// The worst entry's distance between two values, in the observable's unit.  NaN where either is.
double distance(const Observable&, const Values&, const Values&);

/// The worst entry's size, for relative tolerances.  Angles have none: 0.
double magnitude(const Observable&, const Values&);

/// Size that a drift of an energy is compared with: kinetic energy plus the magnitudes of the potential terms
/// [J].
double energy_scale(const Scene&, const State&);

/// Gap between the surfaces of a pair, negative inside [m].  Against a plane of any body; of two bodies where
/// both are convex or compounds of convex parts: minus the depth of the deepest two parts.
double gap(const Scene&, const Pair&, const State&);

/// d gap/dt for rigid bodies: the relative speed along the normal of the two points that are nearest [m/s].
double gap_rate(const Scene&, const Pair&, const State&);

/// Why gap() does not serve a pair, or nothing when it does.
std::optional<std::string> gap_undefined(const Scene&, const Pair&);

/// The body axis (0, 1, 2 of its principal axes, as a unit vector in the body frame) about which the
/// inertia is symmetric within 1e-9; nothing for three equal or three different moments.
std::optional<Vector3> symmetry_axis(const Body&);

}  // namespace cylon::core
