// What happens at an instant of impact: momenta change, configurations do not.
//
// Law.  Per point, with the velocity u of `body` against `other`, before (-) and after (+), and impulse P:
//   normal:     P_n >= 0,  u_n+ + e u_n- >= 0,  P_n (u_n+ + e u_n-) = 0;  e counts where u_n- < 0.  Newton.
//   tangential: |P_t| <= mu P_n, and P_t = -mu P_n u_t+/|u_t+| where slip remains.  Coulomb, on impulses.
// Friction is against the slip that the impact leaves, which in three dimensions need not be along the slip
// that it found; both are one where the slip only slows (a sphere, a plane problem).  All points at once,
// with the full contact matrix, normal and tangents coupled (errata 30-32).  J. J. Moreau (1988), section
// 9-11. Newton's law with friction can create energy (T. R. Kane, Stanford Mech. Alumni Newsletter (1983));
// there the restitution is lowered as far as it takes to create none: P = P_0 + theta (P_e - P_0), P_0 the
// plastic impact, the largest theta in [0, 1] that does not.
#pragma once

#include "engine/constraint.h"
#include "engine/contact/coulomb.h"
#include "engine/contact/touch.h"

#include <span>

namespace cylon::engine {

struct ImpactOutcome {
  std::vector<Vector3> impulse;  ///< On `body` of each point, sum over the instant, world axes [N s].
  std::vector<Real> approach;  ///< Of each point: the largest -u_n that it was struck with [m/s]; 0 if never.
  int turns = 0;               ///< Sequential: rounds over the pairs.
  int rounds = 0;              ///< Groups that were solved,
  std::int64_t operations = 0;  ///< and what that took of CoulombSolution::operations.
  bool exact = true;            ///< Every group obeys the law to rounding; else
  Real violation = 0;           ///< by how much the worst does not [m/s].
  bool order_counts = false;    ///< Sequential: another order of the pairs might have done something else.
  bool ended = true;            ///< Sequential: nothing approached before the rounds were over.
};

/// All the points at once.  `joints` keep their rates through the impact.  `memory`: how such an impact held
/// the points before, tried first; empty: unknown; set to how this one does.
ImpactOutcome strike_at_once(std::span<const TouchPoint>, std::span<const Row> joints,
                             const std::vector<Body>&, Motion*, std::vector<Hold>* memory = nullptr);

/// Ends all slip of points that touch and do not approach, by impulses within their cones, where there are
/// such; says whether, and else does nothing.  With u_n- = 0 the law above has the solution P = 0, which
/// leaves the slip; where friction presses what it brakes (A_nn <= mu A_nt.d) no finite force goes with that
/// slip, for the one that would keep u_n = 0 pulls or has no bound.  What is left of the law is its other
/// solution,
///   u+ = A P + u- = 0  with  |P_t| <= mu P_n:
/// forces without bound in no time.  It gives no energy: P.u- + P.A P/2 = -P.A P/2.
bool stop_slip(std::span<const TouchPoint>, std::span<const Row> joints, const std::vector<Body>&, Motion*);

/// Of strike(), in its sequential order, over the pairs.
inline constexpr int most_impact_rounds = 200;

/// The points of one instant.  Simultaneous: all at once.  Sequential: pair by pair in the order of their
/// numbers, again and again until nothing approaches faster than the solutions are sure of; after most_impact_rounds over the
/// pairs, or a bounded number of operations, all at once and plastic, so that it ends.
ImpactOutcome strike(std::span<const TouchPoint>, Impacts, std::span<const Row> joints,
                     const std::vector<Body>&, Motion*);

/// Normal speeds below this are rounding [m/s].
Real speed_rounding(const TouchPoint&, const std::vector<Body>&, const Motion*);

}  // namespace cylon::engine
