// Two programs timed in turn, in pairs of neighbours, until the paired rule can say something.
#pragma once

#include "harness/results/comparison.h"
#include "harness/study/sampler.h"
#include "harness/tracking/statistics/paired_rule.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::study {

using TakeSample = std::function<Sample()>;

/// Whether the first of the two goes first in pair i: ABBA BAAB ABBA …, in which a drift of the machine that
/// is linear in time, and one that is quadratic over two fours, cancels.
bool first_goes_first(int pair);

/// The rule with looks up to `pairs` alone; the last look gets the shares of those that fall away.
/// Throws std::invalid_argument where no look is left (pairs < 8).
statistics::PairedRule up_to(statistics::PairedRule, int pairs);

class PairedTimes {
 public:
  PairedTimes(TakeSample baseline, TakeSample candidate, statistics::PairedRule rule)
      : baseline_(std::move(baseline)), candidate_(std::move(candidate)), rule_(std::move(rule)) {}

  /// Whether another pair is wanted.
  bool wants_more() const;
  /// Takes a sample of each; one that fails ends the comparison.
  void take_pair();

  const statistics::PairedResult& result() const { return result_; }
  const std::vector<double>& log_ratios() const { return log_ratios_; }
  const std::string& baseline_failure() const { return failures_[0]; }
  const std::string& candidate_failure() const { return failures_[1]; }

  /// As a row of a report.
  results::ComparedTime summary() const;

 private:
  TakeSample baseline_, candidate_;
  statistics::PairedRule rule_;
  statistics::PairedResult result_;
  std::vector<double> log_ratios_, seconds_[2];
  std::string failures_[2];
};

/// A finding of the rule, `more` counting as inconclusive.
results::Finding finding_of(statistics::Outcome);

}  // namespace cylon::study
