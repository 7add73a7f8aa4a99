// Many runs in one worker.
#pragma once

#include "harness/process/client.h"

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace cylon::process {

/// One worker for many runs, one after another: a run of a few milliseconds costs no process of its own.  A run that fails
/// ends the worker, and the next one starts afresh; a scene that the engine refuses does not.  Belongs to one thread, and dies
/// with it.
class Session {
 public:
  Session(EngineRow, const Limits&);
  ~Session();
  Session(const Session&) = delete;
  Session& operator=(const Session&) = delete;

  /// As run() in client.h, with the limit of memory over all runs so far; repetitions are refused (std::invalid_argument), and
  /// what the worker writes to stderr is told of runs that fail alone.  The choice is one of the session's engine.
  RunOutcome run(const EngineChoice&, const RunRequest&);

 private:
  struct Worker;
  EngineRow row_;
  Limits limits_;
  std::unique_ptr<Worker> worker_;
};

/// As long as one lives, run() on the thread that made it has one Session for each engine in place of one process for each
/// run (where no repetitions are asked for).  For searches through thousands of short runs, which ask what they find again
/// without it: an engine may carry something over from one run to the next.  They nest; the innermost counts.
class KeptWorkers {
 public:
  KeptWorkers();
  ~KeptWorkers();
  KeptWorkers(const KeptWorkers&) = delete;
  KeptWorkers& operator=(const KeptWorkers&) = delete;

  /// Of this thread; may be none.
  static KeptWorkers* here();
  RunOutcome run(const EngineChoice&, const RunRequest&, const Limits&);

 private:
  using Command = std::vector<std::string>;
  std::map<std::pair<Command, Command>, Session> sessions_;  // by what starts the worker, and the worker
  KeptWorkers* outer_;
};

}  // namespace cylon::process
