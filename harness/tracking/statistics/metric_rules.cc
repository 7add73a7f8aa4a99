#include "harness/tracking/statistics/metric_rules.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace cylon::statistics {
namespace {

// Six digits show what the rules tell apart; seventeen tell counts apart.
std::string number(double x, int digits = 6) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, x);
  return text;
}

std::string of_to(double before, double after) {
  const int digits = number(before) == number(after) ? 17 : 6;
  return ", from " + number(before, digits) + " to " + number(after, digits);
}

std::string moved(const MetricRule& rule, double before, double after) {
  std::string text(rule.subject);
  text += after > before ? " rose" : " fell";
  if (rule.absolute > 0) return text + " by " + number(std::abs(after - before), 2) + of_to(before, after);
  if (before == 0) return text + of_to(before, after);
  return text + " by " + number(100 * std::abs(after / before - 1), 3) + " %" + of_to(before, after);
}

MetricResult judge_non_finite(const MetricRule& rule, double before, double after) {
  const bool was = std::isfinite(before), is = std::isfinite(after);
  if (was == is) return {Outcome::same, std::string(rule.subject) + " is not finite in either"};
  const std::string sentence = std::string(rule.subject) + (is ? " became finite" : " is no longer finite");
  if (rule.better == Better::neither) return {Outcome::changed, sentence + of_to(before, after)};
  return {is ? Outcome::improved : Outcome::regressed, sentence + of_to(before, after)};
}

}  // namespace

const MetricRule& rule_of(MetricKind kind) {
  return *std::find_if(metric_rules.begin(), metric_rules.end(),
                       [&](const MetricRule& rule) { return rule.kind == kind; });
}

MetricResult judge(MetricKind kind, double before, double after, double floor) {
  const MetricRule& rule = rule_of(kind);
  if (!std::isfinite(before) || !std::isfinite(after)) return judge_non_finite(rule, before, after);
  const double difference = std::abs(after - before);
  if (difference == 0) return {Outcome::same, std::string(rule.subject) + " is equal"};
  if (difference <= std::max({rule.relative * std::abs(before), rule.absolute, floor})) {
    const std::string threshold = difference <= floor ? "the rounding floor " + number(floor, 2)
                                  : rule.absolute > 0 ? number(rule.absolute)
                                                      : number(100 * rule.relative) + " %";
    return {Outcome::same, moved(rule, before, after) + ": within " + threshold};
  }
  const Outcome outcome = rule.better == Better::neither                        ? Outcome::changed
                          : (rule.better == Better::larger) == (after > before) ? Outcome::improved
                                                                                : Outcome::regressed;
  return {outcome, moved(rule, before, after)};
}

MetricResult judge_hash(std::string_view before, std::string_view after) {
  if (before == after) return {Outcome::same, "hash is equal"};
  return {Outcome::changed, "hash changed, from " + std::string(before) + " to " + std::string(after)};
}

}  // namespace cylon::statistics
