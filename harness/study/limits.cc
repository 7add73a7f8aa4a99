#include "harness/study/limits.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <stdexcept>

namespace cylon::study {
namespace {

double middle(double a, double b, bool whole) {
  const double m = std::sqrt(a * b);
  // Of whole numbers neither end again, or bisection would not end.
  return whole ? std::clamp(std::round(m), std::min(a, b) + 1, std::max(a, b) - 1) : m;
}

// The values that are tried first, from the end that should hold to the other.
std::vector<double> ladder(const Range& range, const std::vector<double>& also) {
  const double decades = std::log10(range.high / range.low);
  const int rungs = std::max(1, static_cast<int>(std::ceil(decades * range.per_decade)));
  std::set<double> values;
  for (int i = 0; i <= rungs; ++i) {
    const double x = i == rungs ? range.high : range.low * std::pow(range.high / range.low, 1.0 * i / rungs);
    values.insert(range.whole ? std::round(x) : x);
  }
  for (const double x : also)
    if (x > range.low && x < range.high) values.insert(range.whole ? std::round(x) : x);
  std::vector<double> order(values.begin(), values.end());
  if (range.downward) std::reverse(order.begin(), order.end());
  return order;
}

bool close(const Range& range, double a, double b) {
  const double high = std::max(a, b), low = std::min(a, b);
  return range.whole ? high - low <= 1 || high <= range.closeness * low : high <= range.closeness * low;
}

}  // namespace

double Limit::value(const Range& range) const {
  if (kind == Kind::none) return holds;
  if (kind == Kind::nowhere) return breaks;
  return range.whole ? holds : std::sqrt(holds * breaks);
}

std::vector<double> just_beyond(const std::optional<double>& theory, const Range& range) {
  constexpr double beyond = 1.001;  // the narrowest known window, that of rkn4, is 0.18 % wide
  if (!theory || !(*theory * beyond > range.low) || !(*theory * beyond < range.high)) return {};
  return {*theory * beyond};
}

Limit find_limit(const Range& range, const std::function<Probed(double)>& probe,
                 const std::vector<double>& also) {
  if (!(range.low > 0) || !(range.low < range.high) || !(range.closeness > 1))
    throw std::invalid_argument("find_limit: needs 0 < low < high and closeness > 1");
  Limit limit;
  const auto ask = [&](double x) {
    ++limit.runs;
    return probe(x);
  };
  bool held = false, broken = false;
  for (const double x : ladder(range, also)) {
    const Probed found = ask(x);
    if (found.holds && broken) limit.holds_again.push_back(x);
    if (found.holds && !broken) limit.holds = x, held = true;
    if (!found.holds && !broken) limit.breaks = x, limit.what = found.what, broken = true;
  }
  if (!broken) {
    limit.kind = Limit::Kind::none;
    return limit;
  }
  if (!held) {
    limit.kind = Limit::Kind::nowhere;
    return limit;
  }
  while (!close(range, limit.holds, limit.breaks)) {
    const double x = middle(limit.holds, limit.breaks, range.whole);
    const Probed found = ask(x);
    (found.holds ? limit.holds : limit.breaks) = x;
    if (!found.holds) limit.what = found.what;
  }
  return limit;
}

Limit limit_of(const Family& family, const Runner& runner, const std::optional<double>& theory) {
  bool held = false;
  const auto probe = [&](double x) -> Probed {
    try {
      const Probed found = family.probe(runner, x);
      held = held || found.holds;
      return found;
    } catch (const RunFailed& failed) {
      if (failed.outcome.status == results::Status::unsupported && !held) throw;
      return {false, std::string(results::name(failed.outcome.status)) + ": " + failed.outcome.reason};
    }
  };
  return find_limit(family.range, probe, just_beyond(theory, family.range));
}

}  // namespace cylon::study
