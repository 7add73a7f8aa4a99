// Many runs in one worker.
#pragma once

#include "harness/process/client.h"

#include <memory>

namespace cylon::process {

/// One worker for many runs, one after another: a run of a few milliseconds costs no process of its own.  A run that does not
/// pass ends the worker, and the next one starts afresh.  Belongs to one thread, and dies with it.
class Session {
 public:
  Session(EngineChoice, const Limits&);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// As run() above, with the limit of memory over all runs so far; repetitions are refused (std::invalid_argument), and what the
  /// worker writes to stderr is told of runs that do not pass alone.
  RunOutcome run(const RunRequest&);

 private:
  struct Worker;
  EngineChoice choice_;
  Limits limits_;
  std::unique_ptr<Worker> worker_;
};

}  // namespace cylon::process
