// Motions that are smooth between events: impacts, the end of slip.  A solution with contacts gives such a
// course, and this file turns it into a Truth with a bound on its error.
#pragma once

#include "harness/core/truth.h"
#include "reference/exact/wide.h"

#include <functional>
#include <string_view>
#include <vector>

namespace cylon::exact {

/// The state s [s] after a piece began; smooth, and defined a little before and after the piece as well.
using Motion = std::function<WideState(Wide s)>;

/// v' = acceleration and w' = spin_up, constant vectors: p = p0 + v0 s + a s^2/2, w = w0 + spin_up s.  The
/// orientation solves q' = (w0 + spin_up s) q/2: a rotation about one axis where the two are parallel, else
/// the Taylor series of this linear equation, whose coefficients follow from one another.
Motion uniform_motion(const WideState& start, const WideVector& acceleration, const WideVector& spin_up);

struct Piece {
  Wide start = 0;  ///< [s]
  Motion motion;
};

/// The motion of one body.
class Track {
 public:
  void add(Wide start, Motion motion) { pieces_.push_back({start, std::move(motion)}); }

  /// By the last piece that has started.
  WideState at(Wide t) const;

  const std::vector<Piece>& pieces() const { return pieces_; }

 private:
  std::vector<Piece> pieces_;
};

/// The motion of a scene: a track for each body, and its events in order of time.
struct Course {
  std::vector<Track> tracks;
  std::vector<core::Event> events;
};

/// Events are searched up to this multiple of the horizon, so that one at its very end is not lost.
constexpr Wide beyond = 1 + 1e-6L;

/// A solution without its domain checks.
using SolveCourse = std::function<Course(const core::Scene&)>;

/// The course of `scene` as a Truth.  Its bound is that of rounding.h, piece by piece:
///
///     error = 8 eps max |X| + 2 eps sum_p (max |p dX/dp| of p growing + the same of p shrinking)
///
/// with X the state within the same piece, so that `velocity` and `angular_velocity` hold away from events by
/// `time`, the error of the events' times; positions hold throughout (a jump of velocity times `time` is
/// added).  Derivatives are differences over 1e-10 p, in 80 bits.  Throws core::OutOfDomain where so small a
/// change makes other events happen, or in another order: no bound can be stated there.
core::Truth truth_of(std::string_view solution, const core::Scene&, const SolveCourse&, double horizon,
                     std::string source);

/// Throws core::OutOfDomain unless the centres of the bodies i and j stay a thousandth more than `reach` [m]
/// apart.
void check_apart(std::string_view solution, const core::Scene&, const Course&, int i, int j, double reach,
                 double horizon);

}  // namespace cylon::exact
