// What a deviation is large or small against: the range of the required motion.  Nothing here depends on
// where the origin is, how the axes lie, what potential energy is zero, or which units are used; where
// nothing in a scene is fixed, not on a uniform motion of the whole either.
#pragma once

#include "harness/core/claim.h"

#include <map>
#include <mutex>
#include <vector>

namespace cylon::core {

/// The scale of a claim [the observable's unit], > 0; never taken from a run.
///
/// 1. The range of what is claimed, over the truth and up to the claim's horizon: the largest difference of
///    two of its values.  Of conserved totals the largest range of a part: the momentum of a body, the
///    kinetic energy, the potential energy of a force.
/// 2. Where none of these changes: the largest of these that have a zero of their own: speeds, momenta and
///    energies of motion, potential energies of springs and attractions.
/// 3. Where nothing moves (by 2 a body would not get a thousandth of its size far in the duration), with d the
///    size of the largest body, m its mass, T the duration, g gravity:  d, g T, m g T, m g d  and their like;
///    without gravity d/T in place of g T.
///
/// Of forces and torques of joints it is the largest in the course of the motion, and 3 where that is nothing.
///
/// For angles, 3 gives a radian.  Of gaps the scale is the diameter of the smallest body, twice its size.  Of an
/// event it is its value, of a height the range of heights.  Of a least change it is that change.  A range
/// of less than a thousandth of what would stand in its place is none: the motion is steady.
///
/// All is taken in the frame of what is fixed; where nothing is, in that of the centre of mass at t = 0.
double scale(const Claim&, const Scene&, double duration);

/// The largest |value| that the claim's observable takes, over 257 even times of the truth or at the start.
/// Numbers are rounded to a part of it; it depends on the origin.  0 for angles.
double largest_value(const Claim&, const Scene&, double duration);

/// Whether something gives the scene a state of rest: a plane, a pin, a locked body, a medium, a frame.
bool anything_fixed(const Scene&);

/// The motion that a claim without a truth of its own takes its scale from: that of another claim.
class RequiredMotion {
 public:
  /// `until`: how far the truth is to be used [s].
  RequiredMotion(Truth truth, double until);

  struct Instant {
    double time = 0;  ///< [s]
    State state;
  };
  /// At 257 times from 0 to the earlier of `until` and the truth's own, or at those of recorded data; made when
  /// first asked for.  The reference lasts as long as this.
  const std::vector<Instant>& path(double until) const;

 private:
  Truth truth_;
  double until_;
  mutable std::mutex mutex_;
  mutable std::map<double, std::vector<Instant>> paths_;  // by their end
};

}  // namespace cylon::core
