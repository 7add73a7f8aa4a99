// Processes on one machine that measure times: two of them on one core would measure each other.
#pragma once

#include <vector>

namespace cylon::cli {

/// Holds a lock of every core that this process may use (cores.h), a file in the temporary folder, until its end.  Where that
/// folder cannot be written there is no lock.
class TimedCores {
 public:
  /// Where another process has a core: wait for its end, or go on.  Either is said on stderr.
  enum class Taken { wait, warn };
  explicit TimedCores(Taken);
  ~TimedCores();
  TimedCores(const TimedCores&) = delete;
  TimedCores& operator=(const TimedCores&) = delete;

 private:
  std::vector<int> files_;
};

}  // namespace cylon::cli
