#include "harness/cli/commands/run_progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>

namespace cylon::cli {

void Progress::done(const study::Cell& cell, const std::vector<results::Verdict>& rows) {
  ++finished_;
  if (!on_) return;
  clear();
  if (!std::ranges::all_of(rows, &results::Verdict::as_expected))
    std::cerr << fmt::format("differs: {} on {} at {}\n", cell.scenario->name, cell.engine.id, cell.dt_text);
  std::cerr << fmt::format("\r[{}/{}] {} on {}\x1b[K", finished_, total_, cell.scenario->name, cell.engine.id)
            << std::flush;
}

void Progress::clear() const {
  if (on_) std::cerr << "\r\x1b[K" << std::flush;
}

}  // namespace cylon::cli
