#include "harness/view/recorder.h"

namespace cylon::view {

void Recorder::observe(const Lane& lane) {
  if (!lane.running()) return;
  if (steps_.empty() || beginning_ != lane.beginnings()) {
    forget();
    beginning_ = lane.beginnings();
    scene_ = lane.scene();
    spec_ = lane.spec();
    dt_ = lane.dt();
    steps_ = {0};
    states_ = {core::initial_state(scene_)};
  }
  if (lane.steps() == last_step_) return;
  last_step_ = lane.steps();
  last_state_ = lane.state();
  if (++seen_ % stride_ != 0) return;
  steps_.push_back(last_step_);
  states_.push_back(last_state_);
  if (states_.size() < 64 || states_.size() * scene_.bodies.size() <= most) return;
  std::size_t kept = 0;
  for (std::size_t i = 0; i < steps_.size(); i += 2, ++kept) {
    steps_[kept] = steps_[i];
    std::swap(states_[kept], states_[i]);
  }
  steps_.resize(kept);
  states_.resize(kept);
  stride_ *= 2;
}

}  // namespace cylon::view
