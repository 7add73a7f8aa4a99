// The largest step at which an engine meets every claim of a scenario.
#pragma once

#include "harness/study/cell.h"
#include "harness/study/limits.h"

#include <cstdint>

namespace cylon::study {

/// Steps are the duration over whole numbers n, so that each fits; n is a multiple of `unit`, where claims
/// are read at times that ask for it.
struct StepSearch {
  std::int64_t unit = 1;
  Range range;  ///< Of n/unit, downward.
};

/// From 8 times as many steps as the nominal ones to 1/64 of them, two at least.
StepSearch step_search(const scenario::Scenario&);

/// What becomes of the scenario's claims at n = multiple * unit steps.  Throws Unsupported.
Probed step_probe(const scenario::Scenario&, const process::EngineChoice&, const process::Limits&,
                  std::int64_t steps);

/// The engine cannot express the scene.
struct Unsupported {
  std::string reason;
};

}  // namespace cylon::study
