#include "harness/cli/options.h"

#include "harness/cli/farm.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <string_view>
#include <thread>

namespace cylon::cli {
namespace {

Option add_list(App& app, const char* name, const char* type, std::vector<std::string>& words,
                const char* meaning, const std::string& otherwise) {
  return app.add_option(name, words, fmt::format("{}. Repeatable. Default: {}", meaning, otherwise))
      ->type_name(type)
      ->allow_extra_args(false);
}

}  // namespace

void add_engines_option(App& app, std::vector<std::string>& engines, const std::string& otherwise) {
  add_list(app, "--engine", "GLOB", engines, "Engine id or glob; add a variant after '/': bullet/gyro=none",
           otherwise);
}

void add_integrators_option(App& app, std::vector<std::string>& integrators, const std::string& otherwise) {
  add_list(app, "--integrator", "GLOB", integrators, "An integrator (`cylon engines` lists them), or a glob",
           otherwise);
}

Option add_steps_option(App& app, std::vector<std::string>& steps, const std::string& otherwise) {
  return add_list(app, "--dt", "S", steps, "Step [s], for example 0.001 or 1/60", otherwise);
}

void add_selection_options(App& app, Request& request) {
  app.add_option("patterns", request.patterns,
                 "SCENARIO[/ENGINE] globs, joined by ':', excluded with '-': 'bounce*:-*/ode'; or scenario "
                 "files (*.toml). Default: all scenarios of the suite")
      ->type_name("GLOB");
  add_engines_option(app, request.engines, "those of the suite");
  add_steps_option(app, request.steps, "each scenario's nominal step");
  add_integrators_option(app, request.integrators, "each engine's default");
  app.add_option("--suite", request.suite,
                 "A suite of scenarios/suites/: its scenarios, engines, steps and published numbers. "
                 "Default: conformance")
      ->type_name("NAME");
  add_brought_options(app, request.brought);
}

void add_step_option(App& app, std::string& step) {
  app.add_option("--dt", step, "Step [s], for example 0.001 or 1/60. Default: the scenario's nominal step")
      ->type_name("S");
}

Option add_times_option(App& app, std::vector<std::string>& words) {
  return app.add_option("--at", words, "Times to print [s], separated by commas: 0,0.5,1")->type_name("S");
}

std::vector<double> times_of_words(const std::vector<std::string>& words) {
  std::vector<double> times;
  for (const std::string_view list : words)
    for (std::size_t from = 0, comma = 0; comma != std::string_view::npos; from = comma + 1) {
      comma = list.find(',', from);
      const std::string_view word = list.substr(from, comma - from);
      double time = 0;
      const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), time);
      if (error != std::errc() || end != word.data() + word.size())
        throw core::InputError(fmt::format("--at {}: '{}' must be a number of seconds", list, word));
      times.push_back(time);
    }
  return times;
}

Option add_jobs_option(App& app, int& jobs, const std::string& meaning) {
  return app.add_option("-j,--jobs", jobs, meaning)->type_name("N")->check(positive(4096));
}

int worker_count(int jobs) {
  return jobs > 0 ? jobs : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

int worker_count(const Context& context, int jobs) {
  return jobs > 0 || !context.farm ? worker_count(jobs) : static_cast<int>(context.farm->cores());
}

void add_timeout_option(App& app, double& timeout) {
  app.add_option("--timeout", timeout, "Time limit of each run [s]")
      ->capture_default_str()
      ->type_name("S")
      ->check(positive(1e6));
}

void add_memory_option(App& app, double& memory) {
  app.add_option("--memory", memory, "Memory limit of an engine [GiB]")
      ->capture_default_str()
      ->type_name("GIB")
      ->check(positive(1e6));
}

void add_sweep_options(App& app, int& rounds, int& jobs, double& timeout) {
  app.add_option("--rounds", rounds,
                 "Number of timings of each setting, interleaved; the shortest counts. 0: no timing")
      ->type_name("N")
      ->capture_default_str()
      ->check(in_range(0, 1000));
  add_jobs_option(app, jobs,
                  "Number of runs at the same time while errors are measured; default: all processors. Timed "
                  "runs never overlap");
  add_timeout_option(app, timeout);
}

}  // namespace cylon::cli
