#include "harness/study/coarsest.h"

#include <algorithm>
#include <cmath>

namespace cylon::study {
namespace {

// Near a floor the law makes leaps over the few settings that serve.  The first setting between two seen ones
// that the law, from the coarser of them, puts below twice the target; nothing where none comes that near.
std::optional<std::size_t> leapt_over(const std::map<std::size_t, double>& seen, double target,
                                      double digits) {
  constexpr double near = 2;
  const bool any =
      std::any_of(seen.begin(), seen.end(), [&](const auto& s) { return s.second <= near * target; });
  if (!any) return std::nullopt;
  for (auto finer = seen.begin(), coarser = finer++; finer != seen.end(); coarser = finer++) {
    const auto [from, error] = *coarser;
    if (!std::isfinite(error)) continue;
    const double further = std::max(1.0, std::ceil(std::log10(error / (near * target)) / digits));
    if (further < static_cast<double>(finer->first - from)) return from + static_cast<std::size_t>(further);
  }
  return std::nullopt;
}

}  // namespace

Coarsest coarsest(const ErrorAt& error_at, std::size_t count, double target, double digits, std::size_t guess,
                  std::map<std::size_t, double>& seen) {
  // Settings up to `bad` miss the target as far as seen, `good` meets it; both may lie outside the row.
  std::ptrdiff_t bad = -1, good = static_cast<std::ptrdiff_t>(count);
  std::ptrdiff_t at = static_cast<std::ptrdiff_t>(guess);
  std::ptrdiff_t reach = 1;  // doubles while nothing serves: at a floor the law asks for small steps for ever
  for (bool halve = false; good - bad > 1; halve = !halve) {
    const auto index = static_cast<std::size_t>(at);
    if (!seen.contains(index)) seen[index] = error_at(index);
    const double error = seen[index];
    (error <= target ? good : bad) = at;
    // log10(error/target)/digits settings further, and as far as a lost run asks for.
    constexpr double leap = 24;
    double shift = std::isfinite(error) && error > 0 ? std::log10(error / target) / digits
                   : error == 0                      ? -leap
                                                     : leap / 3;
    shift = std::clamp(shift, -leap, leap);
    const bool open = bad < 0 || good == static_cast<std::ptrdiff_t>(count);
    if (good == static_cast<std::ptrdiff_t>(count)) shift = std::max(shift, static_cast<double>(reach));
    reach *= 2;
    at = halve && !open ? (bad + good) / 2 : at + static_cast<std::ptrdiff_t>(std::ceil(shift));
    at = std::clamp(at, bad + 1, good - 1);
  }
  while (good == static_cast<std::ptrdiff_t>(count)) {
    const auto between = leapt_over(seen, target, digits);
    if (!between) break;
    seen[*between] = error_at(*between);
    if (seen[*between] <= target) good = static_cast<std::ptrdiff_t>(*between);
  }
  Coarsest result;
  for (const auto& [i, error] : seen)
    if (error < result.best_error) result.best = i, result.best_error = error;
  if (good < static_cast<std::ptrdiff_t>(count)) {
    result.pick = static_cast<std::size_t>(good);
    result.error = seen[*result.pick];
  }
  return result;
}

}  // namespace cylon::study
