#include "engine/contact/support.h"

#include "engine/contact/response.h"

#include <algorithm>
#include <limits>

namespace cylon::engine {

namespace {

constexpr Real ulp = std::numeric_limits<Real>::epsilon();

// c'' of a row under the loads alone.  a = F/m,  s.alpha = (I^-1 s).(torque - w x L)
Real free_acceleration(const Row& row, const Instant& now) {
  const auto side = [&](int body, const Vector3& spin) {
    const std::size_t i = index(body);
    Real sum = now.bodies[i].inverse_mass * row.direction.dot(now.loads[i].force);
    if (rotates(now.bodies[i])) {
      const Vector3 gyroscopic = now.kinematics[i].angular_velocity.cross(now.motion[i].angular_momentum);
      sum += spin.dot(now.loads[i].torque - gyroscopic);
    }
    return sum;
  };
  Real sum = row.bias + side(row.body, row.spin);
  if (row.to != fixed_world) sum -= side(row.to, row.to_spin);
  return sum;
}

// The part of du/dt that the velocities alone make: w_a x (x' - v_a) - w_b x (x' - v_b).
Vector3 drift_of_slip(const TouchPoint& touch, const Instant& now) {
  const auto side = [&](int body) -> Vector3 {
    const std::size_t i = index(body);
    if (!rotates(now.bodies[i])) return Vector3::Zero();
    const Kinematics& k = now.kinematics[i];
    return k.angular_velocity.cross(touch.path - k.velocity);
  };
  Vector3 sum = side(touch.body);
  if (touch.other != fixed_world) sum -= side(touch.other);
  return sum;
}

struct Assembly {
  Response response;
  VectorX free;
  CoulombProblem problem;
  std::vector<Matrix3> frames;
  std::vector<Vector3> slips;  // tangential velocity, world axes
};

Assembly assemble(std::span<const TouchPoint> touches, std::span<const Row> joints, const Instant& now) {
  Assembly a{Response(touches, joints, now.bodies, now.motion), {}, {}, {}, {}};
  const std::vector<Row>& rows = a.response.rows();
  a.free.resize(static_cast<Eigen::Index>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    a.free[static_cast<Eigen::Index>(i)] = free_acceleration(rows[i], now);
  }
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const Vector3 drift = drift_of_slip(touches[i], now);
    a.frames.push_back(contact_frame(touches[i].normal));
    a.free[row] += touches[i].curvature;
    a.free[row + 1] += a.frames.back().col(1).dot(drift);
    a.free[row + 2] += a.frames.back().col(2).dot(drift);
    const Vector3 u = relative_velocity(touches[i], now.bodies, now.motion);
    a.slips.push_back(u - touches[i].normal.dot(u) * touches[i].normal);
  }
  a.problem = coulomb_problem(a.response, touches, a.response.offset(a.free));
  return a;
}

Vector2 tangent(const Matrix3& frame, const Vector3& v) { return {frame.col(1).dot(v), frame.col(2).dot(v)}; }

Support report(const Assembly& a, std::span<const TouchPoint> touches, const std::vector<Hold>& holds,
               const VectorX& force) {
  Support support;
  support.multipliers = a.response.multipliers(a.free, force);
  support.rows = a.response.rows();
  const VectorX rate = a.problem.response * force + a.problem.offset;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index n = 3 * static_cast<Eigen::Index>(i);
    SupportPoint p;
    p.holding.grip = holds[i].grip;
    p.holding.slip = a.frames[i].col(1) * holds[i].slip.x() + a.frames[i].col(2) * holds[i].slip.y();
    p.force = a.frames[i] * force.segment<3>(n);
    p.normal = force[n];
    p.reserve = touches[i].friction * force[n] - force.segment<2>(n + 1).norm();
    p.slip_speed = a.slips[i].dot(p.holding.slip);
    p.parting = rate[n];
    support.points.push_back(p);
  }
  return support;
}

}  // namespace

Support find_support(std::span<const TouchPoint> touches, std::span<const Row> joints, const Instant& now,
                     Real slow) {
  Assembly a = assemble(touches, joints, now);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    Hold& hold = a.problem.hold[i];
    if (!(a.slips[i].norm() > slow)) continue;
    hold.given = true;
    hold.grip = Grip::slides;
    hold.slip = tangent(a.frames[i], a.slips[i]).normalized();
  }
  const CoulombSolution solution = solve(a.problem);
  Support support = report(a, touches, solution.hold, solution.force);
  support.exact = solution.exact;
  return support;
}

Support hold_support(std::span<const TouchPoint> touches, std::span<const Holding> holdings,
                     std::span<const Row> joints, const Instant& now, Real slow) {
  const Assembly a = assemble(touches, joints, now);
  std::vector<Hold> holds(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    holds[i].grip = holdings[i].grip;
    if (holds[i].grip != Grip::slides || touches[i].friction == 0) continue;
    const Real speed = a.slips[i].norm(), sense = a.slips[i].dot(holdings[i].slip);
    const Vector3 d = speed > slow ? Vector3(a.slips[i] * ((sense < 0 ? -1 : 1) / speed)) : holdings[i].slip;
    holds[i].slip = tangent(a.frames[i], d);
  }
  Support support = report(a, touches, holds, held_force(a.problem, holds));
  for (std::size_t i = 0; i < touches.size(); ++i)
    support.points[i].slip_speed = a.slips[i].dot(holdings[i].slip);
  return support;
}

void add_forces(const Support& support, Load* loads, std::size_t bodies) {
  std::vector<Load> sizes(bodies);
  for (std::size_t i = 0; i < bodies; ++i) {
    sizes[i].force = loads[i].force.cwiseAbs();
    sizes[i].torque = loads[i].torque.cwiseAbs();
  }
  std::vector<char> touched(bodies, 0);
  const auto add = [&](int body, const Vector3& force, const Vector3& torque) {
    const std::size_t i = index(body);
    touched[i] = 1;
    loads[i].force += force;
    loads[i].torque += torque;
    sizes[i].force += force.cwiseAbs();
    sizes[i].torque += torque.cwiseAbs();
  };
  for (std::size_t i = 0; i < support.rows.size(); ++i) {
    const Real l = support.multipliers[static_cast<Eigen::Index>(i)];
    const Row& row = support.rows[i];
    add(row.body, l * row.direction, l * row.lever);
    if (row.to != fixed_world) add(row.to, -l * row.direction, -l * row.to_lever);
  }
  for (std::size_t i = 0; i < bodies; ++i) {
    if (!touched[i]) continue;
    const Real force = 64 * ulp * sizes[i].force.maxCoeff(), torque = 64 * ulp * sizes[i].torque.maxCoeff();
    for (Eigen::Index k = 0; k < 3; ++k) {
      if (std::abs(loads[i].force[k]) <= force) loads[i].force[k] = 0;
      if (std::abs(loads[i].torque[k]) <= torque) loads[i].torque[k] = 0;
    }
  }
}

}  // namespace cylon::engine
