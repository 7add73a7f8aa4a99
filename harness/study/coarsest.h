// The coarsest setting of a row of them that meets an error, found with few runs.  Knows numbers alone.
#pragma once

#include <cstddef>
#include <functional>
#include <limits>
#include <map>
#include <optional>

namespace cylon::study {

/// The error of setting i of a row that goes from coarse to fine; NaN or infinite: the run is worth nothing.
using ErrorAt = std::function<double(std::size_t i)>;

struct Coarsest {
  std::optional<std::size_t> pick;  ///< The coarsest setting seen to meet the target, the next coarser one
                                    ///< being seen to miss it, or put at twice of it by the law; nothing:
                                    ///< none of those seen meets it.
  double error = std::numeric_limits<double>::quiet_NaN();  ///< Of the pick.
  std::size_t best = 0;                                     ///< The setting of the least error seen.
  double best_error = std::numeric_limits<double>::infinity();
};

/// Looks for the target along the law that each setting lowers the error by `digits` decades (> 0): guesses
/// by the last error, and halves the bracket where the law leads nowhere.  Near a floor, where errors scatter
/// about the law, all those are tried that it may have leapt over.  `seen` holds the errors known so far, and
/// gets those that are asked for.  Requires count > 0 and guess < count.
Coarsest coarsest(const ErrorAt&, std::size_t count, double target, double digits, std::size_t guess,
                  std::map<std::size_t, double>& seen);

}  // namespace cylon::study
