// Which step each engine needs on each scenario, for people at a terminal and for the page.
#pragma once

#include "harness/results/step_matrix.h"
#include "reports/console_options.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cylon::reports {

/// Scenario by scenario a line per engine: for each of results::reach_errors the coarsest step and its CPU
/// time per simulated second, or "not reached"; the observed order; and why the first error that is not
/// reached is not.
std::string steps_text(const std::vector<results::TradeTable>&, const ConsoleOptions&);

/// A row per scenario, a column per engine: -log10 of the error at the coarsest tried step of at most `dt`
/// [s].
std::string digits_text(const std::vector<results::TradeTable>&, double dt, const ConsoleOptions&);

/// The cells of a table, for the page: points are told by their place in their series.
nlohmann::ordered_json steps_json(const results::TradeTable&);

}  // namespace cylon::reports
