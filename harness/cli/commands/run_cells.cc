#include "harness/cli/commands/run_cells.h"

#include "harness/cli/commands/run_progress.h"
#include "harness/study/matrix.h"

#include <fmt/format.h>

#include <algorithm>
#include <iostream>
#include <iterator>
#include <string>
#include <utility>

namespace cylon::cli {

using results::Verdict;

std::vector<Verdict> run_cells(const Context& context, const RunOptions& options,
                               const scenario::Expectations& expectations, const Journal::Content& last,
                               Journal& journal, const std::vector<study::Cell>& cells) {
  std::vector<std::vector<Verdict>> rows(cells.size());
  std::vector<std::string> keys;
  std::vector<std::size_t> todo;
  std::vector<study::Cell> to_run;
  for (std::size_t i = 0; i < cells.size(); ++i) {
    keys.push_back(cell_key(cells[i], expectations.hash()));
    const auto found = options.resume ? last.cells.find(keys[i]) : last.cells.end();
    if (found != last.cells.end()) {
      rows[i] = found->second;
    } else {
      todo.push_back(i);
      to_run.push_back(cells[i]);
    }
  }
  if (options.resume)
    std::cerr << fmt::format("resumed: {} of {} cells are done already\n", cells.size() - todo.size(),
                             cells.size());

  Progress progress(context.progress, to_run.size());
  const study::Pool pool{.workers = worker_count(options.jobs),
                         .limits = {.run_seconds = options.timeout,
                                    .memory_bytes = static_cast<std::size_t>(options.memory * 1073741824.0)}};
  auto fresh =
      study::run(to_run, pool, expectations, [&](std::size_t i, const std::vector<Verdict>& verdicts) {
        journal.add(keys[todo[i]], to_run[i], verdicts);
        progress.done(to_run[i], verdicts);
      });
  progress.clear();
  for (std::size_t i = 0; i < todo.size(); ++i) rows[todo[i]] = std::move(fresh[i]);
  std::vector<Verdict> flat;
  for (auto& cell : rows) std::move(cell.begin(), cell.end(), std::back_inserter(flat));
  return flat;
}

}  // namespace cylon::cli
