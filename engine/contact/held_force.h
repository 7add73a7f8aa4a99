// The force of holds that are decided, where it is not unique: what coulomb.cc and held_force.cc share.
#pragma once

#include "engine/contact/coulomb.h"

#include <cmath>

namespace cylon::engine {

/// The first of the three rows of a point.
inline Eigen::Index first_row(std::size_t point) { return 3 * static_cast<Eigen::Index>(point); }

/// Whether it is dry friction that nothing presses.
inline bool is_dry(const CoulombProblem& p, std::size_t i) { return p.bound_of(i) > 0; }

/// How much friction a point has under a normal force: b + mu f_n.
inline Real slip_edge(const CoulombProblem& p, std::size_t i, Real normal) {
  return p.bound_of(i) + p.friction[i] * normal;
}

/// A pivot below this part of the largest follows from the others: 1e-11 in double, 1e-5 in float, which is
/// rounding times the condition of a well-posed contact (redundant ones stay at rounding itself).
inline Real dependent_pivot() { return std::pow(epsilon, Real(0.7)); }

/// Of all forces that the holds allow the one nearest to `start`; `unique`: set to whether there is one alone.
VectorX nearest_held_force(const CoulombProblem&, const std::vector<Hold>&, const VectorX& start,
                           bool* unique);

/// How far the loads leave the motion open: where the holds allow several forces, the most by which the rate of slip of a
/// point that slides changes between the force and another that presses at all points [unit of u].  0 where all
/// give one motion, as where all that touches sticks, or slides one way.  Adds to the operations what it took.
Real undecided_rate(const CoulombProblem&, const std::vector<Hold>&, const VectorX& force,
                    std::int64_t& operations);

}  // namespace cylon::engine
