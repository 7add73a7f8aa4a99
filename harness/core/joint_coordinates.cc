#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace cylon::core {
namespace {

// An end of a joint: where it is and how it moves.
struct End {
  Quaternion orientation = Quaternion::Identity();
  Vector3 spin = Vector3::Zero(), position, velocity = Vector3::Zero();
};

End end_of(const State& state, int body, const Vector3& anchor) {
  if (body == world) return {.position = anchor};
  const BodyState& s = state[static_cast<std::size_t>(body)];
  const Vector3 arm = s.orientation * anchor;
  return {s.orientation, s.angular_velocity, s.position + arm, s.velocity + s.angular_velocity.cross(arm)};
}

End first_end(const HeldJoint& j, const State& state) { return end_of(state, j.body, j.anchor); }
End second_end(const HeldJoint& j, const State& state) { return end_of(state, j.to, j.to_anchor); }

// The direction of a displacement, axes of `to`.
Vector3 direction(const HeldJoint& j, Ordinal which) {
  if (!kind_of(j.type).has_second_axis()) return j.to_axis;
  return which == Ordinal::first ? j.to_axis_2 : Vector3(j.to_axis.cross(j.to_axis_2));
}

// The place of a time in the table: the knot before it, -1 before the first, the last after that.
std::ptrdiff_t knot(const JointCoordinate& c, double time) {
  return std::ranges::upper_bound(c.target_times, time) - c.target_times.begin() - 1;
}

double slope(const JointCoordinate& c, std::size_t k) {
  return (c.target_values[k + 1] - c.target_values[k]) / (c.target_times[k + 1] - c.target_times[k]);
}

}  // namespace

Vector3 direction_of(const Joint& joint, Ordinal which) {
  if (!kind_of(joint.type).has_second_axis()) return joint.axis;
  return which == Ordinal::first ? *joint.axis_2 : Vector3(joint.axis.cross(*joint.axis_2));
}

double joint_displacement(const HeldJoint& joint, Ordinal which, const State& state) {
  const End a = first_end(joint, state), b = second_end(joint, state);
  return (a.position - b.position).dot(b.orientation * direction(joint, which));
}

// (n.d)' = n.(d' - w_to x d),  n fixed in `to`
double joint_displacement_rate(const HeldJoint& joint, Ordinal which, const State& state) {
  const End a = first_end(joint, state), b = second_end(joint, state);
  return (a.velocity - b.velocity - b.spin.cross(a.position - b.position))
      .dot(b.orientation * direction(joint, which));
}

// About two axes h, u,  R = R(h, a) R(h x u, b) R(u, c):  with u' the part of u square to h and h' that of h to u,
//   R u = R(h, a) R(h x u, b) u,   of which R(h, a) turns the part square to h:  cos a u' + sin a h x u, times a number,
//   R^T h = R(u, -c) R(h x u, -b) h,   the same:  cos c h' - sin c u x h,
// and  b  is what the angle between h and R u has grown.
double joint_angle(const HeldJoint& joint, Ordinal which, const State& state) {
  const Quaternion turn =  // since t = 0, in the axes of `to`
      second_end(joint, state).orientation.conjugate() * first_end(joint, state).orientation *
      joint.turn.conjugate();
  const Vector3 &h = joint.to_axis, &u = joint.to_axis_2;
  if (!kind_of(joint.type).turns_between_axes())
    return std::remainder(2 * std::atan2(turn.vec().dot(h), turn.w()), 2 * std::numbers::pi);
  const auto between = [](const Vector3& x, const Vector3& y) {
    return std::atan2(x.cross(y).norm(), x.dot(y));
  };
  switch (which) {
    case Ordinal::first: {
      const Vector3 now = turn * u;
      return std::atan2(now.dot(h.cross(u)), now.dot(u - h.dot(u) * h));
    }
    case Ordinal::second: {
      const Vector3 now = turn.conjugate() * h;
      return std::atan2(-now.dot(u.cross(h)), now.dot(h - u.dot(h) * u));
    }
    case Ordinal::third:
      break;
  }
  return between(h, turn * u) - between(h, u);
}

// h and u span the turns that the other two angles leave, so an angle's rate is the spin along what is square to those:
//   w = h a' + n b' + u c',  n = h x u/|h x u|:   a' = w.(h - s u)/(1 - s^2),  c' = w.(u - s h)/(1 - s^2),  s = h.u
Vector3 angle_direction(const HeldJoint& joint, Ordinal which, const State& state) {
  const Vector3 h = second_end(joint, state).orientation * joint.to_axis;
  if (!kind_of(joint.type).turns_between_axes()) return h;
  const Vector3 u = first_end(joint, state).orientation * joint.axis_2;
  if (kind_of(joint.type).turn == JointTurn::about_two_axes) return which == Ordinal::first ? h : u;
  const Vector3 normal = h.cross(u);
  const double sine = normal.norm();
  if (which == Ordinal::third) return normal / sine;
  const double s = h.dot(u);
  return (which == Ordinal::first ? Vector3(h - s * u) : Vector3(u - s * h)) / (sine * sine);
}

double angle_sharpness(const HeldJoint& joint, const State& state) {
  if (kind_of(joint.type).turn != JointTurn::about_three_axes) return 1;
  const Vector3 h = second_end(joint, state).orientation * joint.to_axis,
                u = first_end(joint, state).orientation * joint.axis_2;
  return 1 / h.cross(u).norm();
}

double joint_angle_rate(const HeldJoint& joint, Ordinal which, const State& state) {
  return (first_end(joint, state).spin - second_end(joint, state).spin)
      .dot(angle_direction(joint, which, state));
}

double target(const JointCoordinate& c, double time) {
  if (c.target_times.empty())
    return c.target + c.target_amplitude * std::cos(c.target_frequency * time + c.target_phase);
  const std::ptrdiff_t before = knot(c, time);
  if (before < 0) return c.target_values.front();
  const auto k = static_cast<std::size_t>(before);
  if (k + 1 >= c.target_times.size()) return c.target_values.back();
  return c.target_values[k] + slope(c, k) * (time - c.target_times[k]);
}

double target_rate(const JointCoordinate& c, double time) {
  if (c.target_times.empty())
    return -c.target_amplitude * c.target_frequency * std::sin(c.target_frequency * time + c.target_phase);
  const std::ptrdiff_t before = knot(c, time);
  if (before < 0 || before + 1 >= std::ssize(c.target_times)) return 0;
  return slope(c, static_cast<std::size_t>(before));
}

bool target_moves(const JointCoordinate& c) {
  return !c.target_times.empty() || (c.target_amplitude != 0 && c.target_frequency != 0);
}

bool has_force(const JointCoordinate& c) {
  return c.force != 0 || c.stiffness != 0 || c.damping != 0 || c.quadratic_damping != 0;
}

bool has_limit(const JointCoordinate& c) { return c.lower || c.upper; }

bool has_rotor(const JointCoordinate& c) { return c.armature != 0; }

void reverse(JointCoordinate& c) {
  // Not -0, which is no default of a scenario file.
  for (double* value : {&c.start, &c.force, &c.target, &c.target_amplitude}) *value = 0 - *value;
  for (double& value : c.target_values) value = 0 - value;
  std::swap(c.lower, c.upper);
  if (c.lower) *c.lower = 0 - *c.lower;
  if (c.upper) *c.upper = 0 - *c.upper;
}

double joint_potential(const HeldJoint& joint, const State& state, double (*size)(double)) {
  double sum = 0;
  const auto add = [&](const JointCoordinate& c, double since) {
    const double q = c.start + since;
    if (c.stiffness != 0 && !target_moves(c)) sum += size(c.stiffness / 2 * std::pow(q - target(c, 0), 2));
    if (c.force != 0) sum += size(-c.force * q);
  };
  for (const JointDisplacement& c : joint.displacements) add(c, joint_displacement(joint, c.which, state));
  for (const JointAngle& c : joint.angles) add(c, joint_angle(joint, c.which, state));
  return sum;
}

// dU = (k (q - target) - F) dq;  a displacement is off by twice the error of a place and of an arm, the distance of the
// points included, and an angle by twice that of an orientation.
double joint_potential_error(const HeldJoint& joint, const State& state, const StateError& e) {
  double sum = 0;
  const auto slope = [&](const JointCoordinate& c, double since) {
    const double pull = target_moves(c) ? 0 : c.stiffness * (c.start + since - target(c, 0));
    return std::abs(pull) + std::abs(c.force);
  };
  const double reach = joint.anchor.norm() + (joint.to == world ? 0 : joint.to_anchor.norm()) +
                       (first_end(joint, state).position - second_end(joint, state).position).norm();
  for (const JointDisplacement& c : joint.displacements)
    sum += slope(c, joint_displacement(joint, c.which, state)) * 2 * (e.position + reach * e.orientation);
  for (const JointAngle& c : joint.angles)
    sum += slope(c, joint_angle(joint, c.which, state)) * 2 * angle_sharpness(joint, state) * e.orientation;
  return sum;
}

double rotor_energy(const HeldJoint& joint, const State& state) {
  double sum = 0;
  for (const JointDisplacement& c : joint.displacements)
    if (has_rotor(c)) sum += c.armature / 2 * std::pow(joint_displacement_rate(joint, c.which, state), 2);
  for (const JointAngle& c : joint.angles)
    if (has_rotor(c)) sum += c.armature / 2 * std::pow(joint_angle_rate(joint, c.which, state), 2);
  return sum;
}

// dT = armature q' dq'.  Of an angle, q' = g.(w_a - w_b), both spins and g are off, |dg| <= 8 dtheta/sin^2 of a gimbal
// (angle_direction) and dtheta of the others; of a displacement,
// q' = n.(v_a - v_b - w_b x d), the velocities of both points, the spin that carries n, d and n.
double rotor_energy_error(const HeldJoint& joint, const State& state, const StateError& e) {
  const End a = first_end(joint, state), b = second_end(joint, state);
  const Vector3 d = a.position - b.position;
  const double reach = joint.anchor.norm() + (joint.to == world ? 0 : joint.to_anchor.norm());
  const double spins = a.spin.norm() + b.spin.norm();
  const double sharp = angle_sharpness(joint, state),
               of_angle = 2 * sharp * e.angular_velocity +
                          (sharp == 1 ? 1 : 8 * sharp * sharp) * spins * e.orientation;
  const double of_point = e.velocity + reach * (e.angular_velocity + spins * e.orientation);
  const double of_displacement =
      2 * of_point + d.norm() * e.angular_velocity +
      2 * b.spin.norm() * (e.position + reach * e.orientation) +
      ((a.velocity - b.velocity).norm() + b.spin.norm() * d.norm()) * e.orientation;
  double sum = 0;
  for (const JointDisplacement& c : joint.displacements)
    if (has_rotor(c))
      sum += c.armature * std::abs(joint_displacement_rate(joint, c.which, state)) * of_displacement;
  for (const JointAngle& c : joint.angles)
    if (has_rotor(c)) sum += c.armature * std::abs(joint_angle_rate(joint, c.which, state)) * of_angle;
  return sum;
}

Joint joint_at(const HeldJoint& held, const State& state) {
  const End a = first_end(held, state), b = second_end(held, state);
  const JointKind& kind = kind_of(held.type);
  Joint joint;
  joint.type = held.type;
  joint.body = held.body;
  joint.to = held.to;
  joint.name = held.name;
  // A point that both ends share is told by `to`, which does not move with the body's own errors; one that slides is
  // that of the body.
  joint.point =
      kind.place == JointPlace::along_axis || kind.place == JointPlace::in_plane ? a.position : b.position;
  if (kind.has_axis()) joint.axis = (b.orientation * held.to_axis).normalized();
  if (kind.has_second_axis())
    joint.axis_2 =
        (kind.place == JointPlace::in_plane ? b.orientation * held.to_axis_2 : a.orientation * held.axis_2)
            .normalized();
  joint.length = kind.has_length() ? (a.position - b.position).norm() : held.length;
  joint.pitch = held.pitch;
  joint.displacements = held.displacements;
  for (JointDisplacement& c : joint.displacements) c.start += joint_displacement(held, c.which, state);
  joint.angles = held.angles;
  for (JointAngle& c : joint.angles) c.start += joint_angle(held, c.which, state);
  return joint;
}

}  // namespace cylon::core
