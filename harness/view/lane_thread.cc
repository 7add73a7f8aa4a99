#include "harness/view/lane_thread.h"

#include <exception>
#include <utility>

namespace cylon::view {

LaneThread::LaneThread(process::EngineChoice choice, process::Limits limits)
    : choice_(std::move(choice)), limits_(limits), thread_([this] { serve(); }) {}

LaneThread::~LaneThread() {
  {
    const std::lock_guard lock(mutex_);
    stop_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void LaneThread::begin(LaneTask task) {
  {
    const std::lock_guard lock(mutex_);
    task_ = std::move(task);
  }
  changed_.notify_all();
}

LaneResult LaneThread::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return result_.has_value(); });
  return *std::exchange(result_, std::nullopt);
}

void LaneThread::serve() {
  for (;;) {
    std::optional<LaneTask> task;
    {
      std::unique_lock lock(mutex_);
      changed_.wait(lock, [this] { return stop_ || task_.has_value(); });
      if (stop_) break;
      task = std::exchange(task_, std::nullopt);
    }
    LaneResult result = perform(*task);
    {
      const std::lock_guard lock(mutex_);
      result_ = std::move(result);
    }
    changed_.notify_all();
  }
  run_.reset();  // by the thread that made it
}

// Whatever an engine does is the lane's fate and nobody else's.
LaneResult LaneThread::perform(LaneTask& task) {
  LaneResult result;
  const auto failed = [&](results::Status status, const char* reason) {
    result.status = status;
    result.reason = reason;
    run_.reset();
  };
  try {
    if (!run_) run_.emplace(choice_, limits_);
    if (task.scene) run_->load(*task.scene, task.setup);
    if (task.steps > 0) result.piece = run_->advance(task.steps);
  } catch (const process::Failure& failure) {
    failed(failure.status, failure.what());
  } catch (
      const std::exception& error) {  // a setup that the engine calls impossible, or the end of the program
    failed(results::Status::fail, error.what());
  }
  return result;
}

}  // namespace cylon::view
