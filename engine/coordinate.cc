#include "engine/coordinate.h"

#include <cmath>
#include <limits>
#include <numbers>

namespace cylon::engine {

JointEnd end_of(int body, const Vector3& anchor, const std::vector<Body>& bodies, const Motion* motion) {
  JointEnd end;
  end.place = anchor;
  if (body == fixed_world) return end;
  const auto i = static_cast<std::size_t>(body);
  end.orientation = motion[i].orientation;
  end.rotation = end.orientation.toRotationMatrix();
  end.arm = end.orientation * anchor;
  end.place = motion[i].position + end.arm;
  end.angular_velocity = angular_velocity(bodies[i], motion[i]);
  end.velocity = velocity(bodies[i], motion[i]) + end.angular_velocity.cross(end.arm);
  end.centripetal = end.angular_velocity.cross(end.angular_velocity.cross(end.arm));
  return end;
}

JointEnd end_of(int body, const Vector3& anchor, const Motion* motion, const Kinematics* kinematics) {
  JointEnd end;
  end.place = anchor;
  if (body == fixed_world) return end;
  const auto i = static_cast<std::size_t>(body);
  const Kinematics& k = kinematics[i];
  end.orientation = motion[i].orientation;
  end.rotation = k.rotation;
  end.arm = k.rotation * anchor;
  end.place = motion[i].position + end.arm;
  end.angular_velocity = k.angular_velocity;
  end.velocity = k.velocity + k.angular_velocity.cross(end.arm);
  end.centripetal = k.angular_velocity.cross(k.angular_velocity.cross(end.arm));
  return end;
}

void set_row_along(const Vector3& u, const JointEnd& a, const JointEnd& b, Row& row) {
  const Vector3 d = a.place - b.place;
  const Vector3 turning = b.angular_velocity.cross(u);
  row.direction = u;
  row.lever = a.arm.cross(u);
  row.to_lever = (b.arm + d).cross(u);
  row.bias = u.dot(a.centripetal - b.centripetal) + 2 * turning.dot(a.velocity - b.velocity) +
             b.angular_velocity.cross(turning).dot(d);
  row.offset = u.dot(d);
  row.rounding = 4 * epsilon * (a.place.norm() + b.place.norm() + a.arm.norm() + b.arm.norm());
}

void set_row_about(const Vector3& h, const Vector3& change, const JointEnd& a, const JointEnd& b, Row& row) {
  row.direction.setZero();
  row.lever = row.to_lever = h;
  row.bias = change.dot(a.angular_velocity - b.angular_velocity);
}

Real nearest_turn(Real angle, Real near) {
  return near + std::remainder(angle - near, 2 * std::numbers::pi_v<Real>);
}

namespace {

// With the axis h and the mark m, of which  s = h.m  changes, and the spins w_c and w_o of who carries them:
//   azimuth       q' = g.(w_a - w_b),  g = (h - s m)/(1 - s^2)
//   inclination   q' = e.(w_a - w_b),  e = h x m/|h x m|
// and q'' has besides the same of the accelerations what their own changes add, with  h' = w_c x h,  m' = w_o x m:
//   g' = (h' - s' m - s m' + 2 s s' g)/(1 - s^2),   e' = the part of  (h x m)'/|h x m|  square to e
void set_row_of_inclined(const Coordinate& q, const Vector3& h, const Vector3& m, const JointEnd& carrier,
                         const JointEnd& other, const JointEnd& a, const JointEnd& b, Row& row) {
  const Vector3 h_rate = carrier.angular_velocity.cross(h), m_rate = other.angular_velocity.cross(m);
  const Vector3 normal = h.cross(m);
  if (q.kind == Coordinate::Kind::inclination) {
    const Real sine = normal.norm();
    const Vector3 e = normal / sine, change = (h_rate.cross(m) + h.cross(m_rate)) / sine;
    return set_row_about(e, change - e.dot(change) * e, a, b, row);
  }
  const Real s = h.dot(m), s_rate = h_rate.dot(m) + h.dot(m_rate), square = normal.squaredNorm();
  const Vector3 g = (h - s * m) / square;
  set_row_about(g, (h_rate - s_rate * m - s * m_rate + 2 * s * s_rate * g) / square, a, b, row);
}

}  // namespace

Row row_of(const Coordinate& q, const JointEnd& body, const JointEnd& to) {
  Row row;
  row.body = q.body;
  row.to = q.to;
  const JointEnd &carrier = q.on_body ? body : to, &other = q.on_body ? to : body;
  const Vector3 h = carrier.rotation * q.axis;
  if (q.kind == Coordinate::Kind::displacement) {
    set_row_along(h, body, to, row);
    row.offset += q.origin;
    return row;
  }
  const Vector3 zero = carrier.rotation * q.zero, mark = other.rotation * q.mark;
  if (q.kind == Coordinate::Kind::angle)
    set_row_about(h, carrier.angular_velocity.cross(h), body, to, row);
  else
    set_row_of_inclined(q, h, mark, carrier, other, body, to, row);
  if (q.kind == Coordinate::Kind::inclination) {
    row.offset = q.origin + std::atan2(h.cross(mark).norm(), h.dot(mark)) - q.zero_inclination;
    row.rounding = 8 * epsilon * (1 + std::abs(q.origin));
    return row;
  }
  const Real angle = std::atan2(h.cross(zero).dot(mark), zero.dot(mark));
  row.offset = nearest_turn(q.origin + (q.on_body ? -angle : angle), q.near);
  row.rounding = 8 * epsilon * (1 + std::abs(row.offset));
  return row;
}

Row row_of(const Coordinate& q, const std::vector<Body>& bodies, const Motion* motion) {
  return row_of(q, end_of(q.body, q.anchor, bodies, motion), end_of(q.to, q.to_anchor, bodies, motion));
}

Real speed_of(const Row& row, const std::vector<Body>& bodies, const Motion* motion) {
  const auto side = [&](int body, const Vector3& lever) -> Real {
    if (body == fixed_world) return 0;
    const auto i = static_cast<std::size_t>(body);
    return row.direction.dot(velocity(bodies[i], motion[i])) +
           lever.dot(angular_velocity(bodies[i], motion[i]));
  };
  return side(row.body, row.lever) - side(row.to, row.to_lever);
}

Real rate_of(const Row& row, const Kinematics* kinematics) {
  const auto side = [&](int body, const Vector3& lever) -> Real {
    if (body == fixed_world) return 0;
    const Kinematics& k = kinematics[static_cast<std::size_t>(body)];
    return row.direction.dot(k.velocity) + lever.dot(k.angular_velocity);
  };
  return side(row.body, row.lever) - side(row.to, row.to_lever);
}

}  // namespace cylon::engine
