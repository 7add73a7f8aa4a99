#pragma once

#include <span>
#include <vector>

namespace cylon::statistics {

/// Holm's step-down adjustment (1979, Scand. J. Stat. 6, 65): to refuse the hypotheses with adjusted p <=
/// alpha makes one wrong refusal or more with probability <= alpha, however the tests depend on each other.
/// With p_(1) <= … <= p_(m) the sorted values, adjusted_(i) = max over j <= i of min(1, (m - j + 1) p_(j)).
/// In the order of the input.  Throws std::invalid_argument on a value outside [0, 1].
std::vector<double> holm(std::span<const double> p);

}  // namespace cylon::statistics
