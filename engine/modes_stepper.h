// Points on linear springs: closed form from t = 0 by normal modes, so that no error grows with the steps.
#pragma once

#include "engine/normal_modes.h"
#include "engine/stepper.h"

#include <cstdint>

namespace cylon::engine {

/// With v = dq/dt and f the share of a force that goes as cos(W t), in a mode of frequency w:
///   q = v sin(w t)/w + f S_c S_d/2,  S_x = sin(x t)/x,  c = (w + W)/2,  d = (w - W)/2
/// as (cos W t - cos w t)/(w^2 - W^2) = S_c S_d/2, which holds at resonance and at w = 0 too.
class ModesStepper final : public Stepper {
 public:
  /// Requires normal_modes(model).why_not to be empty.
  ModesStepper(const Model&, Time dt);

  void step() override { ++steps_; }
  void advance(std::int64_t n) override { steps_ += n; }
  void read(std::vector<Motion>&) const override;
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  /// Of reading each step.
  std::int64_t operations() const override;

 private:
  std::vector<Body> bodies_;
  std::vector<Motion> start_;
  std::vector<ModeGroup> groups_;
  Time dt_;
  std::int64_t steps_ = 0;
};

}  // namespace cylon::engine
