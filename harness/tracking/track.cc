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
    {"compare", "Two builds side by side: what is slower, what is less accurate, and is that real",
     add_track_compare},
    {"gate", "The same for continuous integration: fails where a regression is confirmed over all cells",
     add_track_gate},
    {"list", "The runs of the history, or the values of one run", add_track_list},
    {"history", "Since when it is slower or less accurate: every series, with its change points",
     add_track_history},
    {"ack", "Acknowledge a change of the history, with a note, or mark it as fixed", add_track_ack},
    {"ignore", "Mark a change of the history as one that does not matter", add_track_ignore},
    {"import", "Add results from JSON Lines, CSV or Google Benchmark's JSON", add_track_import},
    {"export", "Write the history as JSON Lines, CSV or Google Benchmark's JSON", add_track_export},
    {"pin", "Keep an engine's binary as the anchor to which times are held", add_track_pin},
    {"check", "Whether every value of the history is still the one that was stored", add_track_check},
};

}  // namespace

void add_store_option(App& app, std::string& file) {
  file = default_store;
  app.add_option("--store", file, "The file of the history")->type_name("FILE")->capture_default_str();
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
