// What a comparison of two builds may say of one metric, and how sure it is.
#pragma once

#include <array>
#include <limits>
#include <string_view>

namespace cylon::statistics {

/// A closed interval; the default knows nothing.
struct Interval {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();

  bool within(double bound) const { return -bound < low && high < bound; }
};

enum class Outcome {
  regressed,     ///< Worse by more than the threshold, confirmed.
  improved,      ///< Better by more than the threshold, confirmed.
  same,          ///< Confirmed to differ by less than the threshold.
  changed,       ///< Differs, in a metric that has no better and no worse (a hash, a count).
  more,          ///< Undecided; more samples are allowed.
  inconclusive,  ///< Undecided, and all samples that the rule allows are taken.
};

/// "regressed", "improved", "same", "changed", "more", "inconclusive".
inline std::string_view name(Outcome outcome) {
  constexpr std::array names = {"regressed", "improved", "same", "changed", "more", "inconclusive"};
  return names.at(static_cast<std::size_t>(outcome));
}

}  // namespace cylon::statistics
