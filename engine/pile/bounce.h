// Restitution that gives no energy, for contacts solved directly.
#pragma once

#include "engine/pile/direct.h"

namespace cylon::engine::pile {

/// Newton's restitution with friction can give energy: T. R. Kane, D. A. Levinson, Dynamics, 1985, 5.8.  The impulses P_e
/// of a group of bodies that touch do the work, with u- before the forces of the step and u+ after,
///   W = sum P.(u- + u+)/2.
/// P without what rotors give.  Where W > 0, restitution is lowered as in engine/contact/impact.h:
///   P = P_0 + theta (P_e - P_0),  P_0 without restitution,  the greatest theta in [0, 1] with W <= 0.
/// P keeps Signorini's law for the lower restitution and, cones being convex, |P_t| <= friction P_n.
class Bounce {
 public:
  /// As Direct::solve(); Block::before is u-.
  bool solve(std::vector<Block>&, const std::vector<Body>&, std::vector<Mover>&);

  /// The largest violation that a solution left in the last call [m/s].
  double residual() const { return residual_; }

  /// As Direct's, of all solutions of the last call.
  double unsure() const { return unsure_; }

  /// As Direct's.
  std::int64_t operations() const { return direct_.operations(); }

 private:
  Direct direct_;
  double residual_ = 0, unsure_ = 0;
};

/// The greatest theta in [0, 1] with a theta^2 + b theta + c <= 0, where a + b + c > 0; 0: there is none.
Real greatest_share(Real a, Real b, Real c);

}  // namespace cylon::engine::pile
