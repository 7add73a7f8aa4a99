// Many cells at once: a pool of threads, each with one worker process; rows in the order of the cells.
#pragma once

#include "harness/study/cell.h"
#include "harness/study/parallel.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::study {

struct Pool {
  int workers = 1;  ///< Cells that run at one time.
  process::Limits limits;
  Next next = {};  ///< Which cells are run here, in which order; empty: all, as they stand.
};

/// What came of the cells.  The two lists read "scenario on engine: why", in the order of the cells.
struct Matrix {
  std::vector<std::vector<results::Verdict>> rows;  ///< One entry per cell; empty where it was not reached.
  std::vector<std::string> refused;  ///< Cells whose engine called the request impossible; unsupported.
  std::vector<std::string> failed;   ///< Cells in which the harness itself failed: no process, no memory.
  bool interrupted = false;
};

/// Called, one cell at a time, in the order in which cells end: index into the cells, its rows, and how long it
/// took by the clock [s].  Not called for a cell in which the harness failed, so that it is run again.
using CellDone = std::function<void(std::size_t index, const std::vector<results::Verdict>&, double seconds)>;

/// Runs the cells; rows[i] are those of cells[i], the same for any number of workers.  Nothing that happens
/// inside a cell ends the others: whatever is thrown there becomes that cell's rows.  After an interruption
/// no further cell starts, and it returns as soon as the children are gone. What `done` throws ends the run,
/// and is thrown once the cells under way have ended.
Matrix run(const std::vector<Cell>& cells, const Pool&, const scenario::Expectations&, const CellDone& done);

}  // namespace cylon::study
