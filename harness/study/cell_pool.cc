#include "harness/study/cell_pool.h"

#include "harness/study/metamorphic.h"
#include "harness/study/theory.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>

namespace cylon::study {
namespace {

using Ask = std::vector<results::Verdict> (*)(const Cell&, const process::Limits&,
                                              const scenario::Expectations&);

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

std::vector<std::vector<results::Verdict>> run(const std::vector<Cell>& cells, const Pool& pool,
                                               const scenario::Expectations& expectations,
                                               const CellDone& done) {
  std::vector<std::vector<results::Verdict>> rows(cells.size());
  std::vector<std::exception_ptr> errors(cells.size());
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  std::mutex reporting;

  const auto work = [&] {
    for (std::size_t i = 0; !stop && (i = next++) < cells.size();) {
      try {
        rows[i] = examination(cells[i].exam)(cells[i], pool.limits, expectations);
        const std::scoped_lock lock(reporting);
        if (done) done(i, rows[i]);
      } catch (...) {
        errors[i] = std::current_exception();
        stop = true;
      }
    }
  };
  const std::size_t workers = std::min(cells.size(), static_cast<std::size_t>(std::max(1, pool.workers)));
  std::vector<std::thread> threads;
  for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
  return rows;
}

}  // namespace cylon::study
