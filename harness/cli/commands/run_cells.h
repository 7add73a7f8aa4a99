// Runs what is not in the journal yet, and keeps the journal.
#pragma once

#include "harness/cli/commands/run_options.h"
#include "harness/cli/context.h"
#include "harness/cli/journal.h"
#include "harness/scenario/expected.h"
#include "harness/study/cell_pool.h"

#include <optional>
#include <vector>

namespace cylon::cli {

/// What came of all cells, in order; with --resume the rows of the last journal where they are there and
/// still hold; in a farm of those that this rank got.
study::Matrix run_cells(const Context&, const RunOptions&, const scenario::Expectations&,
                        const Journal::Content& last, Journal&, const std::vector<study::Cell>&,
                        const std::optional<Shard>&);

}  // namespace cylon::cli
