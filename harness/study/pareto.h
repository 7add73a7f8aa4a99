// Which of several settings nobody beats in both cost and error.  Knows numbers alone.
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace cylon::study {

struct Tradeoff {
  double cost = 0;   ///< >= 0, any unit; NaN: not known.
  double error = 0;  ///< >= 0, any unit; NaN or infinite: the run is worth nothing.
};

/// Where a point stands.
struct Standing {
  bool on_front = false;          ///< No other point is at least as good in both and better in one.
  std::optional<std::size_t> by;  ///< The cheapest point of the front that dominates it; equal points
                                  ///< do not dominate each other.  Nothing where it is no point at all.
};

/// In the order of the points; one whose cost or error is not finite is never on the front and is dominated
/// by nobody.
std::vector<Standing> pareto(std::span<const Tradeoff>);

}  // namespace cylon::study
