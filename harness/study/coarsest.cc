#include "harness/study/coarsest.h"

#include <algorithm>
#include <cmath>

namespace cylon::study {

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
