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
Command add_merge(App&, const Context&);
Command add_farm(App&, const Context&);
Command add_report(App&, const Context&);
Command add_trade(App&, const Context&);
Command add_matrix(App&, const Context&);
Command add_diff(App&, const Context&);
Command add_advise(App&, const Context&);
Command add_limits(App&, const Context&);
Command add_hunt(App&, const Context&);
Command add_predict(App&, const Context&);
Command add_fit(App&, const Context&);
Command add_selfcheck(App&, const Context&);
Command add_view(App&, const Context&);
Command add_new(App&, const Context&);
Command add_import(App&, const Context&);
Command add_export(App&, const Context&);
Command add_doctor(App&, const Context&);
Command add_completion(App&, const Context&);

/// Writes the message, the offending line where there is one, and a caret under the column to stderr.
void show(const core::InputError&);

/// Runs a command line without the program's name; what is wrong with it is thrown as core::InputError.
int run_words(const Context&, const std::vector<std::string>& words);

/// The whole program, errors turned into messages on stderr and exit codes.
int main(int argc, char** argv);

}  // namespace cylon::cli
