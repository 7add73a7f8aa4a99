// Whether an engine meets the claims of a scenario: the judge as one call, for the tests of the engine's own repository
// (docs/library.md).  Knows engines as workers alone.
#pragma once

#include "harness/results/verdict.h"

#include <filesystem>
#include <string>
#include <utility>
#include <vector>

namespace cylon::judge {

/// An engine behind the worker protocol.
struct Engine {
  std::vector<std::string> command;  ///< Worker and its arguments; looked up in PATH unless it has a slash.
  std::string variant = {};          ///< "integrator=rk4,iterations=20": settings that the worker offers.

  Engine(const char* worker) : command{worker} {}         // NOLINT(*-explicit-*): a worker is its engine
  Engine(const std::string& worker) : command{worker} {}  // NOLINT(*-explicit-*)
  explicit Engine(std::vector<std::string> words, std::string with = {})
      : command(std::move(words)), variant(std::move(with)) {}
};

struct Asked {
  double dt = 0;            ///< Step [s], > 0; 0: the scenario's nominal one.
  double run_seconds = 60;  ///< Time limit of a run [s], > 0.
  double tolerance_scale =
      1;  ///< Factor on every tolerance, >= 0; at 0 nothing passes and all residuals show.
};

/// A verdict for each claim, as `cylon run` gives it.
struct Conformity {
  std::vector<results::Verdict> verdicts;

  bool conforms() const;  ///< There are claims, and each passes.
  std::string text()
      const;  ///< A line for each claim: what was measured, what is allowed, why, and what went wrong.
};

/// Runs the scenario on the engine and judges each of its claims.  A crash, a hang, a refusal of the scene and numbers that
/// are not finite are verdicts.
/// `scenario`: a file (it ends in .toml), or a name in the folder or its extremes/.
/// Throws core::InputError for an unknown scenario, with the nearest name, for a file that cannot be judged, for a step or
/// a variant that cannot be, and where this thread does not round to nearest or flushes subnormal numbers to zero.
Conformity conform(const Engine&, const std::string& scenario, const std::filesystem::path& folder,
                   const Asked& = {});

}  // namespace cylon::judge
