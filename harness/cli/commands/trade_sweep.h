// One scenario swept over settings and steps, with progress on the terminal: for `cylon trade` and `cylon
// matrix`.
#pragma once

#include "harness/cli/commands/trade_journal.h"
#include "harness/cli/context.h"
#include "harness/cli/selection.h"
#include "harness/results/trade.h"
#include "harness/study/sweep.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::cli {

struct Sweep {
  const scenario::Scenario& scenario;
  std::vector<process::EngineRow> rows;  ///< Among which a reference is looked for where there is no truth.
  study::Ladder ladder;
  study::SweepOptions how;
  std::string observable;  ///< That decides; "": the principal one.
};

/// Errors, times and the front; a table without measures where there is nothing to measure.  `settings` is
/// asked once it is known that there is.
results::TradeTable sweep(const Context&, const Sweep&, TradeJournal&,
                          const std::function<std::vector<study::Setting>()>& settings);

struct SweepRequest {
  std::string command;                ///< "trade" or "matrix".
  std::vector<std::string> patterns;  ///< Of scenarios.
  std::vector<std::string> asked;     ///< What else decides the results: engines, steps, tolerances, ….
  ShardOptions shard;
  bool resume = false, timed = true;
};

/// Sweeps each scenario that is selected by `each`, and gives the tables of those that are done to `done`, unless there is
/// none.  ok; nothing_selected where there is no scenario, or no engine ran anything; interrupted; harness_failure where a
/// scenario could not be swept for want of processes or memory, which ends no other.
int sweep_each(const Context&, const SweepRequest&,
               const std::function<results::TradeTable(const scenario::Scenario&, TradeJournal&)>& each,
               const std::function<void(const Selection&, const std::vector<results::TradeTable>&)>& done);

/// Writes the tables to the files that are named.
void write_tables(const Context&, const Selection&, const std::vector<results::TradeTable>&,
                  const std::string& title, const std::string& json, const std::string& html);

}  // namespace cylon::cli
