// The cheapest settings that meet a tolerance, and what each part of a scene costs.  Plain values, from which
// reports are made.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace cylon::results {

/// A setting that was run.
struct Pick {
  std::string engine, integrator;  ///< "bullet/gyro=none", "semi-implicit-euler"
  std::string at;                  ///< "5/1248 s", "tolerance 1e-04"
  std::int64_t steps = 0;
  double dt = 0, tolerance = 0;
  int substeps = 1;  ///< Parts that the engine makes of each step, each with gravity.
  double error = std::numeric_limits<double>::quiet_NaN();  ///< Worst of the starts that it was run from.
  double cost = std::numeric_limits<double>::quiet_NaN();   ///< CPU seconds per simulated second.
};

/// What is said of one engine.
struct EngineAdvice {
  std::string engine;   ///< Its row: "bullet".
  std::string version;  ///< Of what ran; "1.1.0 (WebAssembly in Node 20.20.2)" where it is no native code.
  std::optional<Pick> pick;       ///< The cheapest that meets the tolerance; nothing: not reachable.
  std::optional<Pick> runner_up;  ///< The next cheapest integrator or variant.
  std::optional<Pick> ten_times;  ///< The cheapest for a tenth of the tolerance, from the nominal start.
  std::optional<Pick> best;       ///< The least error seen, its cost not measured.
  bool over_budget = false;       ///< The pick costs more than was allowed.
  std::string reason;             ///< Why there was no run at all.
};

/// The same setting with a part of the scene, or of the engine's work, and without it.
struct FeaturePrice {
  std::string engine;                                              ///< With its variant, as the pick has it.
  std::string feature;                                             ///< "gyroscopic term", "friction", …
  double with_cost = std::numeric_limits<double>::quiet_NaN();     ///< CPU seconds per simulated second.
  double without_cost = std::numeric_limits<double>::quiet_NaN();  ///< CPU seconds per simulated second.
  double effect = std::numeric_limits<double>::quiet_NaN();  ///< Largest difference of the motions, in units
                                                             ///< of its scales, turns in rad.
  std::string reason;                                        ///< Why it could not be priced; empty: it was.
};

struct Advice {
  std::string scenario, measure, against;
  double duration = 0;   ///< [s]
  double tolerance = 0;  ///< Relative, of the measure.
  double budget = 0;     ///< CPU seconds per simulated second; 0: none.
  int starts = 1;        ///< From how many starts each pick was run, the nominal one included.
  std::vector<EngineAdvice> engines;
  std::vector<FeaturePrice> features;
};

}  // namespace cylon::results
