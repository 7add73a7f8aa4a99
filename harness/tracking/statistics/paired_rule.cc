#include "harness/tracking/statistics/paired_rule.h"

#include "harness/tracking/statistics/hodges_lehmann.h"
#include "harness/tracking/statistics/signed_rank.h"

#include <algorithm>
#include <cmath>

namespace cylon::statistics {
PairedResult decide(std::span<const double> log_ratios, const PairedRule& rule) {
  const double margin = std::log1p(rule.tau);
  PairedResult result;
  result.estimate = hodges_lehmann(log_ratios);
  for (const PairedRule::Look& at : rule.looks) {
    result.next = at.pairs;
    if (log_ratios.size() < static_cast<std::size_t>(at.pairs)) return result;
    const auto d = log_ratios.first(static_cast<std::size_t>(at.pairs));
    const double level = at.share * rule.alpha;
    const double slower = p_above(d, margin) / at.share, faster = p_below(d, -margin) / at.share;
    result.pairs = at.pairs;
    result.p_regressed = std::min(result.p_regressed, slower);
    result.p_improved = std::min(result.p_improved, faster);
    result.estimate = hodges_lehmann(d);
    result.interval = hodges_lehmann_interval(d, level);
    result.confidence = 1 - 2 * level;
    result.outcome = slower <= rule.alpha             ? Outcome::regressed
                     : faster <= rule.alpha           ? Outcome::improved
                     : result.interval.within(margin) ? Outcome::same
                                                      : Outcome::more;
    if (result.outcome != Outcome::more) break;
  }
  if (result.outcome == Outcome::more) result.outcome = Outcome::inconclusive;
  result.next = 0;
  return result;
}

}  // namespace cylon::statistics
