// The traces of a run's cells, for its report.
#pragma once

#include "harness/study/cell.h"
#include "reports/html.h"
#include "reports/trace.h"

#include <mutex>
#include <string>
#include <vector>

namespace cylon::cli {

/// Of which cells traces are kept.
enum class Trajectories { none, fail, all };

/// Gathers packed traces from the threads that run cells; their order is that of the cells.
class Traces {
 public:
  /// Makes every cell hand its run over.  Each cell's errors are kept as they are; frames only packed.
  void watch(std::vector<study::Cell>& cells);

  /// Those that are wanted, in the order in which a report gives them space: cells that differ from
  /// expected.toml, other failures, runs of the same scenarios that did not fail (to be compared with), the
  /// rest (all only).  `why_not` says what is left out, "" where nothing is.
  std::vector<reports::PackedTrace> chosen(const std::vector<study::Cell>& cells,
                                           const std::vector<results::Verdict>&, Trajectories,
                                           std::string& why_not) const;

  /// By cell; of cells without a recording empty.
  const std::vector<reports::Trace>& errors() const { return errors_; }

 private:
  std::mutex adding_;
  std::vector<reports::PackedTrace> packed_;  // by cell; an empty block: there was no recording
  std::vector<reports::Trace> errors_;        // without motions and totals
};

}  // namespace cylon::cli
