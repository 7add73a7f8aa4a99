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

/// ok, or nothing_selected where no engine ran anything.
int exit_code(const std::vector<results::TradeTable>&);

/// Writes the tables to the files that are named.
void write_tables(const Context&, const Selection&, const std::vector<results::TradeTable>&,
                  const std::string& title, const std::string& json, const std::string& html);

}  // namespace cylon::cli
