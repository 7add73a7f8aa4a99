// cylon limits
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/limits_journal.h"
#include "harness/cli/commands/limits_report.h"
#include "harness/cli/journal.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/resumed.h"
#include "harness/cli/workers.h"
#include "harness/process/client.h"
#include "harness/process/engine_table.h"
#include "harness/process/interruption.h"
#include "harness/scenario/glob.h"
#include "harness/study/limits_step.h"
#include "harness/study/parallel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <memory>
#include <mutex>
#include <optional>
#include <stdexcept>
#include <utility>

namespace cylon::cli {
namespace {

struct Options {
  std::vector<std::string> words, engines, integrators;
  Brought brought;
  std::string json, csv;
  ShardOptions shard;
  int jobs = 0;
  double timeout = 60;
  bool resume = false;
};

// One search: a family, or a scenario's step; on one engine and integrator.
struct Task {
  const study::Family* family = nullptr;
  const scenario::Scenario* scenario = nullptr;
  process::EngineChoice engine;
  std::string name, integrator;  // the engine's own
  std::string refusal = {};      // why the engine does not run at all
};

struct Wanted {
  std::vector<const study::Family*> families;
  std::vector<std::unique_ptr<scenario::Scenario>> scenarios;
};

Wanted wanted(const Context& context, const std::vector<std::string>& words) {
  Wanted all;
  std::vector<std::string> names;
  for (const study::Family& family : study::families()) names.emplace_back(family.name);
  for (const study::Family& family : study::families())
    if (words.empty() || std::any_of(words.begin(), words.end(), [&](const std::string& word) {
          return scenario::glob_match(word, family.name);
        }))
      all.families.push_back(&family);
  for (const std::string& word : words) {
    const bool is_family = std::any_of(names.begin(), names.end(), [&](const std::string& name) {
      return scenario::glob_match(word, name);
    });
    bool known = is_family;
    if (is_path(word)) {
      all.scenarios.push_back(std::make_unique<scenario::Scenario>(scenario::load(word)));
      continue;
    }
    for (const auto& file : scenario_files(context))
      if (!is_family && scenario::glob_match(word, file.stem().string())) {
        all.scenarios.push_back(std::make_unique<scenario::Scenario>(scenario::load(file)));
        known = true;
      }
    if (!known)
      throw core::InputError(fmt::format("'{}' is neither a family of limits{} nor a scenario (families: {})",
                                         word, core::did_you_mean(word, names), fmt::join(names, ", ")));
  }
  return all;
}

// The engines asked for, each with each of its integrators that is asked for.
std::vector<Task> entrants(const Context& context, const Options& options) {
  const auto rows = with_brought(context, options.brought);
  std::vector<std::string> ids;
  if (options.engines.empty()) ids = process::compared_engines();
  for (const std::string& word : options.engines) {
    const bool glob = word.find_first_of("*?") != std::string::npos;
    if (!glob) ids.push_back(word);
    for (const auto& row : rows)
      if (glob && scenario::glob_match(word, row.id)) ids.push_back(row.id);
  }
  std::vector<Task> all;
  std::vector<std::string> integrators;
  bool refused = false;
  for (const std::string& id : ids) {
    process::EngineChoice choice = process::parse_engine(id, rows);
    core::Engine engine;
    try {
      engine = process::describe(choice);
      process::require_possible(choice);
    } catch (const process::Failure& failure) {  // one that is not here, too
      refused = true;
      all.push_back({.engine = choice, .refusal = failure.what()});
      continue;
    }
    for (std::size_t i = 0; i < engine.integrators.size(); ++i) {
      const std::string& integrator = engine.integrators[i].name;
      integrators.push_back(integrator);
      const bool stated = !choice.integrator.empty();
      const bool taken =
          stated ? choice.integrator == integrator
          : options.integrators.empty()
              ? i == 0
              : std::any_of(options.integrators.begin(), options.integrators.end(),
                            [&](const std::string& glob) { return scenario::glob_match(glob, integrator); });
      if (!taken) continue;
      Task task;
      task.engine = choice;
      if (!stated && !options.integrators.empty()) task.engine.integrator = integrator;
      task.name = engine.name, task.integrator = integrator;
      all.push_back(task);
    }
  }
  for (const std::string& glob : options.integrators)
    if (!refused && std::none_of(integrators.begin(), integrators.end(), [&](const std::string& integrator) {
          return scenario::glob_match(glob, integrator);
        }))
      throw core::InputError(
          fmt::format("--integrator '{}': none of these engines has it{} (integrators: {})", glob,
                      core::did_you_mean(glob, integrators), fmt::join(integrators, ", ")));
  return all;
}

LimitRow search_family(const Task& task, const process::Limits& limits) {
  const study::Family& family = *task.family;
  LimitRow row{family.name, family.asks, family.unit, family.breaks, task.engine.id, task.integrator, "",
               {},          0,           {}};
  row.downward = family.range.downward;
  row.theory = family.theory(task.name, task.integrator);
  const study::Runner runner = study::worker_runner(task.engine, limits);
  try {
    row.limit = study::limit_of(family, runner, row.theory);
  } catch (const study::RunFailed& failed) {
    throw study::Unsupported{failed.outcome.reason};
  }
  row.value = row.limit.value(family.range);
  return row;
}

LimitRow search_step(const Task& task, const process::Limits& limits) {
  const scenario::Scenario& scenario = *task.scenario;
  const study::StepSearch search = study::step_search(scenario);
  LimitRow row{"step of " + scenario.name,
               "largest step",
               "s",
               "a claim of the scenario fails",
               task.engine.id,
               task.integrator,
               "",
               {},
               0,
               {}};
  const auto step = [&](double multiple) {
    return scenario.duration / (multiple * static_cast<double>(search.unit));
  };
  row.limit = study::find_limit(search.range, [&](double multiple) {
    return study::step_probe(scenario, task.engine, limits,
                             static_cast<std::int64_t>(multiple) * search.unit);
  });
  row.value = step(row.limit.value(search.range));
  for (double* x : {&row.limit.holds, &row.limit.breaks})
    if (*x > 0) *x = step(*x);
  for (double& x : row.limit.holds_again) x = step(x);
  return row;
}

LimitRow search(const Task& task, const process::Limits& limits) {
  try {
    if (!task.refusal.empty()) throw study::Unsupported{task.refusal};
    return task.family ? search_family(task, limits) : search_step(task, limits);
  } catch (const study::Unsupported& why) {
    LimitRow row;
    row.family = task.family ? task.family->name : "step of " + task.scenario->name;
    row.asks = task.family ? task.family->asks : "largest step";
    row.unit = task.family ? task.family->unit : "s";
    row.breaks = task.family ? task.family->breaks : "a claim of the scenario fails";
    row.engine = task.engine.id, row.integrator = task.integrator;
    row.unsupported = why.reason;
    return row;
  }
}

// "spring on ode", "step of projectile on ode".
std::string name_of(const Task& task) {
  return fmt::format("{} on {}", task.family ? task.family->name : "step of " + task.scenario->name,
                     task.engine.id);
}

// The scenes of families are built by this program, whose content is part of the key.
Unit unit_of(const Task& task) {
  study::Cell cell;  // for the engine's part of its key alone
  const scenario::Scenario none;
  cell.scenario = task.scenario ? task.scenario : &none;
  cell.engine = task.engine;
  const std::string name = fmt::format("{} {} {}", task.family ? task.family->name : task.scenario->name,
                                       task.engine.id, task.integrator);
  return {name + "/" + cell_key(cell, ""), name};
}

// What came of the searches, in their order, whatever the number of threads.
struct Searched {
  std::vector<LimitRow> rows;       // of those that ended
  std::vector<std::string> failed;  // those in which the harness itself failed: "spring on ode: why"
  bool interrupted = false;
};

// Throws core::InputError, the first of all.
Searched search_all(const std::vector<Task>& tasks, const std::vector<Unit>& units, int jobs,
                    const process::Limits& limits, LimitsJournal& journal, const study::Next& next) {
  std::vector<std::optional<LimitRow>> rows(tasks.size());
  std::vector<std::string> failed(tasks.size());
  std::mutex guard;
  const auto search_one = [&](std::size_t i) {
    if (const auto known = journal.find(units[i])) {
      rows[i] = *known;
      return;
    }
    const auto start = std::chrono::steady_clock::now();
    LimitRow row = search(tasks[i], limits);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    const std::scoped_lock lock(guard);
    journal.add(units[i], row, seconds.count());
    rows[i] = std::move(row);
  };
  Searched all;
  try {
    study::in_parallel(
        tasks.size(), jobs,
        [&](std::size_t i) {
          try {
            search_one(i);
          } catch (const process::Interrupted&) {
            throw;
          } catch (const core::InputError&) {
            throw;
          } catch (const std::exception& error) {  // no process, no memory
            failed[i] = fmt::format("{}: the harness failed: {}", name_of(tasks[i]), error.what());
          }
        },
        next);
  } catch (const process::Interrupted&) {
    all.interrupted = true;
  }
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    if (rows[i]) all.rows.push_back(std::move(*rows[i]));
    if (!failed[i].empty()) all.failed.push_back(std::move(failed[i]));
  }
  return all;
}

int limits(const Context& context, const Options& options) {
  const std::vector<std::string> files = {options.json, options.csv};
  require_writable(files);
  const Wanted want = wanted(context, options.words);
  const std::vector<Task> engines = entrants(context, options);
  std::vector<Task> tasks;
  const auto add = [&](const study::Family* family, const scenario::Scenario* scenario) {
    for (Task task : engines) {
      task.family = family, task.scenario = scenario;
      if (!task.engine.integrator.empty() && task.engine.id.find("integrator=") == std::string::npos)
        task.engine.id += (task.engine.id.find('/') == std::string::npos ? "/integrator=" : ",integrator=") +
                          task.engine.integrator;
      tasks.push_back(task);
    }
  };
  for (const study::Family* family : want.families) add(family, nullptr);
  for (const auto& scenario : want.scenarios) add(nullptr, scenario.get());
  if (tasks.empty()) {
    std::cerr << "nothing selected; see `cylon engines --names`\n";
    return nothing_selected;
  }
  const std::optional<Shard> shard = shard_asked(options.shard, context.farm);
  Part part{"limits", shard ? shard->index : 1, shard ? shard->count : 1, {}};
  std::ranges::transform(tasks, std::back_inserter(part.units), unit_of);
  const std::vector<bool> own = own_units(shard, part, options.resume);
  std::vector<Unit> units = part.units;
  keep(own, tasks), keep(own, units);
  LimitsJournal journal(journal_file("limits", shard), part, options.resume);
  if (shard && !journal.is_open())
    throw core::InputError("a shard is its journal, and there is none: nothing was run");
  if (options.resume && !(shard && shard->farm)) std::cerr << resumed(journal.known(), "search", "searches");
  const process::Interruptible until_told;
  const Searched found = search_all(tasks, units, worker_count(context, options.jobs),
                                    {.run_seconds = options.timeout}, journal, next_of(shard, units.size()));
  if (shard && shard->farm) {  // the leader writes the rows
    if (!found.failed.empty()) throw std::runtime_error(found.failed.front());
    return found.interrupted ? interrupted : journal.is_open() ? ok : harness_failure;
  }
  if (!options.json.empty()) write_whole(options.json, limits_json(found.rows));
  if (!options.csv.empty()) write_whole(options.csv, limits_csv(found.rows));
  if (std::find(files.begin(), files.end(), "-") == files.end())
    std::cout << plain(limits_text(found.rows, context.width));
  for (const std::string& line : found.failed) std::cerr << "error: " << plain_line(line) << '\n';
  if (found.interrupted || !found.failed.empty())
    std::cerr << (found.interrupted ? "interrupted: " : "")
              << "what is written holds the searches that are done; repeat the command with --resume in this "
                 "folder to continue\n";
  if (found.interrupted) return interrupted;
  return !found.failed.empty() || (shard && !journal.is_open()) ? harness_failure : ok;
}

std::string family_list() {
  std::string text = "Families:\n";
  for (const study::Family& family : study::families())
    text += fmt::format("  {:<17} {}; fails when: {}\n", family.name, family.asks, family.breaks);
  return text +
         "\n"
         "For a scenario (a file, or a glob over the shipped ones) the command finds the largest step that "
         "meets\n"
         "all claims. It prints the theoretical value where one is known. The exit code is 0: limits are "
         "measured\n"
         "facts, not test results.";
}

}  // namespace

Command add_limits(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.footer(family_list());
  app.add_option("words", options->words,
                 "Families below, scenario files, or globs over both. Default: all families")
      ->type_name("FAMILY|FILE|GLOB");
  add_engines_option(app, options->engines, fmt::format("{}", fmt::join(process::compared_engines(), ", ")));
  add_integrators_option(app, options->integrators, "each engine's default");
  app.add_option("--json", options->json, "Write the rows as JSON; - is stdout")->type_name("FILE");
  app.add_option("--csv", options->csv, "Write the rows as CSV; - is stdout")->type_name("FILE");
  add_shard_options(app, options->shard, "searches");
  app.add_flag("--resume", options->resume,
               "Continue an interrupted search in this folder (.cylon/limits.jsonl): what is found is not "
               "searched again");
  add_jobs_option(app, options->jobs, "Number of searches to run at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  return [=, &context] { return limits(context, *options); };
}

}  // namespace cylon::cli
