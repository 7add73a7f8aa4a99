// A worker and all that descend from it, wherever they have gone: children of its own, and those that left
// its group or lost their parent.
#pragma once

#include <sys/types.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <vector>

namespace cylon::process {

/// From now on, processes below this one that lose their parent become children of this one, not of init.
void adopt_orphans();

/// A child that its owner waits for, until this ends.  Hold births() from its fork until it is one of these,
/// so that nobody takes it for an orphan.
class Owned {
 public:
  explicit Owned(pid_t);
  ~Owned();
  Owned(const Owned&) = delete;
  Owned& operator=(const Owned&) = delete;

 private:
  pid_t pid_;
};
std::mutex& births();

/// "CYLON_WORKER=<this process>.<n>", another at every call: what a worker's descendants inherit in their
/// environment, so that an orphan is known to be of its family.
std::string new_mark();

class Family {
 public:
  Family(pid_t worker, std::string mark) : worker_(worker), mark_(std::move(mark)) {}

  /// Memory of the worker and its descendants together [bytes]: what is resident, and the open files that are in memory
  /// and have no name (memfd_create); what several share counts once.  Looks through all processes of the machine.
  std::size_t memory() const;

  /// CPU time of the worker and its descendants together [s]; of what ended below them and was waited for in ticks of the kernel (10 ms).
  double cpu_seconds() const;

  /// SIGKILL to the worker, its group and all descendants, again until none is left, and reaps them;
  /// the worker itself is the caller's to reap.  An orphan that shows no environment is waited for, because
  /// a program that is just starting shows none either; after a thousand looks it is killed.  A
  /// descendant that writes another environment and outlives its parents escapes.
  void kill();

  /// Reaps every child of this process that has ended and is nobody's own; call it when the worker is gone.
  static void reap_orphans();

 private:
  struct Relative {
    pid_t pid = 0, parent = 0, group = 0;
    bool dead = false;     // a zombie
    bool unknown = false;  // an orphan without an environment: perhaps of another family
  };
  static std::vector<Relative> processes();
  std::vector<Relative> living() const;

  pid_t worker_;
  std::string mark_;
};

}  // namespace cylon::process
