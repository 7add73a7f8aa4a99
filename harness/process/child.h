// One child process at arm's length: spawned, fed, drained, limited, and always reaped.  Knows no protocol.
#pragma once

#include "harness/process/byte_queue.h"
#include "harness/process/failure.h"
#include "harness/process/family.h"
#include "harness/process/interruption.h"
#include "harness/process/spawn.h"

#include <sys/types.h>

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::process {

/// A process in a group of its own, with its stdin, stdout and stderr on pipes.  It dies with this object, or
/// with the thread that made it.  One object belongs to one thread; several threads may each have theirs.
class Child {
 public:
  /// `command` is looked up in PATH; `memory_bytes` limits the resident size of it and its descendants
  /// together, 0: no limit.
  /// Throws Failure(unsupported, "cannot start …") where exec fails.
  Child(const std::vector<std::string>& command, std::size_t memory_bytes, const Inherited& = {});
  ~Child();
  Child(const Child&) = delete;
  Child& operator=(const Child&) = delete;

  /// From now on, waiting for more than `seconds` throws Failure(timeout) that names `task`.
  void set_deadline(double seconds, std::string task);
  /// The same deadline, for another task.
  void set_task(std::string task) { task_ = std::move(task); }

  /// Queues bytes for its stdin; receive() writes them as the child takes them.
  void send(std::string_view bytes) { unsent_ += bytes; }

  /// Waits for output, writing what is queued and draining stderr meanwhile; false at the end of its output,
  /// or when it has exited and nothing is left to read, whoever else holds the pipe. Throws Failure on
  /// deadline or memory limit, Interrupted.
  bool receive();

  /// What was received and not consumed yet.  Valid until the next receive().
  std::string_view output() const { return output_.view(); }
  void consume(std::size_t bytes) { output_.consume(bytes); }

  /// After receive() gave false: waits a little for the exit and tells it as a Failure: crash with the signal
  /// or the exit code and the last line of stderr; protocol where it closed its output but lives on.
  Failure ending();

  /// Closes its stdin and gives it `seconds` to exit by itself.  Returns "", or "SIGSEGV" when it died of a
  /// signal.
  std::string finish(double seconds);

  /// SIGKILL to it and all its descendants, and reaps them.
  void kill();

  /// The most that was resident of it so far [bytes]; 0 where it is gone.
  std::size_t peak_bytes() const;

  /// CPU time of the process itself so far, all its threads [s]; NaN where it is gone.
  double cpu_seconds() const;

  /// The same of its whole family (family.h).
  double family_cpu_seconds() const;

  /// The last bytes that it wrote to stderr, at most 4 KiB, from the start of a line where possible.
  std::string complaints() const;

 private:
  using Clock = std::chrono::steady_clock;
  void end_group();  // without any memory; it itself is reaped
  void check_limits();
  void poll_once(int timeout_ms);
  void write_some();
  void read_output();
  void read_errors();
  void drain_errors();
  bool has_exited();
  bool exited_within(double seconds);

  std::vector<std::string> command_;
  std::string mark_ = new_mark();
  pid_t pid_ = -1;
  std::optional<Owned> owned_;
  int signal_ = 0, code_ = 0;          // how it ended
  int in_ = -1, out_ = -1, err_ = -1;  // our ends
  std::string unsent_, errors_;
  ByteQueue output_;
  std::size_t sent_ = 0, memory_bytes_;
  bool output_ended_ = false;
  Clock::time_point deadline_ = Clock::time_point::max(), next_check_ = Clock::time_point::min(),
                    next_count_ = Clock::time_point::min();
  double deadline_seconds_ = 0;
  std::string task_;
};

}  // namespace cylon::process
