// A scenario for people and pictures, as JSON.
#pragma once

#include "harness/scenario/scenario.h"

#include <nlohmann/json.hpp>

namespace cylon::cli {

/// Name, words, duration, step and what is claimed how well; what is not finite, a horizon that is the whole
/// duration say, is null where this is written.
nlohmann::ordered_json scenario_facts(const scenario::Scenario&);

/// The facts with format, hash and scene (`ScenarioView` of reports/web/src/shared/documents.ts).
nlohmann::ordered_json scenario_view(const scenario::Scenario&);

}  // namespace cylon::cli
