#include "harness/cli/commands/run_cells.h"

#include "harness/cli/command_line.h"
#include "harness/cli/progress.h"
#include "harness/results/duration.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <string>
#include <utility>

namespace cylon::cli {
namespace {

using results::Verdict;

// How far a run is: on one line that is written over, on a terminal; nothing elsewhere.
class Progress {
 public:
  Progress(bool on, std::size_t total) : on_(on), total_(total) {}

  void done(const study::Cell& cell, const std::vector<Verdict>& rows) {
    ++finished_;
    if (!on_) return;
    clear();
    if (!std::ranges::all_of(rows, &Verdict::as_expected))
      std::cerr << plain_line(fmt::format("differs: {} on {} at {}", cell.scenario->name, cell.engine.id,
                                          results::step_in_words(cell.dt_text)))
                << '\n';
    show_progress(on_, fmt::format("[{}/{}] {}", finished_, total_,
                                   plain_line(cell.scenario->name + " on " + cell.engine.id)));
  }

  void clear() const { show_progress(on_, ""); }

 private:
  bool on_;
  std::size_t total_, finished_ = 0;
};

// Whether a cell without verdicts is done.
bool asks_nothing(const study::Cell& cell) {
  return cell.exam != study::Exam::claims || cell.scenario->claims.empty();
}

}  // namespace

study::Matrix run_cells(const Context& context, const RunOptions& options,
                        const scenario::Expectations& expectations, const Journal::Content& last,
                        Journal& journal, const std::vector<study::Cell>& cells,
                        const std::optional<Shard>& shard) {
  const bool resume = options.resume && !(shard && shard->farm);  // a farm hands out only what is to be done
  std::vector<std::vector<Verdict>> rows(cells.size());
  std::vector<std::string> keys;
  std::vector<std::size_t> todo;
  std::vector<study::Cell> to_run;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    keys.push_back(cell_key(cells[i], expectations.hash()));
    const auto found = resume ? last.cells.find(keys[i]) : last.cells.end();
    if (found != last.cells.end() && (!found->second.empty() || asks_nothing(cells[i]))) {
      rows[i] = found->second;
    } else {
      todo.push_back(i);
      to_run.push_back(cells[i]);
    }
  }
  if (resume)
    // A union of parts has cells, and no request.
    std::cerr << (last.request || !last.cells.empty()
                      ? fmt::format("resumed: {} of {} cells are done already\n", cells.size() - todo.size(),
                                    cells.size())
                      : "nothing to resume: this folder has no earlier run; all cells run\n");

  Progress progress(context.progress, to_run.size());
  const study::Pool pool{.workers = worker_count(context, options.jobs),
                         .limits = {.run_seconds = options.timeout,
                                    .memory_bytes = static_cast<std::size_t>(options.memory * 1073741824.0)},
                         .next = next_of(shard, to_run.size())};
  study::Matrix fresh = study::run(to_run, pool, expectations,
                                   [&](std::size_t i, const std::vector<Verdict>& verdicts, double seconds) {
                                     journal.add(keys[todo[i]], to_run[i], verdicts, seconds);
                                     progress.done(to_run[i], verdicts);
                                   });
  progress.clear();
  for (std::size_t i = 0; i < todo.size(); ++i) rows[todo[i]] = std::move(fresh.rows[i]);
  fresh.rows = std::move(rows);
  return fresh;
}

}  // namespace cylon::cli
