// Some jobs at one time.
#pragma once

#include <atomic>
#include <cstddef>
#include <exception>
#include <thread>
#include <vector>

namespace cylon::study {

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
  std::vector<std::thread> threads;
  for (int w = 1; w < workers && static_cast<std::size_t>(w) < count; ++w) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  for (const std::exception_ptr& error : errors)
    if (error) std::rethrow_exception(error);
}

}  // namespace cylon::study
