// Some jobs at one time.
#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
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

/// Calls job(i) for i in [0, count), `workers` at one time, in no order.  After the first exception no
/// further job starts; that of the lowest i is thrown once all have ended.
template <class Job>
void in_parallel(std::size_t count, int workers, const Job& job) {
  std::vector<std::exception_ptr> errors(count);
  std::atomic<std::size_t> next = 0;
  std::atomic<bool> stop = false;
  const auto work = [&] {
    for (std::size_t i = 0; !stop && (i = next++) < count;) try {
        job(i);
      } catch (...) {
        errors[i] = std::current_exception();
        stop = true;
      }
  };
  on_threads(std::min(count, static_cast<std::size_t>(std::max(1, workers))), work);
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace cylon::study
