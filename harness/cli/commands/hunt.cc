// cylon hunt
#include "harness/hunt/hunt.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/commands/hunt_cards.h"
#include "harness/cli/commands/hunt_journal.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/part.h"
#include "harness/cli/patterns.h"
#include "harness/cli/progress.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"
#include "harness/study/parallel.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <iostream>
#include <iterator>
#include <limits>
#include <memory>
#include <mutex>
#include <system_error>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> engines, scenes;
  Brought brought;
  std::string cards = "cards", replay, json;
  std::uint64_t seed = 1, first = 0;
  int count = 0, jobs = 0;
  double minutes = 0, timeout = 20;
  bool resume = false;
  ShardOptions shard;
};

// Scenes of one engine that are one unit of work: few, so that parts are equal.
constexpr std::uint64_t unit_size = 8;
struct Task {
  std::size_t engine;
  std::uint64_t begin, end;
};

// The scenarios that the patterns take, as far as they can be started from; what is left out is said.
std::vector<hunt::Base> bases(const Context& context, const std::vector<std::string>& words) {
  const std::vector<Pattern> patterns = parse_patterns(words);
  std::vector<fs::path> files;
  for (const Pattern& pattern : patterns)
    if (is_path(pattern.scenario))
      files.emplace_back(pattern.scenario);
    else if (!is_glob(pattern.scenario))
      static_cast<void>(find_scenario(context, pattern.scenario));  // throws for an unknown one
  for (const fs::path& file : scenario_files(context))
    if (may_be_taken(patterns, file.stem().string())) files.push_back(file);
  std::vector<hunt::Base> found;
  for (const fs::path& file : files) {
    hunt::Start start = hunt::start_from(scenario::read(file));
    if (start.base)
      found.push_back(std::move(*start.base));
    else
      std::cerr << fmt::format("left out: {}: {}\n", plain_line(file.stem().string()), start.left_out);
  }
  return found;
}

// Who is hunted, in which scenes.
struct Chase {
  const Context& context;
  const Options& options;
  const hunt::Source& source;
  std::vector<process::EngineChoice> engines;
  HuntJournal& journal;

  hunt::Quarry quarry(std::size_t engine, int jobs) const {
    return {engines[engine],
            {.run_seconds = options.timeout},
            jobs,
            &journal.of(question_of(engines[engine], source, options.timeout))};
  }
  int jobs() const { return worker_count(context, options.jobs); }
  void progress(const std::string& text) const { show_progress(context.progress, text); }
};

// Such an engine's rows depend on the order of scenes.
void tell_carried_over(const hunt::Found& found, const std::string& engine) {
  for (const std::uint64_t number : found.after_others)
    std::cerr << fmt::format(
        "{}: scene {} has a fault after other scenes in one process, and none in processes of its own: not "
        "counted\n",
        engine, number);
}

// As long as the time lasts.
hunt::Found search_for(const Chase& chase, std::size_t engine, double seconds) {
  const auto start = std::chrono::steady_clock::now();
  hunt::Found found =
      hunt::search(chase.source, chase.options.first, chase.quarry(engine, chase.jobs()), [&](auto begun) {
        const std::chrono::duration<double> past = std::chrono::steady_clock::now() - start;
        if (begun % 8 == 0)
          chase.progress(
              fmt::format("{}: {} scenes, {:.0f} s", chase.engines[engine].id, begun, past.count()));
        return past.count() < seconds;
      });
  chase.progress("");
  tell_carried_over(found, chase.engines[engine].id);
  return found;
}

std::vector<Task> tasks_of(const Options& options, std::size_t engines) {
  std::vector<Task> tasks;
  const std::uint64_t end = options.first + static_cast<std::uint64_t>(options.count);
  for (std::size_t engine = 0; engine < engines; ++engine)
    for (std::uint64_t begin = options.first; begin < end; begin += unit_size)
      tasks.push_back({engine, begin, std::min(begin + unit_size, end)});
  return tasks;
}

// So many scenes, or this process's part of them; by engine.
std::vector<hunt::Found> search_part(const Chase& chase, const std::optional<Shard>& shard) {
  std::vector<Task> tasks = tasks_of(chase.options, chase.engines.size());
  Part part{"hunt", shard ? shard->index : 1, shard ? shard->count : 1, {}};
  std::vector<std::string> questions;
  for (const process::EngineChoice& engine : chase.engines)
    questions.push_back(question_of(engine, chase.source, chase.options.timeout));
  for (const Task& task : tasks) {
    const std::string scenes = fmt::format("scenes {} to {}", task.begin, task.end - 1);
    part.units.push_back(
        {questions[task.engine] + " " + scenes,
         fmt::format("{} {} {}", chase.engines[task.engine].id, chase.source.name(), scenes)});
  }
  const std::vector<bool> own = own_units(shard, part, chase.options.resume);
  std::vector<Unit> units = part.units;
  keep(own, tasks), keep(own, units);
  chase.journal.add(part);
  if (shard && !chase.journal.is_open())
    throw core::InputError("a shard is its journal, and there is none: nothing was run");

  std::vector<hunt::Found> found(chase.engines.size());
  std::mutex guard;
  std::uint64_t scenes = 0;
  const auto search = [&](std::size_t i) {
    const auto start = std::chrono::steady_clock::now();
    const Task& task = tasks[i];
    hunt::Found part_found = hunt::search(chase.source, task.begin, chase.quarry(task.engine, 1),
                                          [&](auto begun) { return begun < task.end - task.begin; });
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    chase.journal.done(units[i], seconds.count());
    const std::scoped_lock lock(guard);
    hunt::Found& all = found[task.engine];
    all.scenes += part_found.scenes, all.refused += part_found.refused;
    std::ranges::move(part_found.hits, std::back_inserter(all.hits));
    std::ranges::move(part_found.after_others, std::back_inserter(all.after_others));
    chase.progress(fmt::format("{}: {} scenes", chase.engines[task.engine].id, scenes += part_found.scenes));
  };
  study::in_parallel(tasks.size(), chase.jobs(), search, next_of(shard, tasks.size()));
  chase.progress("");
  for (std::size_t engine = 0; engine < found.size(); ++engine) {
    std::ranges::sort(found[engine].hits, {}, &hunt::Hit::number);
    std::ranges::sort(found[engine].after_others);
    tell_carried_over(found[engine], chase.engines[engine].id);
  }
  return found;
}

// Every card of the folder, by name: whether its engine, or those that are asked for, still has the fault.
int replay(const Context& context, const Options& options) {
  const auto rows = with_brought(context, options.brought);
  const std::vector<fs::path> files = hunt::card_files(options.replay);
  if (files.empty()) {
    std::cerr << "nothing selected: no card in " << plain_line(options.replay) << '\n';
    return nothing_selected;
  }
  const process::Limits limits{.run_seconds = options.timeout};
  const process::Interruptible until_told;
  bool any = false;
  for (const fs::path& file : files) {
    const hunt::Kept card = hunt::read_card(file.string());
    const std::vector<std::string> engines =
        options.engines.empty() ? std::vector{card.engine} : options.engines;
    for (const std::string& id : engines) {
      const hunt::Replayed now = hunt::replay(card, process::parse_engine(id, rows), limits);
      using enum hunt::Replayed::What;
      any = any || now.what == still_there || now.what == changed;
      std::string said(hunt::name(now.what));
      if (now.what == changed) said += fmt::format(": {:.3g}, was {:.3g}", now.measured, card.measured);
      std::cout << plain_line(fmt::format("{:<60} {:<24} {}", file.stem().string(), id, said)) << '\n';
    }
  }
  return any ? differs : ok;
}

// A finding that depends on how fast this machine is.
std::string marked(const hunt::Card& card) {
  return card.fault.by_time ? card.signature + " [by timeout]" : card.signature;
}

int make_cards(const Chase& chase, const std::vector<hunt::Found>& found,
               const std::vector<process::EngineChoice>& others) {
  const Options& options = chase.options;
  const auto say = [&](const std::string& line) {
    if (chase.context.progress) std::cerr << plain_line(line) << '\n';
  };
  std::vector<WrittenCard> all;
  const auto cards_of = [&](std::size_t i) {
    const process::EngineChoice& engine = chase.engines[i];
    std::cout << plain_line(fmt::format("{}: {} of {} scenes ({}, from {}) with a fault; {} refused",
                                        engine.id, found[i].hits.size(), found[i].scenes, chase.source.name(),
                                        options.first, found[i].refused))
              << '\n'
              << std::flush;
    std::vector<process::EngineChoice> rest = others;
    std::erase_if(rest, [&](const auto& other) { return other.row.id == engine.row.id; });
    const hunt::Quarry quarry = chase.quarry(i, chase.jobs());
    for (hunt::Card& card : hunt::cards(chase.source, found[i].hits, quarry, rest, say)) {
      WrittenCard written{card, hunt::write_program(card, engine, quarry.limits)};
      write_card(options.cards, written);
      std::cout << plain_line(fmt::format("  {:<60} {:>6} scenes  {}.md", marked(card), card.hits,
                                          (fs::path(options.cards) / card.file_stem()).string()))
                << '\n'
                << std::flush;
      all.push_back(std::move(written));
    }
  };
  const bool whole = process::completes([&] {
    for (std::size_t i = 0; i < found.size(); ++i) cards_of(i);
  });
  nlohmann::ordered_json made = document(all);
  for (std::size_t i = 0; i < found.size(); ++i)
    made["asked"].push_back({{"engine", chase.engines[i].id},
                             {"scenes", found[i].scenes},
                             {"refused", found[i].refused},
                             {"faulty", found[i].hits.size()}});
  if (!whole) made["interrupted"] = true;
  if (!options.json.empty()) write_whole(options.json, made.dump(1) + '\n');
  if (!whole) throw process::Interrupted();
  return all.empty() ? ok : differs;
}

int hunt_all(const Context& context, const Options& options) {
  if (!options.replay.empty()) return replay(context, options);
  if (options.engines.empty()) throw core::InputError("--engine: no engine to look for faults of");
  if ((options.count > 0) == (options.minutes > 0))
    throw core::InputError("give either --count N or --minutes N");
  const auto rows = with_brought(context, options.brought);
  std::vector<process::EngineChoice> engines, others;
  for (const std::string& id : options.engines) {
    const process::EngineChoice choice = process::parse_engine(id, rows);
    if (const auto reason = process::missing(choice.row))
      std::cerr << plain_line(*reason) << '\n';
    else
      engines.push_back(choice);
  }
  if (engines.empty()) return nothing_selected;
  for (const process::EngineRow& row : rows)
    if (!process::missing(row)) others.push_back(process::parse_engine(row.id, rows));
  hunt::Source source(options.seed);
  if (!options.scenes.empty()) {
    std::vector<hunt::Base> from = bases(context, options.scenes);
    if (from.empty()) {
      std::cerr << "nothing selected: no scenario to start from; see `cylon list --names`\n";
      return nothing_selected;
    }
    source = hunt::Source(options.seed, std::move(from));
  }
  const std::optional<Shard> shard = shard_asked(options.shard, context.farm);
  if (shard && options.count == 0)
    throw core::InputError(
        fmt::format("--minutes: how many scenes that is depends on the machine, so that it has no parts "
                    "({}); give --count N",
                    shard->said_by));
  std::error_code error;
  if (!shard) fs::create_directories(options.cards, error);
  if (error) throw core::InputError(fmt::format("--cards {}: {}", options.cards, error.message()));
  HuntJournal journal(journal_file("hunt", shard), options.resume);
  const Chase chase{context, options, source, engines, journal};
  const process::Interruptible until_told;
  try {
    std::vector<hunt::Found> found;
    if (options.count > 0)
      found = search_part(chase, shard);
    else
      for (std::size_t i = 0; i < engines.size(); ++i)
        found.push_back(search_for(chase, i, 60 * options.minutes));
    if (shard) return journal.is_open() ? ok : harness_failure;  // cards are made of all parts
    return make_cards(chase, found, others);
  } catch (const process::Interrupted&) {
    std::cerr << "interrupted; continue with the same command and --resume in this folder\n";
    return interrupted;
  } catch (const fs::filesystem_error&) {  // of a name that was given
    throw;
  } catch (const std::system_error& refused) {  // no process, no thread
    if (shard && shard->farm) throw;
    std::cerr << plain_line(fmt::format("error: the harness failed: {}; continue with the same command and "
                                        "--resume in this folder",
                                        refused.what()))
              << '\n';
    return harness_failure;
  }
}

}  // namespace

Command add_hunt(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  add_engines_option(app, options->engines, "none; of --replay each card's own");
  const Option count = app.add_option("--count", options->count, "Number of scenes")
                           ->type_name("N")
                           ->check(in_range(1, 1'000'000'000));
  const Option minutes = app.add_option("--minutes", options->minutes,
                                        "Time of the search of each engine; it ends at a scene's end")
                             ->type_name("N")
                             ->check(positive(1e5));
  const Option seed =
      app.add_option("--seed", options->seed, "Of the random scenes: the same seed gives the same scenes")
          ->type_name("S")
          ->check(whole(std::numeric_limits<std::uint64_t>::max()))
          ->capture_default_str();
  const Option scenes = app.add_option("--scenes", options->scenes,
                                       "Start from these scenarios (globs over the shipped ones, or files) "
                                       "and change them, in place of "
                                       "random scenes")
                            ->type_name("GLOB");
  const Option first = app.add_option("--first", options->first, "Number of the first scene")
                           ->type_name("N")
                           ->check(whole(std::uint64_t{1} << 62))
                           ->capture_default_str();
  const Option cards =
      app.add_option("--cards", options->cards,
                     "Folder for the cards: a scenario, a page, a picture and a program for each fault")
          ->type_name("FOLDER")
          ->capture_default_str();
  const Option resume =
      app.add_flag("--resume", options->resume,
                   "Continue an interrupted hunt of this folder: scenes that were asked, and cards that were "
                   "shrunk, are not "
                   "done again");
  const Option json =
      app.add_option("--json", options->json, "Write all cards as a document, which `cylon report` shows")
          ->type_name("FILE");
  app.add_option(
         "--replay", options->replay,
         "Look for nothing; say of each card in the folder whether its fault is fixed, still there or "
         "changed, or its scene refused, in its engine or in those of --engine")
      ->type_name("FOLDER")
      ->excludes(count)
      ->excludes(minutes)
      ->excludes(seed)
      ->excludes(scenes)
      ->excludes(first)
      ->excludes(cards)
      ->excludes(resume)
      ->excludes(json);
  add_shard_options(app, options->shard, "units of 8 scenes");
  add_jobs_option(app, options->jobs, "Number of scenes to run at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  app.footer(
      "Every fault is shrunk to the least scene that still has it. What it finds does not depend on the "
      "number\n"
      "of jobs. Exit code 1: there is a fault.");
  return [=, &context] { return hunt_all(context, *options); };
}

}  // namespace cylon::cli
