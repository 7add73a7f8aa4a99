// Keeps the motion of a lane since it was last begun, in bounded memory.
#pragma once

#include "harness/view/lane.h"

#include <cstdint>
#include <vector>

namespace cylon::view {

class Recorder {
 public:
  /// Numbers of bodies times samples: beyond it every other sample is dropped, and of those to come as many.
  static constexpr std::size_t most = 40'000;

  /// Starts over where the lane was begun anew; else keeps its state, one of as many as there is room for.
  void observe(const Lane&);
  void forget() { *this = {}; }

  /// Nothing has moved since the start.
  bool empty() const { return last_step_ == 0; }

  const core::Scene& scene() const { return scene_; }  ///< With the initial state of what follows.
  const LaneSpec& spec() const { return spec_; }
  double dt() const { return dt_; }
  const std::vector<std::int64_t>& steps() const {
    return steps_;
  }  ///< Ascending from 0; the last may be missing.
  const std::vector<core::State>& states() const { return states_; }
  std::int64_t last_step() const { return last_step_; }
  const core::State& last_state() const { return last_state_; }

 private:
  std::uint64_t beginning_ = 0;
  core::Scene scene_;
  LaneSpec spec_;
  double dt_ = 0;
  std::vector<std::int64_t> steps_;
  std::vector<core::State> states_;
  std::int64_t last_step_ = 0;
  core::State last_state_;
  std::size_t stride_ = 1, seen_ = 0;
};

}  // namespace cylon::view
