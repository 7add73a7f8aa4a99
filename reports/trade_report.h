// Work–precision tables for people, programs and the eye.
#pragma once

#include "harness/results/trade.h"
#include "reports/console_options.h"
#include "reports/plot.h"
#include "reports/provenance.h"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace cylon::reports {

/// A line per series: declared and observed order, floor, the cost at which it reaches 1e-2, 1e-4 and 1e-6
/// (and the user's target), then the Pareto front; with `every_point` each point with all its errors.
std::string trade_text(const results::TradeTable&, const ConsoleOptions&, bool every_point);

/// All tables; times, which differ from run to run, stand apart in "times".
nlohmann::ordered_json trade_json(const std::vector<results::TradeTable>&, const Provenance&);

/// A row per point; times are the last columns.
std::string trade_csv(const std::vector<results::TradeTable>&);

/// Error against CPU time per simulated second (steps per second where there are no times), a curve per
/// series, the front of each build drawn through.
Plot trade_plot(const results::TradeTable&);

/// "in-house rk4", or the engine alone where it has one integrator in the table.
std::string trade_label(const results::TradeTable&, const results::TradeSeries&);

/// "4.01, floor 3e-13 from 5/1248", "0.99, best 2e-3 at 5/39936", "never near, best 3e+00 at …".
std::string order_text(const results::TradeTable&, const results::TradeSeries&);

/// Of all series, as builds.h has it.
std::string costs_of_another_build(const std::vector<results::TradeTable>&, const ConsoleOptions&);

/// A line for each engine that makes several parts of a step: "rapier: 4 substeps in each step."
std::string substeps_of(const std::vector<results::TradeTable>&, const ConsoleOptions&);

/// The cheapest point with an error by the table's measure of at most `error`, or nullptr.  Without times the
/// one of the fewest steps.
const results::TradePoint* cheapest(const results::TradeTable&, const results::TradeSeries&, double error);

}  // namespace cylon::reports
