// The command `cylon`: a table of subcommands, one source each.
#pragma once

#include "harness/cli/context.h"
#include "harness/core/input_error.h"

#include <CLI/CLI.hpp>

#include <functional>
#include <string>
#include <vector>

namespace cylon::cli {

/// Adds a subcommand's options to `app` and returns what runs it.
using Command = std::function<int()>;
Command add_list(CLI::App&, const Context&);
Command add_engines(CLI::App&, const Context&);
Command add_validate(CLI::App&, const Context&);
Command add_plan(CLI::App&, const Context&);
Command add_simulate(CLI::App&, const Context&);
Command add_truth(CLI::App&, const Context&);
Command add_run(CLI::App&, const Context&);
Command add_report(CLI::App&, const Context&);
Command add_trade(CLI::App&, const Context&);
Command add_diff(CLI::App&, const Context&);
Command add_advise(CLI::App&, const Context&);
Command add_limits(CLI::App&, const Context&);
Command add_selfcheck(CLI::App&, const Context&);
Command add_track(CLI::App&, const Context&);
Command add_view(CLI::App&, const Context&);
Command add_new(CLI::App&, const Context&);
Command add_doctor(CLI::App&, const Context&);
Command add_completion(CLI::App&, const Context&);

/// A number > 0 and at most `most`, NaN refused.
CLI::Validator positive(double most);

/// Writes the message, the offending line where there is one, and a caret under the column to stderr.
void show(const core::InputError&);

/// `--worker NAME=COMMAND`: an engine of the user's own behind the worker protocol.
void add_worker_option(CLI::App&, std::vector<std::string>& workers);

/// The context's engines and those rows; throws core::InputError for a row without '=', an empty
/// command, or one whose program is not there.
std::vector<process::EngineRow> with_workers(const Context&, const std::vector<std::string>& workers);

/// The whole program, errors turned into messages on stderr and exit codes.
int main(int argc, char** argv);

}  // namespace cylon::cli
