#include "harness/validation/differences.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cylon::validation {
namespace {

constexpr double shortest = 1e-4, longest = 0.1;  // of a parameter's range
constexpr double longer = 4, even = 0.1;          // even: ln of a ratio of informations that is no fall

// A parameter's way to longer differences.
struct Climb {
  double first = 0, length = 0, information = 0;  // of the last score
  double best = 0, fall = std::numeric_limits<double>::infinity();
  bool done = false;
};

double at(const Score& score, std::size_t j) {
  const auto k = static_cast<Eigen::Index>(j);
  return score.information(k, k);
}

std::vector<double> lengths_of(const std::vector<Climb>& all) {
  std::vector<double> lengths;
  for (const Climb& one : all) lengths.push_back(one.length);
  return lengths;
}

}  // namespace

Differences differences(Likelihood& likelihood, std::span<const double> values,
                        std::span<const double> from) {
  const std::vector<measured::Parameter>& parameters = likelihood.parameters();
  const auto range = [&](std::size_t j) { return parameters[j].high - parameters[j].low; };
  const Score first = likelihood.score(values, from);
  std::vector<Climb> all(parameters.size());
  for (std::size_t j = 0; j < all.size(); ++j)
    all[j].first = all[j].length = all[j].best =
        std::clamp(1 / std::sqrt(at(first, j)), shortest * range(j), longest * range(j));
  Score score = likelihood.score(values, lengths_of(all));
  for (std::size_t j = 0; j < all.size(); ++j) {
    all[j].information = at(score, j);
    all[j].done = !(all[j].information > 0);
  }
  const auto can_climb = [&](std::size_t j) {
    return !all[j].done && all[j].length * longer <= longest * range(j);
  };
  std::vector<double> scored = lengths_of(all);
  while (true) {
    bool any = false;
    for (std::size_t j = 0; j < all.size(); ++j)
      if (can_climb(j)) all[j].length *= longer, any = true;
    if (!any) break;
    const std::vector<double> lengths = lengths_of(all);
    score = likelihood.score(values, lengths);
    for (std::size_t j = 0; j < all.size(); ++j) {
      Climb& one = all[j];
      if (lengths[j] == scored[j]) continue;
      const double fall = std::log(one.information / at(score, j));
      const bool smooth = std::isinf(one.fall) && fall <= even;  // from the first length on
      if (std::abs(fall) < one.fall && !smooth) one.best = lengths[j], one.fall = std::abs(fall);
      one.information = at(score, j), one.done = fall <= even;
    }
    scored = lengths;
  }
  bool jumps = false;
  for (Climb& one : all) jumps = jumps || one.best > one.first, one.length = one.best;
  const std::vector<double> best = lengths_of(all);
  return {best, jumps, likelihood.score(values, best)};
}

}  // namespace cylon::validation
