// What Ctrl-C means while engines run.  While files are read and truths are solved it has its default
// meaning, and ends the program.
#pragma once

#include <atomic>
#include <stdexcept>

namespace cylon::process {

/// Set it (a signal handler may) and every call that waits for a child kills it and throws Interrupted.
std::atomic<bool>& interrupted();

struct Interrupted : std::runtime_error {
  Interrupted() : std::runtime_error("interrupted") {}
};

/// Whether the work came to its end; false where it was interrupted.
template <class Work>
bool completes(const Work& work) {
  try {
    work();
    return true;
  } catch (const Interrupted&) {
    return false;
  }
}

/// While it lives, the first SIGINT or SIGTERM sets interrupted(), so that what is done can be told; a second
/// one has its default action.  One at a time; make it after everything is read.
class Interruptible {
 public:
  Interruptible();
  ~Interruptible();
  Interruptible(const Interruptible&) = delete;
  Interruptible& operator=(const Interruptible&) = delete;
};

}  // namespace cylon::process
