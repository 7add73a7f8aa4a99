// The command `cylon`: a table of subcommands, one source each.
#pragma once

#include "harness/cli/context.h"
#include "harness/cli/parser.h"
#include "harness/core/input_error.h"

#include <string>
#include <vector>

namespace cylon::cli {

// Each adds a command's options and returns what runs it.
Command add_list(App&, const Context&);
Command add_engines(App&, const Context&);
Command add_validate(App&, const Context&);
Command add_plan(App&, const Context&);
Command add_simulate(App&, const Context&);
Command add_truth(App&, const Context&);
Command add_run(App&, const Context&);
Command add_report(App&, const Context&);
Command add_trade(App&, const Context&);
Command add_diff(App&, const Context&);
Command add_advise(App&, const Context&);
Command add_limits(App&, const Context&);
Command add_selfcheck(App&, const Context&);
Command add_track(App&, const Context&);
Command add_view(App&, const Context&);
Command add_new(App&, const Context&);
Command add_doctor(App&, const Context&);
Command add_completion(App&, const Context&);

/// Writes the message, the offending line where there is one, and a caret under the column to stderr.
void show(const core::InputError&);

/// `--worker NAME=COMMAND`: an engine of the user's own behind the worker protocol.
void add_worker_option(App&, std::vector<std::string>& workers);

/// The context's engines and those rows; throws core::InputError for a row without '=', an empty
/// command, or one whose program is not there.
std::vector<process::EngineRow> with_workers(const Context&, const std::vector<std::string>& workers);

/// The whole program, errors turned into messages on stderr and exit codes.
int main(int argc, char** argv);

}  // namespace cylon::cli
