// Bodies that overlap are moved apart, all pairs at once.  The velocities stay as they are.
#pragma once

#include "engine/pile/body_contacts.h"
#include "engine/pile/direct.h"

#include <vector>

namespace cylon::engine::pile {

/// Moves and turns the bodies by the smallest displacement, in the measure of their masses, that takes
/// `share` of each overlap deeper than `slop` [m] away and closes no gap:
///   d = (displacements, turns) minimises d.M d/2 subject to n.d >= share depth,  or depth where depth <= 0
/// `direct`: solved to rounding, the same whatever the order of bodies and blocks; else by sweeps.  Joints
/// stay closed to first order.  The common centre of mass stays; the angular momentum does not: p x K changes
/// by d x K.  False where nothing was to be done: no overlap is
/// deeper than `slop` by a thousandth of it and the rounding of the places.
class Overlaps {
 public:
  /// Of an overlap, what a displacement removes: all up to `at_once` [m], and no less than `part` of it.
  struct Share {
    Real part, at_once;
  };
  bool displace(const std::vector<Body>&, const std::vector<Block>&, const std::vector<Mover>&, Real slop,
                Share, bool direct, std::vector<Motion>&);

  /// How far the last displacement is from the one that is wanted, where that is more than a thousandth of
  /// the slop [m]; else 0.
  Real residual() const { return residual_; }

  /// Of all displacements so far (Stepper::operations()).
  std::int64_t operations() const { return swept_ + direct_.operations(); }

 private:
  std::vector<Block> blocks_;
  std::vector<Mover> movers_;
  Direct direct_;
  Real residual_ = 0;
  std::int64_t swept_ = 0;  // contacts, over all sweeps
};

}  // namespace cylon::engine::pile
