// What `cylon limits` found, as text, JSON and CSV.
#pragma once

#include "harness/study/limits.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::cli {

/// One family, or the step of one scenario, on one engine and integrator.
struct LimitRow {
  std::string family, asks, unit, breaks, engine, integrator;
  std::string unsupported;  ///< Why the engine cannot be asked; empty: it was.
  study::Limit limit;       ///< In the parameter's unit; of steps converted to seconds.
  double value = 0;
  std::optional<double> theory;  ///< 0: never holds; infinity: never breaks.
  bool downward = false;         ///< The least value that holds was sought.

  /// Measured over theory, where both are numbers > 0.
  std::optional<double> ratio() const;
};

std::string limits_text(const std::vector<LimitRow>&, int width);
std::string limits_json(const std::vector<LimitRow>&);
std::string limits_csv(const std::vector<LimitRow>&);

}  // namespace cylon::cli
