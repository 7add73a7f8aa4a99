// Many cells at once: a pool of threads, each with one worker process; rows in the order of the cells.
#pragma once

#include "harness/study/cell.h"

#include <functional>
#include <vector>

namespace cylon::study {

struct Pool {
  int workers = 1;  ///< Cells that run at one time.
  process::Limits limits;
};

/// Called, one cell at a time, in the order in which cells end; index into the cells.
using CellDone = std::function<void(std::size_t index, const std::vector<results::Verdict>&)>;

/// Runs all cells; rows[i] are those of cells[i], the same for any number of workers.  The first
/// core::InputError of the lowest index is thrown once the cells under way have ended; process::Interrupted
/// as soon as the children are gone.
std::vector<std::vector<results::Verdict>> run(const std::vector<Cell>& cells, const Pool&,
                                               const scenario::Expectations&, const CellDone& done);

}  // namespace cylon::study
