// A known slow-down of a build that shows that comparisons find it (docs/ci.md); none in any other.
#pragma once

#include <ctime>

#ifndef CYLON_INJECT_SLOWDOWN
#define CYLON_INJECT_SLOWDOWN 0  // percent of the CPU time of what is slowed
#endif

namespace cylon::simulators {

/// Does `work`; then keeps the processor busy for that fraction of the CPU time that the work took.  What
/// falls short of the clock's own cost is owed to the next call.  The work's result is not touched.
template <class Work>
void slowed(const Work& work) {
  if constexpr (CYLON_INJECT_SLOWDOWN <= 0) {
    work();
  } else {
    const auto now = [] {  // [s]
      timespec t{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &t);
      return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
    };
    static double owed = 0;
    const double begin = now();
    work();
    const double end = now();
    owed += 0.01 * CYLON_INJECT_SLOWDOWN * (end - begin);
    if (owed < 2e-6) return;
    double spent = 0;
    while (spent < owed) spent = now() - end;
    owed -= spent;
  }
}

}  // namespace cylon::simulators
