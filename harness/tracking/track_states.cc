// cylon track ack, cylon track ignore: notes of users on a change in the history.
#include "harness/cli/command_line.h"
#include "harness/cli/provenance_now.h"
#include "harness/tracking/track.h"
#include "harness/tracking/track_history_rows.h"

#include <fmt/format.h>

#include <iostream>
#include <map>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

struct Options {
  std::string file, note;
  std::vector<std::string> ids;
  bool fixed = false;
};

struct Known {
  const HistoryRow* row;
  const HistoryChange* change;
};

[[noreturn]] void refuse(const std::string& id, const std::vector<std::string>& ids) {
  const std::string nearest = core::did_you_mean(id, ids);
  throw core::InputError(
      fmt::format("no change '{}' in the history{}; `cylon track history --changes` shows {}", id, nearest,
                  ids.empty() ? "none" : fmt::format("{}", ids.size())));
}

// All ids first, so that one that is wrong changes nothing.
int set_states(const Options& options, const std::string& state) {
  store::Store store = store::Store::open(options.file, store::Mode::write);
  const std::vector<HistoryRow> rows = history_rows(store);
  std::map<std::string, Known> known;
  std::vector<std::string> ids;
  for (const HistoryRow& row : rows)
    for (const HistoryChange& change : row.changes)
      if (known.emplace(change.id, Known{&row, &change}).second) ids.push_back(change.id);
  for (const std::string& id : options.ids)
    if (!known.contains(id)) refuse(id, ids);
  store.in_one_transaction([&] {
    for (const std::string& id : options.ids) {
      const auto& [row, change] = known.at(id);
      store.set({.series = row->series,
                 .revision = row->points[change->index].revision,
                 .state = state,
                 .date = now(),
                 .note = options.note.empty() ? change->note : options.note});
    }
  });
  for (const std::string& id : options.ids) {
    const auto& [row, change] = known.at(id);
    std::cout << plain_line(fmt::format("{} {}: {} {} at {}", id, state, row->cell.name(), row->metric.name,
                                        row->points[change->index].revision))
              << '\n';
  }
  return ok;
}

std::shared_ptr<Options> add_options(App& app) {
  auto options = std::make_shared<Options>();
  app.add_option("id", options->ids, "The change's eight digits, from `cylon track history`")
      ->type_name("ID")
      ->required();
  app.add_option("--note", options->note, "Reason of the change. Default: the present note stays")
      ->type_name("TEXT");
  add_store_option(app, options->file);
  return options;
}

}  // namespace

Command add_track_ack(App& app, const Context&) {
  const auto options = add_options(app);
  app.add_flag("--fixed", options->fixed, "Mark the change as fixed");
  return [options] { return set_states(*options, options->fixed ? "fixed" : "active"); };
}

Command add_track_ignore(App& app, const Context&) {
  const auto options = add_options(app);
  return [options] { return set_states(*options, "ignored"); };
}

}  // namespace cylon::tracking
