#include "engine/contact/contact_force.h"

#include "engine/contact/held_force.h"
#include "engine/contact/response.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// c'' of a row under the loads alone.  a = (F - m' v)/m,  s.alpha = (I^-1 s).(torque - w x L)
Real free_acceleration(const Row& row, const Instant& now) {
  const auto side = [&](int body, const Vector3& spin) {
    const std::size_t i = index(body);
    const Vector3 force = accelerating(now.bodies[i], now.kinematics[i], now.loads[i]);
    Real sum = now.bodies[i].inverse_mass * row.direction.dot(force);
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

// |n| (|F| + |T|/k)/m + |I^-1 s| (|T| + k |F|) of both ends of a row, k the radius of gyration.
Real pulled(const Row& row, const Instant& now) {
  const auto side = [&](int body, const Vector3& spin) {
    const std::size_t i = index(body);
    const Real force = now.loads[i].force.norm(), torque = now.loads[i].torque.norm();
    const Real k = gyration(now.bodies[i]);
    return now.bodies[i].inverse_mass * row.direction.norm() * (force + (k > 0 ? torque / k : Real(0))) +
           spin.norm() * (torque + k * force);
  };
  return side(row.body, row.spin) + (row.to != fixed_world ? side(row.to, row.to_spin) : Real(0));
}

// The part of du/dt that the velocities alone make: w_a x (x' - v_a) - w_b x (x' - v_b).
Vector3 drift_of_slip(const TouchPoint& touch, const Instant& now) {
  if (touch.row) return Vector3::Zero();  // its row has a bias
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
  a.frames.reserve(touches.size()), a.slips.reserve(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index row = 3 * static_cast<Eigen::Index>(i);
    const Vector3 drift = drift_of_slip(touches[i], now);
    a.frames.push_back(contact_frame(touches[i].normal));
    a.free[row] += touches[i].curvature;
    a.free[row + 1] += a.frames.back().col(1).dot(drift);
    a.free[row + 2] += a.frames.back().col(2).dot(drift);
    const Vector3 u = relative_velocity(touches[i], now.bodies, now.motion);
    a.slips.emplace_back(u - touches[i].normal.dot(u) * touches[i].normal);
  }
  a.problem = coulomb_problem(a.response, touches, a.response.offset(a.free));
  return a;
}

Vector2 tangent(const Matrix3& frame, const Vector3& v) { return {frame.col(1).dot(v), frame.col(2).dot(v)}; }

// Takes the rows.
ContactForces report(Assembly& a, std::span<const TouchPoint> touches, const std::vector<Hold>& holds,
                     const VectorX& force) {
  ContactForces support;
  support.multipliers = a.response.multipliers(a.free, force);
  support.rows = a.response.take_rows();
  support.points.reserve(touches.size());
  const VectorX rate = a.problem.response * force + a.problem.offset;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    const Eigen::Index n = 3 * static_cast<Eigen::Index>(i);
    ContactForce p;
    p.holding.grip = holds[i].grip;
    p.holding.slip = a.frames[i].col(1) * holds[i].slip.x() + a.frames[i].col(2) * holds[i].slip.y();
    p.force = a.frames[i] * force.segment<3>(n);
    p.normal = force[n];
    p.reserve = touches[i].bound + touches[i].friction * force[n] - force.segment<2>(n + 1).norm();
    p.slip_speed = a.slips[i].dot(p.holding.slip);
    p.parting = rate[n];
    p.of_joint = touches[i].row.has_value();
    p.bound = touches[i].bound;
    support.points.push_back(p);
  }
  return support;
}

// Slip that counts as none is left in the velocities until they are projected, and turns with the bodies: w x u.  Where
// points hold a body more often than it can move, the accelerations that keep them do not go together by as much.
Real drift_of_rest(const Assembly& a, std::span<const TouchPoint> touches, const Instant& now) {
  Real sum = 0;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (touches[i].row || a.problem.hold[i].given) continue;
    Real turn = now.kinematics[index(touches[i].body)].angular_velocity.norm();
    if (touches[i].other != fixed_world)
      turn += now.kinematics[index(touches[i].other)].angular_velocity.norm();
    sum += turn * a.slips[i].norm();
  }
  return sum;
}

// The shares of the holdings as the start of the problem's forces, if there are any.
void start_from(CoulombProblem& problem, const std::vector<Matrix3>& frames,
                std::span<const Holding> holdings) {
  if (std::all_of(holdings.begin(), holdings.end(), [](const Holding& h) { return h.share.isZero(0); }))
    return;
  problem.start.resize(problem.offset.size());
  for (std::size_t i = 0; i < frames.size(); ++i)
    problem.start.segment<3>(3 * static_cast<Eigen::Index>(i)) = frames[i].transpose() * holdings[i].share;
}

// A point at the edge of its cone that does not begin to move sticks: slip along a direction that it does not
// take would be followed without end.
void stick_where_still(const CoulombProblem& problem, CoulombSolution& solution) {
  std::vector<Hold> holds = solution.hold;
  bool any = false;
  for (std::size_t i = 0; i < holds.size(); ++i) {
    if (holds[i].grip != Grip::slides || holds[i].given) continue;
    if (!(problem.friction[i] > 0 || problem.bound_of(i) > 0)) continue;
    Hold still = holds[i];
    still.grip = Grip::sticks;
    std::swap(still, holds[i]);
    if (obeys(problem, holds, solution.force))
      any = true;
    else
      std::swap(still, holds[i]);
  }
  if (any) solution.hold = std::move(holds);
}

struct Sums {
  std::vector<Load> loads, sizes;  // sums, and sums of the absolute values of their terms
  std::vector<char> touched;
};

// Where a coordinate of a joint holds a body, its dry friction is a size of forces, and what is rounding of a force is
// rounding of a torque too: joints carry the one by the other.
void add_sizes_of_joints(const ContactForces& support, std::span<const Body> bodies, Sums& sums) {
  const auto add = [&](int body, const Vector3& force, const Vector3& torque) {
    const std::size_t i = index(body);
    if (i >= sums.sizes.size()) return;
    Load& size = sums.sizes[i];
    size.force += force.cwiseAbs(), size.torque += torque.cwiseAbs();
    const Real radius = rotates(bodies[i]) ? gyration(bodies[i]) : Real(0), largest = size.force.maxCoeff();
    if (!(radius > 0)) return;
    size.force.array() += size.torque.maxCoeff() / radius;
    size.torque.array() += radius * largest;
  };
  for (std::size_t i = 0; i < support.points.size(); ++i) {
    if (!support.points[i].of_joint) continue;
    const Real bound = support.points[i].bound;
    const Row& row = support.rows[3 * i + (bound > 0 ? 1 : 0)];
    add(row.body, bound * row.direction, bound * row.lever);
    if (row.to != fixed_world) add(row.to, bound * row.direction, bound * row.to_lever);
  }
}

Sums sum_forces(const ContactForces& support, std::span<const Body> bodies, const Load* loads,
                std::size_t count) {
  Sums sums{{loads, loads + count}, std::vector<Load>(count), std::vector<char>(count, 0)};
  for (std::size_t i = 0; i < count; ++i) {
    sums.sizes[i].force = loads[i].force.cwiseAbs();
    sums.sizes[i].torque = loads[i].torque.cwiseAbs();
  }
  const auto add = [&](int body, const Vector3& force, const Vector3& torque) {
    const std::size_t i = index(body);
    if (i >= count) return;
    sums.touched[i] = 1;
    sums.loads[i].force += force;
    sums.loads[i].torque += torque;
    sums.sizes[i].force += force.cwiseAbs();
    sums.sizes[i].torque += torque.cwiseAbs();
  };
  for (std::size_t i = 0; i < support.rows.size(); ++i) {
    const Real l = support.multipliers[static_cast<Eigen::Index>(i)];
    const Row& row = support.rows[i];
    add(row.body, l * row.direction, l * row.lever);
    if (row.to != fixed_world) add(row.to, -l * row.direction, -l * row.to_lever);
  }
  add_sizes_of_joints(support, bodies, sums);
  return sums;
}

}  // namespace

ContactForces find_contact_forces(std::span<const TouchPoint> touches, std::span<const Row> joints,
                                  const Instant& now, std::span<const Real> slow,
                                  std::span<const Holding> guess) {
  Assembly a = assemble(touches, joints, now);
  for (std::size_t i = 0; i < touches.size(); ++i) {
    Hold& hold = a.problem.hold[i];
    if (!(a.slips[i].norm() > slow[i])) continue;
    hold.given = true;
    hold.grip = Grip::slides;
    hold.slip = tangent(a.frames[i], a.slips[i]).normalized();
  }
  for (std::size_t i = 0; i < guess.size(); ++i) {
    a.problem.guess.push_back(a.problem.hold[i]);
    if (a.problem.hold[i].given) continue;
    const bool dry = touches[i].bound > 0, parts = guess[i].grip == Grip::parts && !dry;
    a.problem.guess.back().grip = (touches[i].friction > 0 || dry) && !parts ? Grip::sticks
                                  : parts                                    ? Grip::parts
                                                                             : Grip::slides;
  }
  a.problem.error.assign(touches.size(), drift_of_rest(a, touches, now));
  start_from(a.problem, a.frames, guess);
  a.problem.most_sweeps = 200;
  CoulombSolution solution = solve(a.problem);
  if (solution.exact) stick_where_still(a.problem, solution);
  const Real undecided = solution.exact
                             ? undecided_rate(a.problem, solution.hold, solution.force, solution.operations)
                             : Real(0);
  ContactForces support = report(a, touches, solution.hold, solution.force);
  support.exact = solution.exact;
  support.violation = solution.violation;
  support.undecided = undecided;
  support.operations = solution.operations;
  // What an even sharing would leave outside a cone is remembered as it was found.
  a.problem.start.resize(0);
  if (!solution.exact || obeys(a.problem, solution.hold, held_force(a.problem, solution.hold)))
    return support;
  for (ContactForce& point : support.points) point.holding.share = point.force;
  return support;
}

ContactForces held_contact_forces(std::span<const TouchPoint> touches, std::span<const Holding> holdings,
                                  std::span<const Row> joints, const Instant& now, Real slow) {
  Assembly a = assemble(touches, joints, now);
  start_from(a.problem, a.frames, holdings);
  std::vector<Hold> holds(touches.size());
  for (std::size_t i = 0; i < touches.size(); ++i) {
    holds[i].grip = holdings[i].grip;
    if (holds[i].grip != Grip::slides || (touches[i].friction == 0 && touches[i].bound == 0)) continue;
    if (touches[i].row) {
      holds[i].slip = tangent(a.frames[i], holdings[i].slip);
      continue;
    }
    // d = w/|w|,  w = u - s d_0 + sqrt(s^2 + slow^2) d_0,  s = u.d_0
    const Vector3& d_0 = holdings[i].slip;
    const Real s = a.slips[i].dot(d_0);
    const Vector3 d = (a.slips[i] + (std::hypot(s, slow) - s) * d_0).normalized();
    holds[i].slip = tangent(a.frames[i], d);
  }
  // Beyond the end of a contact, where only trials go, what pulls does not rub: friction that grew with the
  // pull would run away before the end is found.
  VectorX force = held_force(a.problem, holds);
  bool pulls = false;
  for (std::size_t i = 0; i < touches.size(); ++i) {
    if (holds[i].grip != Grip::slides || !(force[3 * static_cast<Eigen::Index>(i)] < 0)) continue;
    pulls = pulls || a.problem.friction[i] > 0;
    a.problem.friction[i] = 0;
  }
  if (pulls) force = held_force(a.problem, holds);
  ContactForces support = report(a, touches, holds, force);
  for (std::size_t i = 0; i < touches.size(); ++i)
    support.points[i].slip_speed = a.slips[i].dot(holdings[i].slip);
  return support;
}

Real pull_of(const TouchPoint& coordinate, const Instant& now) {
  const Response response({&coordinate, 1}, {}, now.bodies, now.motion);
  const auto at = static_cast<std::size_t>(coordinate.axis);
  const auto own = static_cast<Eigen::Index>(at);
  return pulled(response.rows()[at], now) + coordinate.bound * response.matrix()(own, own);
}

std::vector<Real> free_partings(std::span<const TouchPoint> touches, std::span<const Row> joints,
                                const Instant& now) {
  const Assembly a = assemble(touches, joints, now);
  std::vector<Real> result;
  for (std::size_t i = 0; i < touches.size(); ++i)
    result.push_back(a.problem.offset[3 * static_cast<Eigen::Index>(i)]);
  return result;
}

bool balanced(const ContactForces& support, const Instant& now) {
  const Sums sums = sum_forces(support, now.bodies, now.loads, now.count);
  const auto vanishes = [](const Vector3& sum, const Vector3& size) {
    return sum.cwiseAbs().maxCoeff() <= 1024 * epsilon * size.maxCoeff();
  };
  for (std::size_t i = 0; i < now.count; ++i) {
    const Body& body = now.bodies[i];
    if (translates(body) && !vanishes(sums.loads[i].force, sums.sizes[i].force)) return false;
    if (rotates(body) && !vanishes(sums.loads[i].torque, sums.sizes[i].torque)) return false;
  }
  return true;
}

void add_forces(const ContactForces& support, std::span<const Body> bodies, Load* loads, std::size_t count) {
  const Sums sums = sum_forces(support, bodies, loads, count);
  const auto cleared = [](const Vector3& sum, const Vector3& size) {
    const Real rounding = 64 * epsilon * size.maxCoeff();
    return Vector3(sum.unaryExpr([rounding](Real x) { return std::abs(x) <= rounding ? Real(0) : x; }));
  };
  for (std::size_t i = 0; i < count; ++i) {
    if (!sums.touched[i]) continue;
    loads[i].force = cleared(sums.loads[i].force, sums.sizes[i].force);
    loads[i].torque = cleared(sums.loads[i].torque, sums.sizes[i].torque);
  }
}

}  // namespace cylon::engine
