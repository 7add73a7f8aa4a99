// Unilateral contact with Coulomb's law at several points at once, as algebra: forces and accelerations, or
// impulses and velocities.  Knows nothing of bodies.
//
// Each point has three coordinates: normal n, and tangents s, t.  With u = A f + q, A symmetric and positive
// semidefinite, Coulomb's law in the cone (not a pyramid) reads, point by point,
//   f_n >= 0,  u_n >= 0,  f_n u_n = 0,
//   |f_t| <= b + mu f_n,  and  f_t = -(b + mu f_n) u_t/|u_t|  where u_t does not vanish.
// b is zero but for dry friction that nothing presses (in a joint), which has b alone, and u_t along s alone.
// Signorini's and Coulomb's conditions as in J. J. Moreau, Unilateral contact and dry friction in finite
// freedom dynamics (1988), section 6-9.
#pragma once

#include "engine/contact/least_norm.h"
#include "engine/operations.h"
#include "engine/vector.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace cylon::engine {

using Vector2 = Eigen::Matrix<Real, 2, 1>;

enum class Grip {
  parts,   ///< No force.
  slides,  ///< f_t = -(b + mu f_n) d, d the unit direction of slip.
  sticks   ///< u_t = 0.
};

/// What holds at one point: how, and for a point that slides, where to.
struct Hold {
  Grip grip = Grip::sticks;
  Vector2 slip = Vector2::Zero();  ///< d in tangent coordinates, unit, where it slides.
  bool given = false;              ///< It slides already: d is data and not sought.
};

struct CoulombProblem {
  MatrixX response;            ///< A, 3 k x 3 k.
  VectorX offset;              ///< q, 3 k.
  std::vector<Real> error;     ///< How far q of each point may be off, k or none.
  std::vector<Real> friction;  ///< mu, k.
  std::vector<Real> bound;     ///< b, k or none.
  std::vector<int> pair;       ///< k; points of one pair share redundant forces evenly.
  std::vector<Hold> hold;      ///< k; only the holds that are given count.
  std::vector<Hold> guess;     ///< k or none: tried before anything else.
  int most_sweeps = 4000;      ///< Rounds of the iteration, the last resort.
  VectorX start;               ///< 3 k or none: held_force() departs from it as little as it can.

  Real bound_of(std::size_t i) const { return bound.empty() ? Real(0) : bound[i]; }
  Real error_of(std::size_t i) const { return error.empty() ? Real(0) : error[i]; }
};

struct CoulombSolution {
  VectorX force;           ///< f; of all that obey the law and that differ only by redundancy, an even one.
  VectorX rate;            ///< u
  std::vector<Hold> hold;  ///< What was found.
  bool exact = false;      ///< Obeys the law to rounding; otherwise as near as the iteration came:
  Real violation = 0;      ///< violation() of the force where it is not exact.
  std::int64_t operations = 0;  ///< What it took beyond the first guesses, as Stepper::operations() counts.
};

/// The force for holds that are decided: u = 0 where it sticks, u_n = 0 and f_t = -mu f_n d where it slides;
/// of several the one of least norm, or, where a start is given, the one nearest to it.  f_n may come out
/// negative: who decides again when it does is the caller. Sticking forces are shared in proportion to the
/// normal forces, so that all points come to the edge of their cones together where that is possible.
VectorX held_force(const CoulombProblem&, const std::vector<Hold>&);

/// Solves the problem.  First all points hold and those that would pull, or leave the cone, are changed one
/// by one; then those outside their cones slide; if neither ends, Gauss-Seidel over the points, each solved
/// exactly, finds the holds, and Newton's method the forces for them.  Always ends; deterministic.
CoulombSolution solve(const CoulombProblem&);

/// The force after so many rounds over the points, fewer if it stops changing: each point takes what brings its
/// normal rate to zero, not below no force, and its tangential rate as near to zero as its cone allows,
///   f_n = max(0, f_n - u_n/A_nn),   f_t = f_t - u_t/A_tt, cut to mu f_n.
/// Bounded work for any problem; near the law, not exact.
VectorX relaxed_force(const CoulombProblem&, int rounds);

/// Whether the force obeys the law for these holds, to rounding and the error of q.
bool obeys(const CoulombProblem&, const std::vector<Hold>&, const VectorX& force);

/// How far a force is from the law, in units of u: the largest over the points of
///   |f - P(f - r (u + mu |u_t| n))|/r,   r = 1/max A_ii,   P the nearest point of the cone |f_t| <= mu f_n,
/// which is zero where the law is obeyed and nowhere else.  G. De Saxce, Z.-Q. Feng, Math. Comput. Modelling 28 (1998)
/// 225.  Of a point whose slip is given f_t = -mu f_n d is required in place of Coulomb's law.  Infinite where it is
/// not a number.
Real violation(const CoulombProblem&, const VectorX& force);

}  // namespace cylon::engine
