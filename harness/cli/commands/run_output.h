// What `cylon run` prints and writes beside its rows.
#pragma once

#include "harness/cli/commands/run_options.h"
#include "harness/cli/context.h"
#include "harness/cli/traces.h"
#include "reports/console.h"
#include "reports/json.h"

#include <cstddef>
#include <string>
#include <vector>

namespace cylon::cli {

/// ok; differs where a row is not as expected, or numbers that somebody published do not come out;
/// harness_failure where a worker could not be had.
int exit_code(const std::vector<results::Verdict>&, bool published_differs);

/// The matrix; before it every claim where that was asked for, or where there is one cell.
void print(const Context&, const RunOptions&, const std::vector<results::Verdict>&, std::size_t cells);

/// Prints numbers that somebody published beside those of the rows, unless `quiet`; whether one does not come out.
bool print_published(const scenario::Suite&, const std::vector<results::Verdict>&, bool quiet);

/// Writes the page, and the traces for a later page, where they were asked for.
void write_report(const RunOptions&, const Selection&, const Traces&, reports::RunReport);

/// Prints the errors of each cell's claims over time under the cell's name.
void print_charts(const Traces&, const reports::ConsoleOptions&);

/// Writes a picture per scenario: the errors of the runs that share it.
void write_plots(const std::string& folder, const Traces&);

}  // namespace cylon::cli
