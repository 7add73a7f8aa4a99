#include "harness/study/paired_times.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace cylon::study {
namespace {

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

bool first_goes_first(int pair) { return pair % 4 == 0 || pair % 4 == 3; }

statistics::PairedRule up_to(statistics::PairedRule rule, int pairs) {
  if (pairs < 8) throw std::invalid_argument("a paired comparison needs 8 pairs or more");
  std::vector<statistics::PairedRule::Look> looks;
  double spent = 0;
  for (const auto& look : rule.looks) {
    if (look.pairs >= pairs) break;
    looks.push_back(look);
    spent += look.share;
  }
  looks.push_back({pairs, 1 - spent});
  rule.looks = std::move(looks);
  return rule;
}

bool PairedTimes::wants_more() const {
  return failures_[0].empty() && failures_[1].empty() && result_.outcome == statistics::Outcome::more;
}

void PairedTimes::take_pair() {
  double seconds[2] = {0, 0};
  const int first = first_goes_first(static_cast<int>(log_ratios_.size())) ? 0 : 1;
  for (const int side : {first, 1 - first}) {
    const Sample sample = side == 0 ? baseline_() : candidate_();
    if (!sample.failure.empty()) {
      failures_[side] = sample.failure;
      return;
    }
    seconds[side] = sample.seconds;
  }
  for (const int side : {0, 1}) seconds_[side].push_back(seconds[side]);
  log_ratios_.push_back(std::log(seconds[1] / seconds[0]));
  result_ = statistics::decide(log_ratios_, rule_);
}

results::ComparedTime PairedTimes::summary() const {
  results::ComparedTime time;
  time.finding = finding_of(result_.outcome);
  time.ratio = std::exp(result_.estimate);
  time.low = std::exp(result_.interval.low), time.high = std::exp(result_.interval.high);
  time.confidence = result_.confidence;
  time.pairs = static_cast<int>(log_ratios_.size());
  time.p = std::min(result_.p_regressed, result_.p_improved);
  time.adjusted = time.p;
  time.baseline_seconds = median(seconds_[0]), time.candidate_seconds = median(seconds_[1]);
  return time;
}

results::Finding finding_of(statistics::Outcome outcome) {
  switch (outcome) {
    case statistics::Outcome::regressed:
      return results::Finding::regressed;
    case statistics::Outcome::improved:
      return results::Finding::improved;
    case statistics::Outcome::same:
      return results::Finding::same;
    case statistics::Outcome::changed:
      return results::Finding::changed;
    case statistics::Outcome::more:
    case statistics::Outcome::inconclusive:
      break;
  }
  return results::Finding::inconclusive;
}

}  // namespace cylon::study
