// cylon hunt
#include "harness/hunt/hunt.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"
#include "harness/core/input_error.h"
#include "harness/process/interruption.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <memory>

namespace cylon::cli {
namespace {

namespace fs = std::filesystem;

struct Options {
  std::vector<std::string> engines, workers;
  std::string cards = "cards", replay;
  std::uint64_t seed = 1, first = 0;
  int count = 0, jobs = 0;
  double minutes = 0, timeout = 20;
};

constexpr std::uint64_t unit = 32;  // scenes between two looks at the clock

struct Searched {
  std::vector<hunt::Hit> hits;
  std::uint64_t scenes = 0;
};

Searched search(const Context& context, const Options& options, const process::EngineChoice& engine,
                const process::Limits& limits) {
  Searched all;
  const auto start = std::chrono::steady_clock::now();
  const auto seconds = [&] {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  };
  const auto count = static_cast<std::uint64_t>(options.count);
  while (options.count > 0 ? all.scenes < count : seconds() < 60 * options.minutes) {
    const std::uint64_t more = options.count > 0 ? std::min(unit, count - all.scenes) : unit;
    const auto hits = hunt::search({options.seed, options.first + all.scenes, more}, engine, limits,
                                   worker_count(options.jobs), {});
    all.hits.insert(all.hits.end(), hits.begin(), hits.end());
    all.scenes += more;
    if (context.progress)
      std::cerr << fmt::format("\r{}: {} scenes, {} with a fault, {:.0f} s\x1b[K", engine.id, all.scenes,
                               all.hits.size(), seconds())
                << std::flush;
  }
  if (context.progress) std::cerr << "\r\x1b[K" << std::flush;
  return all;
}

// Every card of the folder, by name: whether its engine, or those that are asked for, still has the fault.
int replay(const Context& context, const Options& options) {
  const auto rows = with_workers(context, options.workers);
  std::vector<fs::path> files;
  std::error_code error;
  for (const auto& entry : fs::directory_iterator(options.replay, error))
    if (entry.path().extension() == ".toml") files.push_back(entry.path());
  if (error) throw core::InputError(fmt::format("--replay {}: {}", options.replay, error.message()));
  std::ranges::sort(files);
  if (files.empty()) {
    std::cerr << "nothing selected: no card in " << plain(options.replay) << '\n';
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
      const process::EngineChoice engine = process::parse_engine(id, rows);
      const auto faults = hunt::examine(card.trial, engine, limits, card.oracle);
      const double ratio = faults.empty() ? 0 : faults[0].measured[0] / card.measured;
      const bool same = ratio > 1 / 1.1 && ratio < 1.1;
      any = any || !faults.empty();
      std::cout << plain(fmt::format(
          "{:<60} {:<24} {}\n", file.stem().string(), id,
          faults.empty() ? std::string("fixed")
          : same || card.measured == 0
              ? std::string("still there")
              : fmt::format("changed: {:.3g}, was {:.3g}", faults[0].measured[0], card.measured)));
    }
  }
  return any ? differs : ok;
}

int hunt_all(const Context& context, const Options& options) {
  if (!options.replay.empty()) return replay(context, options);
  if (options.engines.empty()) throw core::InputError("--engine: no engine to look for faults of");
  if ((options.count > 0) == (options.minutes > 0))
    throw core::InputError("give either --count N or --minutes N");
  const auto rows = with_workers(context, options.workers);
  std::error_code error;
  fs::create_directories(options.cards, error);
  if (error) throw core::InputError(fmt::format("--cards {}: {}", options.cards, error.message()));
  const process::Limits limits{.run_seconds = options.timeout};
  std::vector<process::EngineChoice> others;
  for (const process::EngineRow& row : rows)
    if (!row.optional()) others.push_back(process::parse_engine(row.id, rows));
  const process::Interruptible until_told;
  bool any = false;
  for (const std::string& id : options.engines) {
    const process::EngineChoice engine = process::parse_engine(id, rows);
    const Searched found = search(context, options, engine, limits);
    std::cout << fmt::format("{}: {} of {} scenes (seed {}, from {}) with a fault\n", id, found.hits.size(),
                             found.scenes, options.seed, options.first);
    std::vector<process::EngineChoice> rest;
    for (const process::EngineChoice& other : others)
      if (other.row.id != engine.row.id) rest.push_back(other);
    const auto cards = hunt::cards(options.seed, found.hits, engine, rest, limits, worker_count(options.jobs),
                                   [&](const std::string& line) {
                                     if (context.progress) std::cerr << plain_line(line) << '\n';
                                   });
    for (const hunt::Card& card : cards) {
      any = true;
      const std::string stem = (fs::path(options.cards) / card.file_stem()).string();
      write_whole(stem + ".toml", hunt::scenario_toml(card));
      write_whole(stem + ".md", hunt::markdown(card));
      std::cout << plain(fmt::format("  {:<60} {:>6} scenes  {}.md\n", card.signature, card.hits, stem));
    }
  }
  return any ? differs : ok;
}

}  // namespace

Command add_hunt(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  add_engines_option(app, options->engines, "none; of --replay each card's own");
  app.add_option("--count", options->count, "Number of scenes")
      ->type_name("N")
      ->check(in_range(1, 1'000'000'000));
  app.add_option("--minutes", options->minutes, "Time of the search of each engine; it ends at a scene's end")
      ->type_name("N")
      ->check(positive(1e5));
  app.add_option("--seed", options->seed, "Of the random scenes: the same seed gives the same scenes")
      ->type_name("S")
      ->capture_default_str();
  app.add_option("--first", options->first, "Number of the first scene")
      ->type_name("N")
      ->capture_default_str();
  app.add_option("--cards", options->cards, "Folder for the cards: a scenario file and a page for each fault")
      ->type_name("FOLDER")
      ->capture_default_str();
  app.add_option(
         "--replay", options->replay,
         "Look for nothing; say of each card in the folder whether its fault is fixed, still there or "
         "changed, in its engine or in those of --engine")
      ->type_name("FOLDER");
  add_jobs_option(app, options->jobs, "Number of scenes to run at the same time; default: all processors");
  add_timeout_option(app, options->timeout);
  add_worker_option(app, options->workers);
  app.footer(
      "Every fault is shrunk to the least scene that still has it. What it finds does not depend on the "
      "number\n"
      "of jobs. Exit code 1: there is a fault.");
  return [=, &context] { return hunt_all(context, *options); };
}

}  // namespace cylon::cli
