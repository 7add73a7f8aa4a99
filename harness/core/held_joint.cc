#include "harness/core/held_joint.h"

#include "harness/core/anchor.h"

#include <cmath>

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
  if (end == world) return joint.point;
  const BodyState& s = scene.bodies[static_cast<std::size_t>(end)].initial;
  switch (kind_of(joint.type).place) {
    case JointPlace::together:
      return s.orientation.conjugate() * (joint.point - s.position);
    case JointPlace::at_length:
      break;
  }
  return Vector3::Zero();
}

Vector3 rotation_vector(Quaternion q) {
  if (q.w() < 0) q.coeffs() = -q.coeffs();
  const double sine = q.vec().norm();
  return sine > 0 ? Vector3(2 * std::atan2(sine, q.w()) / sine * q.vec()) : Vector3(Vector3::Zero());
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
  }
}

void add_turn(const HeldJoint& j, const End& a, const End& b, std::vector<JointRow>& rows) {
  const auto add = [&](const Vector3& about, const Vector3& error) {
    rows.push_back({j.body, j.to, Vector3::Zero(), about, about, about.dot(error), 1});
  };
  switch (kind_of(j.type).turn) {
    case JointTurn::freely:
      return;
    case JointTurn::about_axis: {
      const Vector3 axis = a.orientation * j.axis, error = (b.orientation * j.to_axis).cross(axis);
      const Vector3 one = axis.unitOrthogonal();
      add(one, error);
      add(axis.cross(one), error);
      return;
    }
    case JointTurn::never: {
      const Vector3 error = rotation_vector(a.orientation * (b.orientation * j.turn).conjugate());
      for (int k = 0; k < 3; ++k) add(Vector3::Unit(k), error);
      return;
    }
  }
}

Quaternion turn_at_start(const Scene& scene, int body) {
  if (body == world) return Quaternion::Identity();
  return scene.bodies[static_cast<std::size_t>(body)].initial.orientation;
}

Quaternion turn_now(const State& state, int body) {
  if (body == world) return Quaternion::Identity();
  return state[static_cast<std::size_t>(body)].orientation;
}

}  // namespace

std::vector<HeldJoint> held_joints(const Scene& scene) {
  std::vector<HeldJoint> held;
  const auto turn_of = [&](int body) { return turn_at_start(scene, body); };
  for (const Joint& joint : scene.joints) {
    const auto in_axes_of = [&](int body) {
      return body == world ? joint.axis : Vector3(turn_of(body).conjugate() * joint.axis);
    };
    held.push_back({.type = joint.type,
                    .body = joint.body,
                    .to = joint.to,
                    .anchor = held_point(scene, joint, joint.body),
                    .to_anchor = held_point(scene, joint, joint.to),
                    .axis = in_axes_of(joint.body),
                    .to_axis = in_axes_of(joint.to),
                    .turn = turn_of(joint.to).conjugate() * turn_of(joint.body),
                    .length = joint.length});
  }
  return held;
}

void add_rows(const HeldJoint& joint, const State& state, std::vector<JointRow>& rows) {
  const End a = end_of(state, joint.body, joint.anchor), b = end_of(state, joint.to, joint.to_anchor);
  add_place(joint, a, b, rows);
  add_turn(joint, a, b, rows);
}

double open_by(const Scene& scene, const Joint& joint, const State& state) {
  const double apart = (anchor(state, joint.to, held_point(scene, joint, joint.to)) -
                        anchor(state, joint.body, held_point(scene, joint, joint.body)))
                           .norm();
  switch (kind_of(joint.type).place) {
    case JointPlace::together:
      break;
    case JointPlace::at_length:
      return apart - joint.length;
  }
  return apart;
}

double turned_by(const Scene& scene, const Joint& joint, const State& state) {
  // How a body has turned since the start, in world axes.
  const auto since = [&](int body) {
    return Quaternion(turn_now(state, body) * turn_at_start(scene, body).conjugate());
  };
  const Quaternion ours = since(joint.body), theirs = since(joint.to);
  switch (kind_of(joint.type).turn) {
    case JointTurn::freely:
      break;
    case JointTurn::about_axis: {
      const Vector3 a = ours * joint.axis, b = theirs * joint.axis;
      return std::atan2(a.cross(b).norm(), a.dot(b));
    }
    case JointTurn::never:
      return rotation_vector(theirs.conjugate() * ours).norm();
  }
  return 0;
}

Vector3 forbidden_velocity(JointPlace place, const Vector3& apart, const Vector3& v) {
  switch (place) {
    case JointPlace::together:
      break;
    case JointPlace::at_length: {
      const Vector3 line = apart.normalized();
      return line * line.dot(v);
    }
  }
  return v;
}

Vector3 forbidden_spin(JointTurn turn, const Vector3& axis, const Vector3& w) {
  switch (turn) {
    case JointTurn::freely:
      return Vector3::Zero();
    case JointTurn::about_axis:
      return w - axis * axis.dot(w);
    case JointTurn::never:
      break;
  }
  return w;
}

}  // namespace cylon::core
