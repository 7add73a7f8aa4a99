// Which runs of an experiment parameters are fitted on, and which judge them.
#pragma once

#include "reference/measured/experiment.h"

#include <cstddef>
#include <vector>

namespace cylon::validation {

/// The part, 0 … parts - 1, of each run: runs in the order of the hashes of their names (FNV-1a) are dealt out in turn.  So parts
/// are of one size to one run, and do not depend on the order of the table.
std::vector<std::size_t> parts_of(const measured::Experiment&, std::size_t parts);

/// The runs in the order of those hashes.
std::vector<std::size_t> order_of(const measured::Experiment&);

/// The experiment with one run alone.
measured::Experiment with_run(const measured::Experiment&, std::size_t run);

/// The experiment with so many of its runs: the first in the order of those hashes, as the table has them.
measured::Experiment with_runs(const measured::Experiment&, std::size_t count);

}  // namespace cylon::validation
