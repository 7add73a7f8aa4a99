#include "harness/view/lane.h"

#include <fmt/format.h>

#include <utility>

namespace cylon::view {

Lane::Lane(LaneSpec spec, double dt, process::EngineChoice choice, process::Limits limits)
    : spec_(std::move(spec)) {
  setup_.dt = dt;
  setup_.integrator = spec_.integrator;
  thread_ = std::make_unique<LaneThread>(std::move(choice), limits);
}

void Lane::begin_at(core::Scene scene, double t) {
  scene_ = std::move(scene);
  state_ = core::initial_state(scene_);
  contacts_.clear();
  begun_at_ = t;
  steps_ = 0;
  due_ = true;
  ++beginnings_;
  status_ = Status::running;
  reason_.clear();
}

void Lane::start(std::int64_t n) {
  if (!running() || (n == 0 && !due_)) return;
  LaneTask task;
  if (std::exchange(due_, false)) task.scene = scene_;
  task.setup = setup_;
  task.steps = asked_ = n;
  thread_->begin(std::move(task));
  busy_ = true;
}

bool Lane::finish() {
  if (!std::exchange(busy_, false)) return false;
  LaneResult result = thread_->wait();
  if (result.status != results::Status::pass) {
    status_ = result.status == results::Status::unsupported ? Status::unsupported : Status::failed;
    reason_ = fmt::format("{}: {}", results::name(result.status), result.reason);
    contacts_.clear();
    return true;
  }
  if (!result.piece) return true;
  steps_ += asked_;
  state_ = std::move(result.piece->state);
  contacts_ = std::move(result.piece->contacts);
  // A quarter of what is new: smooth to look at, and a collision shows within a few pieces.
  const double now = result.piece->cpu_seconds / (static_cast<double>(asked_) * setup_.dt);
  cost_ = cost_ ? *cost_ + (now - *cost_) / 4 : now;
  return true;
}

}  // namespace cylon::view
