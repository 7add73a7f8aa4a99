// Some jobs at one time.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <system_error>
#include <thread>
#include <vector>

namespace cylon::study {

/// Calls work() on `workers` threads at one time, this one among them, and returns when all have ended.
/// Where the system has no thread left, fewer do the same work.
template <class Work>
void on_threads(std::size_t workers, const Work& work) {
  std::vector<std::jthread> threads;
  try {
    for (std::size_t i = 1; i < workers; ++i) threads.emplace_back(work);
  } catch (const std::system_error&) {
  }
  work();
}

/// Gives out each of some indices once; nothing once all are given out.  Called by several threads at one time.
using Next = std::function<std::optional<std::size_t>()>;

/// 0, 1, … count - 1.
inline Next in_order(std::size_t count) {
  return [count, next = std::make_shared<std::atomic<std::size_t>>(0)]() -> std::optional<std::size_t> {
    const std::size_t i = (*next)++;
    return i < count ? std::optional(i) : std::nullopt;
  };
}

/// Calls job(i) for every i < count that `next` gives out, `workers` at one time, in no order.  After the first
/// exception no further job starts; that of the lowest i is thrown once all have ended.
template <class Job>
void in_parallel(std::size_t count, int workers, const Job& job, const Next& next) {
  std::vector<std::exception_ptr> errors(count);
  std::atomic<bool> stop = false;
  const auto work = [&] {
    while (!stop) {
      const std::optional<std::size_t> i = next();
      if (!i) return;
      try {
        job(*i);
      } catch (...) {
        errors[*i] = std::current_exception();
        stop = true;
      }
    }
  };
  on_threads(std::min(count, static_cast<std::size_t>(std::max(1, workers))), work);
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

/// The same for all i in [0, count).
template <class Job>
void in_parallel(std::size_t count, int workers, const Job& job) {
  in_parallel(count, workers, job, in_order(count));
}

}  // namespace cylon::study
