#include "engine/contact/response.h"

#include <cmath>

namespace cylon::engine {

namespace {

// A body at one end of rows.
class End {
 public:
  End(int body, const std::vector<Body>& bodies, const Motion* motion) {
    if (body == fixed_world || !rotates(bodies[index(body)])) return;
    body_ = &bodies[index(body)];
    turn_ = motion[index(body)].orientation.toRotationMatrix();
  }

  // I^-1 s
  Vector3 spin(const Vector3& lever) const {
    return body_ ? inverse_inertia_times(*body_, turn_, lever) : Vector3(Vector3::Zero());
  }

 private:
  const Body* body_ = nullptr;
  Matrix3 turn_;
};

void fill_spins(Row& row, const End& body, const End& to) {
  row.spin = body.spin(row.lever);
  row.to_spin = to.spin(row.to_lever);
}

// The most that a unit multiplier on a row could move it, whichever way its bodies went without the coordinates that they
// are reduced to: |n|^2/m + |s|^2 max(1/I) of both.  What it does move may be rounding, of a row along which nothing can.
Real mobility(const Row& row, const std::vector<Body>& bodies) {
  const auto of = [&](int body, const Vector3& lever) -> Real {
    if (body == fixed_world || bodies[index(body)].locked) return 0;
    const Body& b = bodies[index(body)];
    return row.direction.squaredNorm() / b.mass + b.inverse_moments.maxCoeff() * lever.squaredNorm();
  };
  return of(row.body, row.lever) + of(row.to, row.to_lever) + yield(row);
}

}  // namespace

Matrix3 contact_frame(const Vector3& normal) {
  Matrix3 frame;
  frame.col(0) = normal;
  frame.col(1) = normal.unitOrthogonal();
  frame.col(2) = normal.cross(frame.col(1));
  return frame;
}

void append_rows(const TouchPoint& touch, const std::vector<Body>& bodies, const Motion* motion,
                 std::vector<Row>& rows) {
  const End body(touch.body, bodies, motion), to(touch.other, bodies, motion);
  if (touch.row) {
    Row none;
    none.body = touch.body;
    none.to = touch.other;
    for (int axis = 0; axis < 3; ++axis) rows.push_back(axis == touch.axis ? *touch.row : none);
    fill_spins(rows[rows.size() - 3 + static_cast<std::size_t>(touch.axis)], body, to);
    return;
  }
  const Matrix3 frame = contact_frame(touch.normal);
  const Vector3 arm = touch.position - motion[index(touch.body)].position;
  for (Eigen::Index axis = 0; axis < 3; ++axis) {
    Row row;
    row.body = touch.body;
    row.to = touch.other;
    row.direction = frame.col(axis);
    row.lever = arm.cross(row.direction);
    if (touch.other != fixed_world) {
      row.to_lever = (touch.position - motion[index(touch.other)].position).cross(row.direction);
    }
    fill_spins(row, body, to);
    rows.push_back(row);
  }
}

Response::Response(std::span<const TouchPoint> touches, std::span<const Row> joints,
                   const std::vector<Body>& bodies, const Motion* motion) {
  rows_.reserve(3 * touches.size() + joints.size());
  for (const TouchPoint& touch : touches) append_rows(touch, bodies, motion, rows_);
  contacts_ = static_cast<Eigen::Index>(rows_.size());
  for (const Row& joint : joints) {
    rows_.push_back(joint);
    fill_spins(rows_.back(), {joint.body, bodies, motion}, {joint.to, bodies, motion});
  }
  const Eigen::Index n = static_cast<Eigen::Index>(rows_.size()), m = n - contacts_;
  MatrixX g(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    for (Eigen::Index j = 0; j <= i; ++j) {
      g(i, j) = coupling(rows_[static_cast<std::size_t>(i)], rows_[static_cast<std::size_t>(j)], bodies);
      g(j, i) = g(i, j);
    }
    g(i, i) += yield(rows_[static_cast<std::size_t>(i)]);
  }
  matrix_ = g.topLeftCorner(contacts_, contacts_);
  if (m == 0) return;
  cross_ = g.topRightCorner(contacts_, m);
  // Rows of lengths and of angles in one scale, so that the rank is that of small and large bodies alike:
  //   G^+ = S (S G S)^+ S,  s_i^2 = 1/(most that the row could move)
  VectorX scale(m);
  for (Eigen::Index i = 0; i < m; ++i) {
    const Real most = mobility(rows_[static_cast<std::size_t>(contacts_ + i)], bodies);
    scale[i] = most > 0 ? 1 / std::sqrt(most) : Real(1);
  }
  const auto s = scale.asDiagonal();
  joint_inverse_ = s * LeastNorm(s * g.bottomRightCorner(m, m) * s).inverse() * s;
  matrix_ -= cross_ * joint_inverse_ * cross_.transpose();
  for (Eigen::Index i = 0; i < contacts_; ++i) {
    if (matrix_(i, i) > 64 * epsilon * g(i, i)) continue;
    matrix_.row(i).setZero(), matrix_.col(i).setZero();
    kept_.push_back(i);
  }
}

VectorX Response::offset(const VectorX& free) const {
  const Eigen::Index m = free.size() - contacts_;
  if (m == 0) return free;
  VectorX result = free.head(contacts_) - cross_ * (joint_inverse_ * free.tail(m));
  for (const Eigen::Index row : kept_) result[row] = 0;
  return result;
}

VectorX Response::multipliers(const VectorX& free, const VectorX& contact_force) const {
  const Eigen::Index m = free.size() - contacts_;
  VectorX lambda(free.size());
  lambda.head(contacts_) = contact_force;
  if (m > 0) {
    lambda.tail(m) = -(joint_inverse_ * (free.tail(m) + cross_.transpose() * contact_force));
  }
  return lambda;
}

void apply_impulses(std::span<const Row> rows, const VectorX& lambda, const std::vector<Body>& bodies,
                    Motion* motion) {
  const auto give = [&](int body, const Vector3& direction, const Vector3& lever) {
    const Body& b = bodies[index(body)];
    Motion& m = motion[index(body)];
    if (translates(b)) m.momentum += direction;
    if (rotates(b)) m.angular_momentum += lever;
  };
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Real l = lambda[static_cast<Eigen::Index>(i)];
    if (l == 0) continue;
    const Row& row = rows[i];
    give(row.body, l * row.direction, l * row.lever);
    if (row.to != fixed_world) give(row.to, -l * row.direction, -l * row.to_lever);
  }
}

CoulombProblem coulomb_problem(const Response& response, std::span<const TouchPoint> touches,
                               VectorX offset) {
  CoulombProblem problem;
  problem.response = response.matrix();
  problem.offset = std::move(offset);
  for (const TouchPoint& touch : touches) {
    problem.friction.push_back(touch.friction);
    problem.bound.push_back(touch.bound);
    problem.pair.push_back(touch.pair);
    problem.hold.emplace_back();
  }
  return problem;
}

}  // namespace cylon::engine
