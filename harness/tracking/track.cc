#include "harness/tracking/track.h"

#include <fmt/format.h>

#include <csignal>
#include <memory>
#include <utility>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

const std::vector<App::Row> subcommands = {
    {"record", "Run scenarios on engines and add verdicts, errors, hashes, times and memory to the history",
     add_track_record},
    {"cards", "Replay cards of `cylon hunt`, and add what became of each fault to the history",
     add_track_cards},
    {"compare", "Compare the speed and accuracy of two builds, with statistical tests", add_track_compare},
    {"gate", "Compare two builds for continuous integration: fail on a confirmed regression", add_track_gate},
    {"list", "List the runs of the history, or the values of one run", add_track_list},
    {"history", "Show the history of each metric, with its change points", add_track_history},
    {"ack", "Acknowledge a change in the history, with a note, or mark it as fixed", add_track_ack},
    {"ignore", "Mark a change in the history as irrelevant", add_track_ignore},
    {"import", "Add results from JSON Lines, CSV or Google Benchmark's JSON", add_track_import},
    {"export", "Write the history as JSON Lines, CSV or Google Benchmark's JSON", add_track_export},
    {"pin", "Keep an engine binary as the reference for timings", add_track_pin},
    {"check", "Check the history for damage", add_track_check},
};

}  // namespace

void add_store_option(App& app, std::string& file) {
  file = default_store;
  app.add_option("--store", file, "History: a file, or postgresql://USER@HOST/DATABASE")
      ->type_name("FILE|ADDRESS")
      ->capture_default_str();
}

store::RunInfo find_run(const store::Store& store, const std::string& word) {
  if (auto run = store.find_run(word)) return *run;
  throw core::InputError(fmt::format(
      "no run '{}' in the history; `cylon track list` shows numbers, revisions and labels", word));
}

Command add_track(App& app, const Context& context) {
  const auto chosen = std::make_shared<Command>();
  app.add_commands(subcommands, context, [chosen](Command command) { *chosen = std::move(command); });
  return [chosen] {
    // A limit of the file size is then an error like a full disk, and no signal.
    std::signal(SIGXFSZ, SIG_IGN);
    return (*chosen)();
  };
}

}  // namespace cylon::tracking
