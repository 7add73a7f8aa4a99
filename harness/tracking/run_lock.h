// A run of a store is recorded by one program at a time.
#pragma once

#include "harness/tracking/store/store.h"

#include <cstdint>
#include <string>
#include <utility>

namespace cylon::tracking {

/// Holds run `id` of the store until its end.  On a server the store does so itself; of a file this locks a byte far behind the file's end (an open file
/// description lock, which SQLite's own do not meet), so nothing is left should the process be killed.
class RunLock {
 public:
  /// Make it before the store is opened, so that it ends after: closing the file would release the locks of
  /// SQLite, which belong to the process.
  explicit RunLock(std::string store) : store_(std::move(store)) {}
  ~RunLock();
  RunLock(const RunLock&) = delete;
  RunLock& operator=(const RunLock&) = delete;

  /// Throws core::InputError where another program holds it.
  void hold(store::Store&, std::int64_t id);

 private:
  std::string store_;
  int fd_ = -1;
};

}  // namespace cylon::tracking
