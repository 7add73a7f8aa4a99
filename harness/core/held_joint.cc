#include "harness/core/held_joint.h"

#include <cmath>
#include <numbers>

namespace cylon::core {
namespace {

struct End {
  Vector3 position = Vector3::Zero();  // of the anchor [m]
  Vector3 arm = Vector3::Zero();       // from the centre of mass [m]
  Quaternion orientation = Quaternion::Identity();
};

End end_of(const State& state, int body, const Vector3& anchor) {
  if (body == world) return {anchor, Vector3::Zero(), Quaternion::Identity()};
  const BodyState& s = state[static_cast<std::size_t>(body)];
  const Vector3 arm = s.orientation * anchor;
  return {s.position + arm, arm, s.orientation};
}

// Where a joint holds one of its ends: axes of the body, or a point of the world.
Vector3 held_point(const Scene& scene, const Joint& joint, int end) {
  if (end == world) return end == joint.body ? held_point_of_body(joint) : joint.point;
  const BodyState& s = scene.bodies[static_cast<std::size_t>(end)].initial;
  if (kind_of(joint.type).joins_centres()) return Vector3::Zero();
  const Vector3 point = end == joint.body ? held_point_of_body(joint) : joint.point;
  return s.orientation.conjugate() * (point - s.position);
}

Vector3 rotation_vector(Quaternion q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine > 0 ? Vector3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vector3(Vector3::Zero());
}

// How `body` has turned against `to` since t = 0, in world axes.
Quaternion turned(const HeldJoint& j, const End& a, const End& b) {
  return a.orientation * (b.orientation * j.turn).conjugate();
}

// c = n.d, d = x_a - x_b, with n fixed in b:  c' = n.(v_a - v_b) + (r_a x n).w_a - ((r_b + d) x n).w_b
JointRow carried(const HeldJoint& j, const End& a, const End& b, const Vector3& n) {
  const Vector3 apart = a.position - b.position;
  const double scale = a.position.norm() + a.arm.norm() + b.position.norm() + b.arm.norm();
  return {j.body, j.to, n, a.arm.cross(n), (b.arm + apart).cross(n), n.dot(apart), scale};
}

void add_carried(const HeldJoint& j, const End& a, const End& b, const Vector3& n,
                 std::vector<JointRow>& rows) {
  rows.push_back(carried(j, a, b, n));
}

void add_place(const HeldJoint& j, const End& a, const End& b, std::vector<JointRow>& rows) {
  const Vector3 apart = a.position - b.position;
  const double scale = a.position.norm() + a.arm.norm() + b.position.norm() + b.arm.norm();
  const auto add = [&](const Vector3& n, double gap) {
    rows.push_back({j.body, j.to, n, a.arm.cross(n), b.arm.cross(n), gap, scale});
  };
  switch (kind_of(j.type).place) {
    case JointPlace::together:
      for (int k = 0; k < 3; ++k) add(Vector3::Unit(k), apart[k]);
      return;
    case JointPlace::at_length: {
      const double length = apart.norm();
      add(length > 0 ? Vector3(apart / length) : Vector3(Vector3::UnitY()), length - j.length);
      return;
    }
    case JointPlace::along_axis: {
      const Vector3 axis = b.orientation * j.to_axis, one = axis.unitOrthogonal();
      add_carried(j, a, b, one, rows);
      add_carried(j, a, b, axis.cross(one), rows);
      return;
    }
    case JointPlace::in_plane:
      add_carried(j, a, b, b.orientation * j.to_axis, rows);
      return;
    case JointPlace::along_normal: {
      // c = d - l h x u:  with h.u = 0,  (h x u)' = (w_b x h) x u + h x (w_a x u) = h (u.w_b) - u (h.w_a)
      const Vector3 h = b.orientation * j.to_axis, u = a.orientation * j.axis_2;
      const Vector3 off = apart - j.length * h.cross(u);
      for (int k = 0; k < 3; ++k) {
        add(Vector3::Unit(k), off[k]);
        rows.back().spin += j.length * u[k] * h, rows.back().to_spin += j.length * h[k] * u;
      }
      return;
    }
  }
}

void add_turn(const HeldJoint& j, const End& a, const End& b, std::vector<JointRow>& rows) {
  const auto add = [&](const Vector3& about, const Vector3& error) {
    rows.push_back({j.body, j.to, Vector3::Zero(), about, about, about.dot(error), 1});
  };
  switch (kind_of(j.type).turn) {
    case JointTurn::freely:
    case JointTurn::about_three_axes:
      return;
    case JointTurn::about_axis: {
      const Vector3 axis = a.orientation * j.axis, error = (b.orientation * j.to_axis).cross(axis);
      const Vector3 one = axis.unitOrthogonal();
      add(one, error);
      add(axis.cross(one), error);
      return;
    }
    case JointTurn::never: {
      const Vector3 error = rotation_vector(turned(j, a, b));
      for (int k = 0; k < 3; ++k) add(Vector3::Unit(k), error);
      return;
    }
    case JointTurn::about_two_axes: {
      // c = u.h, u fixed in b, h in a:  c' = (h x u).(w_a - w_b)
      const Vector3 u = b.orientation * j.to_axis, h = a.orientation * j.axis_2, about = h.cross(u);
      rows.push_back({j.body, j.to, Vector3::Zero(), about, about, u.dot(h), 1});
      return;
    }
  }
}

// The rotation vector's part about the axis, of a turn about it alone, in (-pi, pi].
double twist(const Quaternion& turn, const Vector3& axis) {
  const double angle = 2 * std::atan2(turn.vec().dot(axis), turn.w());
  return std::remainder(angle, 2 * std::numbers::pi);
}

// What the displacement of a screw is off by; its angle is known up to whole turns, and the nearest counts.
double unscrewed(double displacement, double angle, double pitch) {
  const double turn = 2 * std::numbers::pi * pitch;
  return std::remainder(displacement - pitch * angle, turn);
}

// c = axis.d - pitch angle
void add_screw(const HeldJoint& j, const End& a, const End& b, std::vector<JointRow>& rows) {
  if (!kind_of(j.type).screws) return;
  const Vector3 axis = b.orientation * j.to_axis;
  JointRow row = carried(j, a, b, axis);
  row.gap = unscrewed(row.gap, twist(turned(j, a, b), axis), j.pitch);
  row.spin -= j.pitch * axis;
  row.to_spin -= j.pitch * axis;
  rows.push_back(row);
}

Quaternion turn_at_start(const Scene& scene, int body) {
  if (body == world) return Quaternion::Identity();
  return scene.bodies[static_cast<std::size_t>(body)].initial.orientation;
}

}  // namespace

Vector3 held_point_of_body(const Joint& joint) {
  if (kind_of(joint.type).place != JointPlace::along_normal) return joint.point;
  return joint.point + joint.length * joint.axis.cross(joint.axis_2.value_or(Vector3::UnitX()));
}

HeldJoint held_joint(const Scene& scene, const Joint& joint) {
  const auto in_axes_of = [&](int body, const Vector3& axis) {
    return body == world ? axis : Vector3(turn_at_start(scene, body).conjugate() * axis);
  };
  const Vector3 axis_2 = joint.axis_2.value_or(Vector3::UnitX());
  return {.type = joint.type,
          .body = joint.body,
          .to = joint.to,
          .anchor = held_point(scene, joint, joint.body),
          .to_anchor = held_point(scene, joint, joint.to),
          .axis = in_axes_of(joint.body, joint.axis),
          .to_axis = in_axes_of(joint.to, joint.axis),
          .turn = turn_at_start(scene, joint.to).conjugate() * turn_at_start(scene, joint.body),
          .length = joint.length,
          .axis_2 = in_axes_of(joint.body, axis_2),
          .to_axis_2 = in_axes_of(joint.to, axis_2),
          .pitch = joint.pitch,
          .name = joint.name,
          .displacements = joint.displacements,
          .angles = joint.angles};
}

std::vector<HeldJoint> held_joints(const Scene& scene) {
  std::vector<HeldJoint> held;
  for (const Joint& joint : scene.joints) held.push_back(held_joint(scene, joint));
  return held;
}

void add_rows(const HeldJoint& joint, const State& state, std::vector<JointRow>& rows) {
  const End a = end_of(state, joint.body, joint.anchor), b = end_of(state, joint.to, joint.to_anchor);
  add_place(joint, a, b, rows);
  add_turn(joint, a, b, rows);
  add_screw(joint, a, b, rows);
}

double open_by(const Scene& scene, const Joint& joint, const State& state) {
  const HeldJoint held = held_joint(scene, joint);
  const End a = end_of(state, held.body, held.anchor), b = end_of(state, held.to, held.to_anchor);
  const Vector3 apart = a.position - b.position, axis = b.orientation * held.to_axis;
  const JointKind& kind = kind_of(joint.type);
  switch (kind.place) {
    case JointPlace::together:
      break;
    case JointPlace::at_length:
      return apart.norm() - joint.length;
    case JointPlace::along_axis: {
      const double along = axis.dot(apart), off = (apart - along * axis).norm();
      return kind.screws ? std::hypot(off, unscrewed(along, twist(turned(held, a, b), axis), held.pitch))
                         : off;
    }
    case JointPlace::in_plane:
      return std::abs(axis.dot(apart));
    case JointPlace::along_normal:
      return (apart - held.length * axis.cross(a.orientation * held.axis_2)).norm();
  }
  return apart.norm();
}

double turned_by(const Scene& scene, const Joint& joint, const State& state) {
  const HeldJoint held = held_joint(scene, joint);
  const End a = end_of(state, held.body, held.anchor), b = end_of(state, held.to, held.to_anchor);
  switch (kind_of(joint.type).turn) {
    case JointTurn::freely:
    case JointTurn::about_three_axes:
      break;
    case JointTurn::about_axis: {
      const Vector3 ours = a.orientation * held.axis, theirs = b.orientation * held.to_axis;
      return std::atan2(ours.cross(theirs).norm(), ours.dot(theirs));
    }
    case JointTurn::never:
      return rotation_vector(turned(held, a, b)).norm();
    case JointTurn::about_two_axes: {
      const Vector3 ours = a.orientation * held.axis_2, theirs = b.orientation * held.to_axis;
      return std::abs(std::atan2(ours.dot(theirs), ours.cross(theirs).norm()));
    }
  }
  return 0;
}

RelativeMotion forbidden(const Joint& joint, const Vector3& apart, const RelativeMotion& motion) {
  const JointKind& kind = kind_of(joint.type);
  const Vector3 &v = motion.velocity, &w = motion.spin, &axis = joint.axis;
  const auto along = [](const Vector3& line, const Vector3& x) { return Vector3(line * line.dot(x)); };
  RelativeMotion part{v, w};
  switch (kind.place) {
    case JointPlace::together:
      break;
    case JointPlace::at_length:
      part.velocity = along(apart.normalized(), v);
      break;
    case JointPlace::along_axis:
      part.velocity -= along(axis, v);
      if (kind.screws) part.velocity += along(axis, v) - joint.pitch * along(axis, w);
      break;
    case JointPlace::in_plane:
      part.velocity = along(axis, v);
      break;
    case JointPlace::along_normal: {  // the point of `body` turns about `axis`, at a distance from it
      const Vector3 normal = axis.cross(joint.axis_2.value_or(Vector3::UnitX()));
      part.velocity -= axis.dot(w) * axis.cross(joint.length * normal);
      break;
    }
  }
  switch (kind.turn) {
    case JointTurn::freely:
    case JointTurn::about_three_axes:
      part.spin = Vector3::Zero();
      break;
    case JointTurn::about_axis:
      part.spin -= along(axis, w);
      break;
    case JointTurn::never:
      break;
    case JointTurn::about_two_axes:
      part.spin = along(axis.cross(joint.axis_2.value_or(Vector3::UnitX())), w);
      break;
  }
  return part;
}

}  // namespace cylon::core
