// Two bodies on a joint of any kind, in general places, with velocities that it allows.
#pragma once

#include "tests/engine/fixtures.h"

#include <array>
#include <cmath>

namespace cylon::engine {

struct JointKind {
  const char* name;
  Joint::Type type;
};
inline void PrintTo(const JointKind& kind, std::ostream* out) { *out << kind.name; }

inline constexpr JointKind joint_kinds[] = {{"slider", joint_types::slider},
                                            {"cylindrical", joint_types::cylindrical},
                                            {"planar", joint_types::planar},
                                            {"universal", joint_types::universal},
                                            {"screw", joint_types::screw},
                                            {"gimbal", joint_types::gimbal},
                                            {"rectangular", joint_types::rectangular},
                                            {"offset_universal", joint_types::offset_universal}};

/// The three angles of a gimbal, counted from the start: first, second, third.
inline std::array<Coordinate, 3> gimbal_angles(const Model& model, const Joint& joint) {
  const auto turn = [&](int body) {
    return body == fixed_world ? Quaternion(Quaternion::Identity())
                               : model.motions[static_cast<std::size_t>(body)].orientation;
  };
  const Vector3 h = joint.to_axis, u = joint.axis,
                h_on_body = turn(joint.body).conjugate() * (turn(joint.to) * h),
                u_on_to = turn(joint.to).conjugate() * (turn(joint.body) * u);
  Coordinate all;
  all.body = joint.body, all.anchor = joint.anchor, all.to = joint.to, all.to_anchor = joint.to_anchor;
  Coordinate first = all, second = all, third = all;
  first.kind = second.kind = Coordinate::Kind::azimuth, third.kind = Coordinate::Kind::inclination;
  first.axis = third.axis = h, first.mark = third.mark = u;
  first.zero = (u_on_to - h.dot(u_on_to) * h).normalized();
  second.on_body = true, second.axis = u, second.mark = h;
  second.zero = (h_on_body - u.dot(h_on_body) * u).normalized();
  third.zero_inclination = std::atan2(h.cross(u_on_to).norm(), h.dot(u_on_to));
  return {first, second, third};
}

/// The joint of a scene, and the axes that it has at t = 0, in the world.
struct JointScene {
  Model model;
  Vector3 axis, second;

  const Joint& joint() const { return model.joints[0]; }

  /// An angle about the joint's axis, or where `about_second` about that of the body; zero at the start.
  Coordinate angle(bool about_second = false) const {
    if (joint().type == joint_types::gimbal) return gimbal_angles(model, joint())[about_second ? 1 : 0];
    const Quaternion q_a = model.motions[0].orientation, q_b = to_world();
    Coordinate c = ends(Coordinate::Kind::angle);
    const Vector3 h = about_second ? second : axis, zero = about_second ? axis : second;
    c.on_body = about_second;
    c.axis = (about_second ? q_a : q_b).conjugate() * h;
    c.zero = (about_second ? q_a : q_b).conjugate() * zero;
    c.mark = (about_second ? q_b : q_a).conjugate() * zero;
    return c;
  }
  /// How far the body's anchor is from the other along a world axis.
  Coordinate displacement(const Vector3& along) const {
    Coordinate c = ends(Coordinate::Kind::displacement);
    c.axis = to_world().conjugate() * along;
    return c;
  }
  /// An angle that the joint leaves free, or else a displacement, at 0.3 m.
  Coordinate free_one() const {
    if (joint().type.turn != Joint::Turn::never) return angle();
    return displacement(joint().type.place == Joint::Place::in_plane ? second : axis);
  }

 private:
  Quaternion to_world() const {
    return joint().to == fixed_world ? Quaternion(Quaternion::Identity())
                                     : model.motions[static_cast<std::size_t>(joint().to)].orientation;
  }
  Coordinate ends(Coordinate::Kind kind) const {
    Coordinate c;
    c.kind = kind;
    c.body = joint().body, c.anchor = joint().anchor;
    c.to = joint().to, c.to_anchor = joint().to_anchor;
    return c;
  }
};

inline JointScene joint_scene(Joint::Type type, bool to_world) {
  JointScene s;
  const Vector3 anchor = {0.3, -0.2, 0.1}, to_anchor = {-0.4, 0.1, 0.2}, turn_a = {0.5, 1.1, -0.6},
                turn_b = {-1.3, 0.2, 0.8}, place = {0.4, 0.9, -0.3};
  s.axis = Vector3(0.3, -0.5, 0.8).normalized(), s.second = s.axis.unitOrthogonal();
  const Vector3 third = s.axis.cross(s.second);
  const Quaternion q_a = exponential(turn_a),
                   q_b = to_world ? Quaternion(Quaternion::Identity()) : exponential(turn_b);
  Joint j;
  j.type = type, j.body = 0, j.anchor = anchor;
  j.to = to_world ? fixed_world : 1, j.to_anchor = to_world ? place : to_anchor;
  j.to_axis = q_b.conjugate() * s.axis;
  if (type == joint_types::gimbal) s.second = Real(0.8) * s.second + Real(0.6) * s.axis;
  const bool two = type.turn == Joint::Turn::about_two_axes || type == joint_types::gimbal;
  j.axis = q_a.conjugate() * (two ? s.second : s.axis);
  j.relative = q_b.conjugate() * q_a;

  const Vector3 v_b = to_world ? Vector3(0, 0, 0) : Vector3(-0.4, 0.1, 0.6),
                w_b = to_world ? Vector3(0, 0, 0) : Vector3(-0.8, 1.5, 0.4);
  Vector3 apart = {0, 0, 0}, slip = {0, 0, 0}, spin = {0, 0, 0};
  if (type.turn == Joint::Turn::about_axis) spin = 1.7 * s.axis;
  if (type.turn == Joint::Turn::about_two_axes) spin = 1.1 * s.axis - 0.8 * s.second;
  if (type == joint_types::gimbal) spin = Vector3(1.1 * s.axis - 0.8 * s.second + 0.3 * third);
  if (type.place == Joint::Place::along_axis) apart = 0.3 * s.axis, slip = 0.6 * s.axis;
  if (type.place == Joint::Place::in_plane)
    apart = 0.3 * s.second - 0.2 * third, slip = 0.4 * s.second + 0.5 * third;
  if (type.place == Joint::Place::along_normal) {  // which the turn about the first axis carries
    j.length = Real(0.25), apart = j.length * third;
    slip = (Real(1.1) * s.axis).cross(apart);
  }
  if (type.couples) {
    j.pitch = 0.15;
    slip = 1.7 * j.pitch * s.axis;
    j.relative = exponential(Vector3(-0.3 / j.pitch * j.to_axis)) * j.relative;
  }
  const Vector3 p_b = place - q_b * to_anchor, at = place + apart, arm = q_a * anchor, w_a = w_b + spin;
  const Vector3 v_at = (to_world ? Vector3(0, 0, 0) : Vector3(v_b + w_b.cross(at - p_b))) + slip;
  add_body(s.model, make_body(1.3, general_inertia(0.05, 0.07, 0.1)), at - arm, turn_a, v_at - w_a.cross(arm),
           w_a);
  if (!to_world) add_body(s.model, make_body(0.8, general_inertia(0.02, 0.035, 0.04)), p_b, turn_b, v_b, w_b);
  s.model.joints.push_back(j);
  return s;
}

/// A gimbal with springs on the angles about both axes, and a spin of its body that turns these towards each other.
inline Model gimbal_towards_parallel(bool to_world, Real towards, Real about_axis, Real stiffness) {
  JointScene s = joint_scene(joint_types::gimbal, to_world);
  for (const bool about_second : {false, true}) {
    CoordinateLaw law;
    law.at = s.angle(about_second), law.stiffness = stiffness;
    s.model.forces.coordinate_laws.push_back(law), stiffness *= Real(0.7);
  }
  const Vector3 third = s.axis.cross(s.second).normalized(), spin = towards * third + about_axis * s.axis;
  const auto set_spin = [&](std::size_t i, const Vector3& velocity, const Vector3& w) {
    Motion& m = s.model.motions[i];
    m = make_motion(s.model.bodies[i], m.position, m.orientation, velocity, w);
  };
  set_spin(0, (s.model.motions[0].orientation * s.joint().anchor).cross(spin), spin);
  if (!to_world) set_spin(1, Vector3::Zero(), Vector3::Zero());
  return s.model;
}

/// value + amplitude cos(frequency t + phase)
inline Target harmonic(Real value, Real amplitude, Real frequency, Real phase) {
  Target target;
  target.value = value, target.amplitude = amplitude;
  target.frequency = frequency, target.phase = phase;
  return target;
}

/// How far a joint is from what it keeps, from its definition alone; lengths and angles mixed.
inline Real opened(const std::vector<Motion>& motions, const Joint& joint) {
  const auto turn = [&](int body) -> Quaternion {
    if (body == fixed_world) return Quaternion::Identity();
    return motions[static_cast<std::size_t>(body)].orientation;
  };
  const Vector3 d = place(motions, joint.body, joint.anchor) - place(motions, joint.to, joint.to_anchor);
  const Vector3 h = turn(joint.to) * joint.to_axis, own = turn(joint.body) * joint.axis;
  Real gap = 0;
  switch (joint.type.place) {
    case Joint::Place::together:
      gap = d.norm();
      break;
    case Joint::Place::at_length:
      gap = std::abs(d.norm() - joint.length);
      break;
    case Joint::Place::along_axis:
      gap = d.cross(h).norm();
      break;
    case Joint::Place::in_plane:
      gap = std::abs(d.dot(h));
      break;
    case Joint::Place::along_normal:
      gap = (d - joint.length * h.cross(own)).norm();
      break;
  }
  switch (joint.type.turn) {
    case Joint::Turn::freely:
    case Joint::Turn::about_three_axes:
      break;
    case Joint::Turn::about_axis:
      gap = std::max(gap, angle_between(own, h));
      break;
    case Joint::Turn::about_two_axes:
      gap = std::max(gap, std::abs(own.dot(h)));
      break;
    case Joint::Turn::never:
      gap = std::max(gap, angle(turn(joint.body), turn(joint.to) * joint.relative));
      break;
  }
  if (joint.type.couples) {  // turned back by what its displacement says, the body has not turned
    const Quaternion back = exponential(Vector3(-d.dot(h) / joint.pitch * h));
    gap = std::max(gap, angle(back * turn(joint.body), turn(joint.to) * joint.relative));
  }
  return gap;
}

/// y' = f(t, y) by so many steps of the classical Runge-Kutta scheme: independent of the engine.
template <class Rate>
std::vector<double> small_steps(std::vector<double> y, double from, double to, int steps, Rate f) {
  const double h = (to - from) / steps;
  const auto plus = [&](const std::vector<double>& k, double part) {
    std::vector<double> z = y;
    for (std::size_t i = 0; i < y.size(); ++i) z[i] += part * k[i];
    return z;
  };
  for (int n = 0; n < steps; ++n) {
    const double t = from + n * h;
    const auto k1 = f(t, y), k2 = f(t + h / 2, plus(k1, h / 2)), k3 = f(t + h / 2, plus(k2, h / 2)),
               k4 = f(t + h, plus(k3, h));
    for (std::size_t i = 0; i < y.size(); ++i) y[i] += h / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
  }
  return y;
}

}  // namespace cylon::engine
