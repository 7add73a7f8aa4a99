#include "harness/cli/patience.h"

#include <chrono>
#include <thread>

namespace cylon::cli {

bool locks_in_a_moment(const std::function<bool()>& lock) {
  using Clock = std::chrono::steady_clock;
  for (const auto end = Clock::now() + std::chrono::seconds(1);;) {
    if (lock()) return true;
    if (Clock::now() >= end) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(20));
  }
}

}  // namespace cylon::cli
