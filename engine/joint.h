// Joints, as rows of constraints.
#pragma once

#include "engine/constraint.h"

namespace cylon::engine {

/// Holds a point of one body on a point of another, or of the world; free to turn.
struct BallJoint {
  int body = 0;
  Vector3 anchor = Vector3::Zero();  ///< Body axes [m].
  int to = fixed_world;
  Vector3 to_anchor = Vector3::Zero();  ///< Axes of `to`; world coordinates where `to` is the world [m].
};

/// Adds the three rows of a ball joint.
///   c = (p_a + r_a) - (p_b + r_b) = 0,   r = R r_0
///   c'' = a_a + alpha_a x r_a + w_a x (w_a x r_a) - (the same of b) = 0
/// Solving c'' = 0 for the joint's force turns the mechanism into an ordinary differential equation that any
/// scheme can integrate: E. Hairer, G. Wanner, Solving Ordinary Differential Equations II, section VII.1,
/// index reduction.
inline void add_rows(const BallJoint& joint, const std::vector<Body>& bodies,
                     const std::vector<Motion>& motion, std::vector<Row>& rows) {
  const auto end = [&](int body, const Vector3& anchor, Vector3& arm, Vector3& place, Vector3& centripetal) {
    arm.setZero(), place = anchor, centripetal.setZero();
    if (body == fixed_world) return;
    const auto i = static_cast<std::size_t>(body);
    arm = motion[i].orientation * anchor;
    place = motion[i].position + arm;
    const Vector3 w = angular_velocity(bodies[i], motion[i]);
    centripetal = w.cross(w.cross(arm));
  };
  Vector3 r_a, r_b, x_a, x_b, turn_a, turn_b;
  end(joint.body, joint.anchor, r_a, x_a, turn_a);
  end(joint.to, joint.to_anchor, r_b, x_b, turn_b);
  for (int k = 0; k < 3; ++k) {
    const Vector3 n = Vector3::Unit(k);
    Row row;
    row.body = joint.body;
    row.to = joint.to;
    row.direction = n;
    row.lever = r_a.cross(n);
    row.to_lever = r_b.cross(n);
    row.bias = turn_a[k] - turn_b[k];
    row.offset = x_a[k] - x_b[k];
    rows.push_back(row);
  }
}

}  // namespace cylon::engine
