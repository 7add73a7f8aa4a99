#include "engine/joint.h"

#include <limits>

namespace cylon::engine {

namespace {

// One end of a joint: the arm to its anchor, where that is, how it moves, and the part of its acceleration
// that the spin makes,  a = a_0 + alpha x r + w x (w x r).
struct End {
  Vector3 arm = Vector3::Zero(), place, velocity = Vector3::Zero(), centripetal = Vector3::Zero();
  Vector3 angular_velocity = Vector3::Zero();
  Quaternion orientation = Quaternion::Identity();
};

End end_of(int body, const Vector3& anchor, const std::vector<Body>& bodies, const Motion* motion) {
  if (body == fixed_world) return {.place = anchor};
  const auto i = static_cast<std::size_t>(body);
  End end;
  end.orientation = motion[i].orientation;
  end.arm = end.orientation * anchor;
  end.place = motion[i].position + end.arm;
  end.angular_velocity = angular_velocity(bodies[i], motion[i]);
  end.velocity = velocity(bodies[i], motion[i]) + end.angular_velocity.cross(end.arm);
  end.centripetal = end.angular_velocity.cross(end.angular_velocity.cross(end.arm));
  return end;
}

constexpr Real ulp = std::numeric_limits<Real>::epsilon();

Row row_of(const Joint& joint) {
  Row row;
  row.body = joint.body;
  row.to = joint.to;
  return row;
}

// c = x_a - x_b,  x = p + R r_0
void add_together(const Joint& joint, const End& a, const End& b, std::vector<Row>& rows) {
  for (int k = 0; k < 3; ++k) {
    Row row = row_of(joint);
    row.direction = Vector3::Unit(k);
    row.lever = a.arm.cross(row.direction);
    row.to_lever = b.arm.cross(row.direction);
    row.bias = a.centripetal[k] - b.centripetal[k];
    row.offset = a.place[k] - b.place[k];
    row.rounding = 2 * ulp * (a.place.norm() + a.arm.norm() + b.arm.norm());
    rows.push_back(row);
  }
}

// c = u.h_a for two u of body b square to its axis, h_a the axis on a.
//   s = h x u,  c' = s.(w_a - w_b),  bias = s'.(w_a - w_b),  s' = (w_a x h) x u + h x (w_b x u)
void add_about_axis(const Joint& joint, const End& a, const End& b, std::vector<Row>& rows) {
  const Vector3 h = a.orientation * joint.axis;
  const Vector3 first = joint.to_axis.unitOrthogonal(), second = joint.to_axis.cross(first);
  const Vector3 w = a.angular_velocity - b.angular_velocity;
  for (const Vector3& local : {first, second}) {
    const Vector3 u = b.orientation * local;
    Row row = row_of(joint);
    row.lever = row.to_lever = h.cross(u);
    const Vector3 change = a.angular_velocity.cross(h).cross(u) + h.cross(b.angular_velocity.cross(u));
    row.bias = change.dot(w);
    row.offset = u.dot(h);
    row.rounding = 4 * ulp;
    rows.push_back(row);
  }
}

// c = the rotation vector of R_a (R_b R_rel)^T,  c' = w_a - w_b  where c is small
void add_no_turn(const Joint& joint, const End& a, const End& b, std::vector<Row>& rows) {
  Quaternion error = a.orientation * (b.orientation * joint.relative).conjugate();
  if (error.w() < 0) error.coeffs() = -error.coeffs();
  for (int k = 0; k < 3; ++k) {
    Row row = row_of(joint);
    row.lever = row.to_lever = Vector3::Unit(k);
    row.offset = 2 * error.vec()[k];
    row.rounding = 4 * ulp;
    rows.push_back(row);
  }
}

// d = x_a - x_b, n = d/|d|:  c = |d| - length,  c'' = n.(a_a - a_b) + (|d'|^2 - (n.d')^2)/|d|
void add_at_length(const Joint& joint, const End& a, const End& b, std::vector<Row>& rows) {
  const Vector3 d = a.place - b.place, v = a.velocity - b.velocity;
  const Real distance = d.norm();
  Row row = row_of(joint);
  row.direction = distance > 0 ? Vector3(d / distance) : Vector3(Vector3::UnitY());
  row.lever = a.arm.cross(row.direction);
  row.to_lever = b.arm.cross(row.direction);
  const Real closing = row.direction.dot(v);
  row.bias = row.direction.dot(a.centripetal - b.centripetal);
  if (distance > 0) row.bias += (v.squaredNorm() - closing * closing) / distance;
  row.offset = distance - joint.length;
  row.rounding = 2 * ulp * (a.place.norm() + b.place.norm() + joint.length);
  rows.push_back(row);
}

}  // namespace

int row_count(Joint::Type type) {
  constexpr int of_place[] = {3, 1}, of_turn[] = {0, 2, 3};  // in the order of the enumerations
  return of_place[static_cast<std::size_t>(type.place)] + of_turn[static_cast<std::size_t>(type.turn)];
}

void add_rows(const Joint& joint, const std::vector<Body>& bodies, const Motion* motion,
              std::vector<Row>& rows) {
  const End a = end_of(joint.body, joint.anchor, bodies, motion);
  const End b = end_of(joint.to, joint.to_anchor, bodies, motion);
  switch (joint.type.place) {
    case Joint::Place::together:
      add_together(joint, a, b, rows);
      break;
    case Joint::Place::at_length:
      add_at_length(joint, a, b, rows);
      break;
  }
  switch (joint.type.turn) {
    case Joint::Turn::freely:
      break;
    case Joint::Turn::about_axis:
      add_about_axis(joint, a, b, rows);
      break;
    case Joint::Turn::never:
      add_no_turn(joint, a, b, rows);
      break;
  }
}

Misfit misfit_of_place(const Joint& joint, const Vector3& apart) {
  switch (joint.type.place) {
    case Joint::Place::together:
      break;
    case Joint::Place::at_length: {
      const Vector3 n = apart.normalized();
      return {apart - joint.length * n, n * n.transpose()};
    }
  }
  return {.error = apart};
}

Misfit misfit_of_turn(const Joint& joint, const Quaternion& body, const Quaternion& to) {
  switch (joint.type.turn) {
    case Joint::Turn::freely:
      return {.space = Matrix3::Zero()};
    case Joint::Turn::about_axis: {
      const Vector3 axis = body * joint.axis;
      return {(to * joint.to_axis).cross(axis), Matrix3::Identity() - axis * axis.transpose()};
    }
    case Joint::Turn::never:
      break;
  }
  const Quaternion apart = body * (to * joint.relative).conjugate();
  return {.error = (apart.w() < 0 ? -2 : 2) * apart.vec()};
}

}  // namespace cylon::engine
