#include "harness/study/cell_pool.h"

#include "harness/core/input_error.h"
#include "harness/study/metamorphic.h"
#include "harness/study/row.h"
#include "harness/study/theory.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <exception>
#include <mutex>
#include <utility>

namespace cylon::study {
namespace {

using results::Status;
using results::Verdict;

using Ask = std::vector<Verdict> (*)(const Cell&, const process::Limits&, const scenario::Expectations&);

// One row for each claim of a cell that has no run to be judged by.
std::vector<Verdict> without_run(const Cell& cell, const scenario::Expectations& expectations, Status status,
                                 const std::string& why) {
  std::vector<std::string> labels;
  if (cell.exam == Exam::claims)
    for (const core::Claim& claim : cell.scenario->claims) labels.push_back(claim.label);
  if (labels.empty()) labels.emplace_back(cell.exam == Exam::theory ? "theory" : "relations");
  std::vector<Verdict> rows;
  for (const std::string& label : labels) {
    Verdict row = open_row(cell, label, expectations);
    row.status = status;
    row.detail = why;
    rows.push_back(std::move(row));
  }
  return rows;
}

Ask examination(Exam exam) {
  switch (exam) {
    case Exam::relations:
      return relate;
    case Exam::theory:
      return theorize;
    case Exam::claims:
      break;
  }
  return run;
}

}  // namespace

Matrix run(const std::vector<Cell>& cells, const Pool& pool, const scenario::Expectations& expectations,
           const CellDone& done) {
  Matrix matrix;
  matrix.rows.resize(cells.size());
  std::vector<std::string> refused(cells.size()), failed(cells.size());
  const Next next = pool.next ? pool.next : in_order(cells.size());
  std::atomic<bool> stop = false;
  std::exception_ptr of_done;
  std::mutex reporting;

  // Whether the cell has rows that hold.
  const auto run_cell = [&](std::size_t i) {
    try {
      matrix.rows[i] = examination(cells[i].exam)(cells[i], pool.limits, expectations);
    } catch (const process::Interrupted&) {
      stop = true;
      return false;
    } catch (const core::InputError& error) {
      refused[i] = error.what();
      matrix.rows[i] = without_run(cells[i], expectations, Status::unsupported, error.what());
    } catch (const std::exception& error) {  // no process, no memory
      failed[i] = fmt::format("the harness failed: {}", error.what());
      matrix.rows[i] = without_run(cells[i], expectations, Status::crash, failed[i]);
      return false;
    }
    return true;
  };
  const auto work = [&] {
    while (!stop) {
      const std::optional<std::size_t> given = next();
      if (!given) return;
      const std::size_t i = *given;
      const auto start = std::chrono::steady_clock::now();
      if (!run_cell(i)) continue;
      const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
      const std::scoped_lock lock(reporting);
      try {
        if (done && !of_done) done(i, matrix.rows[i], seconds.count());
      } catch (...) {  // it cannot be kept, nor can the next
        of_done = std::current_exception();
        stop = true;
      }
    }
  };
  on_threads(std::min(cells.size(), static_cast<std::size_t>(std::max(1, pool.workers))), work);
  if (of_done) std::rethrow_exception(of_done);
  matrix.interrupted = stop;
  const auto tell = [&](std::vector<std::string>& from, std::vector<std::string>& to) {
    for (std::size_t i = 0; i < cells.size(); ++i)
      if (!from[i].empty())
        to.push_back(fmt::format("{} on {}: {}", cells[i].scenario->name, cells[i].engine.id, from[i]));
  };
  tell(refused, matrix.refused);
  tell(failed, matrix.failed);
  return matrix;
}

}  // namespace cylon::study
