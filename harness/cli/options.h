// Options that several commands have, each said once.
#pragma once

#include "harness/cli/selection.h"

#include "harness/cli/parser.h"

#include <string>
#include <vector>

namespace cylon::cli {

/// --engine, --integrator, --dt: globs or steps that may be given again; `otherwise` ends the help: what is
/// taken where none is given.
void add_engines_option(App&, std::vector<std::string>& engines, const std::string& otherwise);
void add_integrators_option(App&, std::vector<std::string>& integrators, const std::string& otherwise);
Option add_steps_option(App&, std::vector<std::string>& steps, const std::string& otherwise);

/// Which cells: the patterns, the three above, --suite and --worker.
void add_selection_options(App&, Request&);

/// --dt of one run; its default is the scenario's nominal step.
void add_step_option(App&, std::string& step);

/// --at: times to print, as words.
Option add_times_option(App&, std::vector<std::string>& words);

/// Seconds of such words: numbers separated by commas.  Throws core::InputError, which names the word that is
/// none.
std::vector<double> times_of_words(const std::vector<std::string>& words);

/// -j; `meaning` says what runs at one time.
Option add_jobs_option(App&, int& jobs, const std::string& meaning);

/// The number given, or where none is (0) all processors; in a farm this rank's.
int worker_count(int jobs);
int worker_count(const Context&, int jobs);

/// --timeout [s] and --memory [GiB] of each run.
void add_timeout_option(App&, double& timeout);
void add_memory_option(App&, double& memory);

/// --rounds, --jobs and --timeout [s] of what measures errors, then times.
void add_sweep_options(App&, int& rounds, int& jobs, double& timeout);

}  // namespace cylon::cli
