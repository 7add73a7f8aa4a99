// Since which revision a series is at another level: E-divisive means, as Otava (once Hunter) uses it.
#pragma once

#include "harness/tracking/statistics/outcome.h"

#include <cstddef>
#include <span>
#include <vector>

namespace cylon::statistics {

struct ChangePointRule {
  std::size_t window = 50;      ///< Values that are looked at together; >= 2 shortest.
  std::size_t shortest = 4;     ///< Values that a level has at least; >= 2.
  double max_p = 0.001;         ///< A change point is kept where p is below.
  double min_magnitude = 0.02;  ///< And |ratio after / before| is at least 1 + this.
};

struct ChangePoint {
  std::size_t index;  ///< Of the first value at the new level.
  double magnitude;   ///< Difference of the means after and before, of logarithms: ln(after / before).
  Interval interval;  ///< Of the magnitude, 99 %.
  double p;           ///< Of one level before and after, the cut being the best of all.
};

/// The change points of a series of log ratios, in order.
///
/// Top down (Matteson and James 2014): cut a window where the energy statistic is largest, over all cuts and
/// all ends of the part behind the cut, so that a level that returns to the one before is seen; go on in both
/// parts while the cut is significant at ten times max_p; windows overlap by half.  Bottom up (Fleming and
/// others, "Hunter", ICPE 2023): drop the weakest point, the one of largest p or else of smallest magnitude,
/// and test its neighbours again over their longer parts, until all that are left pass max_p and
/// min_magnitude.
///
/// The significance of a cut is Student's t test between its two parts, as in Hunter: E-divisive only
/// proposes. The permutation test of the first paper gives another answer on every run, and no p below 1 /
/// permutations. Two departures from Hunter, whose p forgets that the cut was chosen among many: p is
/// multiplied by the number of places where the cut could have been; and a level has four values at least, so
/// that it is seen with its fourth revision, and two stray values at the end are no level.
///
/// Deterministic; O(N window^2).  Throws std::invalid_argument on a value that is not finite.
std::vector<ChangePoint> change_points(std::span<const double> log_ratios, const ChangePointRule& = {});

}  // namespace cylon::statistics
