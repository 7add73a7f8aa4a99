#include "harness/process/step_timer.h"

#include <time.h>

#include <algorithm>
#include <chrono>

namespace cylon::process {
namespace {

constexpr std::int64_t most_timed_apart = 1000;  // bursts of a run; the CPU clock costs 0.2 us

double wall_ns() {
  using Clock = std::chrono::steady_clock;
  return std::chrono::duration<double, std::nano>(Clock::now().time_since_epoch()).count();
}

// What two readings of a clock in a row differ by: the least of some.
template <class Read>
double clock_cost_ns(const Read& read) {
  double least = 1e9;
  for (int i = 0; i < 64; ++i) {
    const double before = read();
    least = std::min(least, read() - before);
  }
  return least;
}

}  // namespace

double process_cpu_ns() {
  timespec t;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
  return 1e9 * static_cast<double>(t.tv_sec) + static_cast<double>(t.tv_nsec);
}

StepTimer::StepTimer(std::int64_t bursts)
    : few_(bursts <= most_timed_apart), cost_(clock_cost_ns(few_ ? process_cpu_ns : wall_ns)) {}

void StepTimer::begin_batch() {
  if (!few_) cpu_ = process_cpu_ns(), wall_ = wall_ns(), inside_ = 0;
}

void StepTimer::begin_burst() { burst_ = few_ ? process_cpu_ns() : wall_ns(); }

void StepTimer::end_burst() {
  const double took = std::max(0.0, (few_ ? process_cpu_ns() : wall_ns()) - burst_ - cost_);
  (few_ ? total_ : inside_) += took;
}

void StepTimer::end_batch() {
  if (few_) return;
  const double cpu = process_cpu_ns() - cpu_, wall = wall_ns() - wall_;
  total_ += cpu * std::min(1.0, inside_ / std::max(wall, 1.0));
}

}  // namespace cylon::process
