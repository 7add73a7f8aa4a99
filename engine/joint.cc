#include "engine/joint.h"

#include "engine/coordinate.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace cylon::engine {

namespace {

Row row_of(const Joint& joint) {
  Row row;
  row.body = joint.body;
  row.to = joint.to;
  return row;
}

// Two unit vectors square to an axis.
std::array<Vector3, 2> across(const Vector3& axis) {
  const Vector3 first = axis.unitOrthogonal();
  return {first, axis.cross(first)};
}

// c = x_a - x_b,  x = p + R r_0
void add_together(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
  for (int k = 0; k < 3; ++k) {
    Row row = row_of(joint);
    row.direction = Vector3::Unit(k);
    row.lever = a.arm.cross(row.direction);
    row.to_lever = b.arm.cross(row.direction);
    row.bias = a.centripetal[k] - b.centripetal[k];
    row.offset = a.place[k] - b.place[k];
    row.rounding = 2 * epsilon * (a.place.norm() + a.arm.norm() + b.arm.norm());
    rows.push_back(row);
  }
}

// c = u.d,  d = x_a - x_b,  u carried by b
void add_square_to(const Vector3& local, const Joint& joint, const JointEnd& a, const JointEnd& b,
                   std::vector<Row>& rows) {
  Row row = row_of(joint);
  set_row_along(b.orientation * local, a, b, row);
  rows.push_back(row);
}

// c = u.h,  h carried by a, u by b:
//   s = h x u,  c' = s.(w_a - w_b),  bias = s'.(w_a - w_b),  s' = (w_a x h) x u + h x (w_b x u)
void add_square(const Vector3& h, const Vector3& u, const Joint& joint, const JointEnd& a, const JointEnd& b,
                std::vector<Row>& rows) {
  Row row = row_of(joint);
  const Vector3 change = a.angular_velocity.cross(h).cross(u) + h.cross(b.angular_velocity.cross(u));
  set_row_about(h.cross(u), change, a, b, row);
  row.offset = u.dot(h);
  row.rounding = 4 * epsilon;
  rows.push_back(row);
}

// The axis of a is square to two directions that are square to the axis of b.
void add_about_axis(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
  for (const Vector3& local : across(joint.to_axis))
    add_square(a.orientation * joint.axis, b.orientation * local, joint, a, b, rows);
}

// c = h.d - pitch angle,  the angle that of its turns for which c is nearest to zero; on the joint, where
// d is along h,  c' = h.(v_a - v_b) - pitch h.(w_a - w_b)  with v at the anchors.
void add_coupling(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
  const Vector3 h = b.orientation * joint.to_axis, change = b.angular_velocity.cross(h);
  Row row = row_of(joint), turn = row;
  set_row_along(h, a, b, row);
  set_row_about(h, change, a, b, turn);
  row.lever -= joint.pitch * turn.lever;
  row.to_lever -= joint.pitch * turn.to_lever;
  row.bias -= joint.pitch * turn.bias;
  // R_b^T R_a R_rel^T = (cos(angle/2), sin(angle/2) to_axis)
  const Quaternion turned = b.orientation.conjugate() * a.orientation * joint.relative.conjugate();
  const Real angle = 2 * std::atan2(turned.vec().dot(joint.to_axis), turned.w());
  const Real along = row.offset / joint.pitch;
  row.offset = joint.pitch * std::remainder(along - angle, 2 * std::numbers::pi_v<Real>);
  row.rounding += 8 * epsilon * std::abs(joint.pitch) * (1 + std::abs(along));
  rows.push_back(row);
}

// c = the rotation vector of R_a (R_b R_rel)^T,  c' = w_a - w_b  where c is small
void add_no_turn(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
  Quaternion error = a.orientation * (b.orientation * joint.relative).conjugate();
  if (error.w() < 0) error.coeffs() = -error.coeffs();
  for (int k = 0; k < 3; ++k) {
    Row row = row_of(joint);
    row.lever = row.to_lever = Vector3::Unit(k);
    row.offset = 2 * error.vec()[k];
    row.rounding = 4 * epsilon;
    rows.push_back(row);
  }
}

// d = x_a - x_b, n = d/|d|:  c = |d| - length,  c'' = n.(a_a - a_b) + (|d'|^2 - (n.d')^2)/|d|
void add_at_length(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
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
  row.rounding = 2 * epsilon * (a.place.norm() + b.place.norm() + joint.length);
  rows.push_back(row);
}

// c = x_a - x_b - l h x u,  h carried by b, u by a and square to it:
//   (h x u)' = (w_b x h) x u + h x (w_a x u) = h (u.w_b) - u (h.w_a),
// and its second derivative without the accelerations  h" x u + 2 h' x u' + h x u",  h" = w_b x (w_b x h).
void add_along_normal(const Joint& joint, const JointEnd& a, const JointEnd& b, std::vector<Row>& rows) {
  add_together(joint, a, b, rows);
  const Vector3 h = b.orientation * joint.to_axis, u = a.orientation * joint.axis, normal = h.cross(u);
  const Vector3 &w_a = a.angular_velocity, &w_b = b.angular_velocity, h_rate = w_b.cross(h),
                u_rate = w_a.cross(u);
  const Vector3 change = w_b.cross(h_rate).cross(u) + 2 * h_rate.cross(u_rate) + h.cross(w_a.cross(u_rate));
  for (int k = 0; k < 3; ++k) {
    Row& row = rows[rows.size() - 3 + static_cast<std::size_t>(k)];
    row.lever += joint.length * u[k] * h, row.to_lever += joint.length * h[k] * u;
    row.bias -= joint.length * change[k], row.offset -= joint.length * normal[k];
    row.rounding += 2 * epsilon * joint.length;
  }
}

}  // namespace

int row_count(Joint::Type type) {
  constexpr int of_place[] = {3, 1, 2, 1, 3},
                of_turn[] = {0, 2, 1, 3, 0};  // in the order of the enumerations
  return of_place[static_cast<std::size_t>(type.place)] + of_turn[static_cast<std::size_t>(type.turn)] +
         (type.couples ? 1 : 0);
}

void add_rows(const Joint& joint, const std::vector<Body>& bodies, const Motion* motion,
              std::vector<Row>& rows) {
  const JointEnd a = end_of(joint.body, joint.anchor, bodies, motion);
  const JointEnd b = end_of(joint.to, joint.to_anchor, bodies, motion);
  switch (joint.type.place) {
    case Joint::Place::together:
      add_together(joint, a, b, rows);
      break;
    case Joint::Place::at_length:
      add_at_length(joint, a, b, rows);
      break;
    case Joint::Place::along_axis:
      for (const Vector3& local : across(joint.to_axis)) add_square_to(local, joint, a, b, rows);
      break;
    case Joint::Place::in_plane:
      add_square_to(joint.to_axis, joint, a, b, rows);
      break;
    case Joint::Place::along_normal:
      add_along_normal(joint, a, b, rows);
      break;
  }
  switch (joint.type.turn) {
    case Joint::Turn::freely:
    case Joint::Turn::about_three_axes:
      break;
    case Joint::Turn::about_axis:
      add_about_axis(joint, a, b, rows);
      break;
    case Joint::Turn::about_two_axes:
      add_square(a.orientation * joint.axis, b.orientation * joint.to_axis, joint, a, b, rows);
      break;
    case Joint::Turn::never:
      add_no_turn(joint, a, b, rows);
      break;
  }
  if (joint.type.couples) add_coupling(joint, a, b, rows);
}

void add_rotor_rows(const Model& model, const Motion* motion, std::vector<Row>& rows) {
  for (const CoordinateLaw& law : model.forces.coordinate_laws) {
    if (law.armature == 0) continue;
    rows.push_back(row_of(law.at, model.bodies, motion));
    rows.back().rotor = law.armature;
  }
}

Misfit misfit_of_place(const Joint& joint, const Vector3& apart, const Quaternion& to) {
  switch (joint.type.place) {
    case Joint::Place::together:
    case Joint::Place::along_normal:
      break;
    case Joint::Place::at_length: {
      const Vector3 n = apart.normalized();
      return {apart - joint.length * n, n * n.transpose()};
    }
    case Joint::Place::along_axis: {
      const Vector3 n = to * joint.to_axis;
      return {apart - n.dot(apart) * n, Matrix3::Identity() - n * n.transpose()};
    }
    case Joint::Place::in_plane: {
      const Vector3 n = to * joint.to_axis;
      return {n.dot(apart) * n, n * n.transpose()};
    }
  }
  return {.error = apart};
}

Misfit misfit_of_turn(const Joint& joint, const Quaternion& body, const Quaternion& to) {
  switch (joint.type.turn) {
    case Joint::Turn::freely:
    case Joint::Turn::about_three_axes:
      return {.space = Matrix3::Zero()};
    case Joint::Turn::about_axis: {
      const Vector3 axis = body * joint.axis;
      return {(to * joint.to_axis).cross(axis), Matrix3::Identity() - axis * axis.transpose()};
    }
    case Joint::Turn::about_two_axes: {
      const Vector3 axis = body * joint.axis, to_axis = to * joint.to_axis;
      const Vector3 n = axis.cross(to_axis).normalized();
      return {axis.dot(to_axis) * n, n * n.transpose()};
    }
    case Joint::Turn::never:
      break;
  }
  const Quaternion apart = body * (to * joint.relative).conjugate();
  return {.error = (apart.w() < 0 ? -2 : 2) * apart.vec()};
}

}  // namespace cylon::engine
