// A thread with an engine of its own: it makes the worker, and the worker dies with it.  One task at a time.
#pragma once

#include "harness/process/live.h"
#include "harness/results/verdict.h"

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

namespace cylon::view {

struct LaneTask {
  std::optional<core::Scene> scene;  ///< To begin anew from; absent: to go on.
  core::Setup setup;
  std::int64_t steps = 0;  ///< >= 0
};

struct LaneResult {
  results::Status status =
      results::Status::pass;  ///< Else the engine failed; a task with a scene may follow.
  std::string reason;
  std::optional<process::Piece> piece;  ///< Where it passed and there were steps.
};

class LaneThread {
 public:
  LaneThread(process::EngineChoice, process::Limits);
  ~LaneThread();
  LaneThread(const LaneThread&) = delete;
  LaneThread& operator=(const LaneThread&) = delete;

  /// Begins a task; requires that the one before was waited for.
  void begin(LaneTask);
  /// Waits for it.
  LaneResult wait();

 private:
  void serve();
  LaneResult perform(LaneTask&);

  process::EngineChoice choice_;
  process::Limits limits_;
  std::optional<process::LiveRun> run_;  // the thread's alone
  std::mutex mutex_;
  std::condition_variable changed_;
  std::optional<LaneTask> task_;
  std::optional<LaneResult> result_;
  bool stop_ = false;
  std::thread thread_;
};

}  // namespace cylon::view
