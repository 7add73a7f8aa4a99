// What the conformance tests share: the shipped scenarios and suites, the engines of this build, and one
// claim of a scenario on one engine.  Everything runs through the workers, as `cylon run` does.
#pragma once

#include "harness/process/engines.h"
#include "harness/scenario/expected.h"
#include "harness/scenario/input.h"
#include "harness/scenario/scenario.h"
#include "harness/scenario/suite.h"
#include "harness/study/cell.h"
#include "tests/paths.h"

#include <algorithm>
#include <filesystem>
#include <stdexcept>
#include <string>

namespace cylon::conformance {

inline std::filesystem::path source(const std::string& path) {
  return std::filesystem::path(source_dir) / path;
}

inline scenario::Scenario shipped(const std::string& name) {
  for (const char* folder : {"extremes/", "validation/"})
    if (const auto file = source(std::string("scenarios/") + folder + name + ".toml");
        std::filesystem::exists(file))
      return scenario::load(file);
  return scenario::load(source("scenarios/" + name + ".toml"));
}

inline process::EngineChoice engine(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

/// A claim of the scenario's own scene and truth: the quantity, unjudged, over [0, duration].
/// Throws std::invalid_argument where no claim of the shipped file follows a truth.
inline core::Claim follows(const scenario::Scenario& scenario, core::Quantity quantity,
                           core::Reduction reduction, double sample) {
  const auto exact = std::find_if(scenario.claims.begin(), scenario.claims.end(),
                                  [](const core::Claim& claim) { return claim.truth.has_value(); });
  if (exact == scenario.claims.end()) throw std::invalid_argument(scenario.name + " follows no truth");
  core::Claim claim;
  claim.label = std::string(core::name(quantity)) + " follows " + exact->follows;
  claim.observable.quantity = quantity;
  claim.follows = exact->follows;
  claim.truth = exact->truth;
  claim.reduction = reduction;
  claim.sample = sample;
  claim.tolerance.reason = "none: the number itself is tested";
  return claim;
}

/// The verdict on a scenario's first claim.
inline results::Verdict verdict(const scenario::Scenario& scenario, const std::string& engine_id, double dt) {
  const study::Cell cell{&scenario, engine(engine_id), dt, std::to_string(dt)};
  return study::run(cell, process::Limits{}, scenario::Expectations{}).at(0);
}

}  // namespace cylon::conformance
