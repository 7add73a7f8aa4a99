// What a user says of a run that is added to the history, beside what was run.
#pragma once

#include "harness/cli/context.h"
#include "harness/cli/parser.h"
#include "harness/tracking/store/model.h"

#include <cstdint>
#include <optional>
#include <string>

namespace cylon::tracking {

struct RunWords {
  std::string label, revision, note;
  std::optional<std::int64_t> order;
};

/// --revision, --order, --label and --note.
void add_run_options(cli::App&, RunWords&);

/// A run of this program on this machine, begun now.
store::RunInfo run_here(const cli::Context&, const RunWords&);

}  // namespace cylon::tracking
