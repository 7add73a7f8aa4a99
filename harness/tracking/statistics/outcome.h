// What a comparison of two builds may say of one metric.
#pragma once

#include <string_view>

namespace cylon::statistics {

enum class Outcome {
  regressed,     ///< Worse by more than the threshold, confirmed.
  improved,      ///< Better by more than the threshold, confirmed.
  same,          ///< Confirmed to differ by less than the threshold.
  changed,       ///< Differs, in a metric that has no better and no worse (a hash, a count).
  more,          ///< Undecided; more samples are allowed.
  inconclusive,  ///< Undecided, and all samples that the rule allows are taken.
};

/// "regressed", "improved", "same", "changed", "more", "inconclusive".
std::string_view name(Outcome);

}  // namespace cylon::statistics
