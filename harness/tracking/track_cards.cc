// cylon track cards: what became of the faults that `cylon hunt` found.
#include "harness/cli/command_line.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/workers.h"
#include "harness/tracking/run_lock.h"
#include "harness/tracking/run_words.h"
#include "harness/tracking/track.h"
#include "harness/tracking/track_result.h"

#include "harness/hunt/card.h"
#include "harness/process/interruption.h"

#include <fmt/format.h>

#include <iostream>
#include <memory>
#include <string>
#include <vector>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

namespace fs = std::filesystem;
using results::Status;

struct Options {
  RunWords words;
  std::string folder, store;
  std::vector<std::string> engines;
  Brought brought;
  double timeout = 20;
};

// A fault that is there is a claim that fails; its number goes to 0 when it is fixed.
results::Verdict row_of(const hunt::Kept& card, const hunt::Replayed& now) {
  results::Verdict row;
  row.claim = fmt::format("{} {}", card.oracle, hunt::name(card.kind));
  row.observable = card.oracle, row.unit = now.unit;
  row.measured = now.measured, row.allowed = now.allowed;
  using enum hunt::Replayed::What;
  row.status = now.what == fixed ? Status::pass : now.what == refused ? Status::unsupported : Status::fail;
  row.detail = hunt::name(now.what);
  return row;
}

int record(const Context& context, const Options& options) {
  const auto rows = with_brought(context, options.brought);
  const std::vector<fs::path> files = hunt::card_files(options.folder);
  if (files.empty()) {
    std::cerr << "nothing selected: no card in " << plain(options.folder) << '\n';
    return nothing_selected;
  }
  const process::Limits limits{.run_seconds = options.timeout};
  RunLock lock(options.store);
  store::Store store = store::Store::open(options.store, store::Mode::write);
  store::RunInfo run = run_here(context, options.words);
  run.id = store.begin_run(run);
  lock.hold(store, run.id);
  const process::Interruptible until_told;
  try {
    for (const fs::path& file : files) {
      const hunt::Kept card = hunt::read_card(file.string());
      const scenario::Scenario scenario = scenario::read(file);
      for (const std::string& id : options.engines.empty() ? std::vector{card.engine} : options.engines) {
        study::Cell cell;
        cell.scenario = &scenario, cell.engine = process::parse_engine(id, rows);
        cell.dt = card.trial.step, cell.dt_text = scenario.step_text;
        const hunt::Replayed now = hunt::replay(card, cell.engine, limits);
        process::RunOutcome outcome;
        outcome.engine = process::describe(cell.engine, limits);
        store.add(run.id, result_of(cell, outcome, {row_of(card, now)}));
        std::cout << plain_line(fmt::format("{:<60} {:<24} {}", scenario.name, id, hunt::name(now.what)))
                  << '\n'
                  << std::flush;
      }
    }
  } catch (const process::Interrupted&) {
    std::cerr << "interrupted: the run stays incomplete; begin again\n";
    return interrupted;
  }
  store.finish_run(run.id);
  std::cout << fmt::format("{}: run {}\n", options.store, run.id);
  return ok;
}

}  // namespace

Command add_track_cards(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("FOLDER", options->folder, "Folder of cards that `cylon hunt --cards` wrote")->required();
  add_engines_option(app, options->engines, "each card's own");
  add_run_options(app, options->words);
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  add_store_option(app, options->store);
  app.footer(
      "A card that is fixed is a verdict that passes, with the error 0; one that is still there, or changed, "
      "fails.\n"
      "`cylon track history` shows when that changed. Exits 0 when everything is recorded.");
  return [options, &context] { return record(context, *options); };
}

}  // namespace cylon::tracking
