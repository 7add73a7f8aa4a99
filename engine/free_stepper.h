// Bodies on which nothing but uniform gravity acts: closed form from t = 0, so that no error grows with the
// steps.
#pragma once

#include "engine/free_rotation.h"
#include "engine/model.h"
#include "engine/stepper.h"

#include <cstdint>

namespace cylon::engine {

///   p = p_0 + v_0 t + g t^2/2,  K = m (v_0 + g t),  R by FreeRotation,  L constant
class FreeStepper final : public Stepper {
 public:
  FreeStepper(const Model&, Time dt);

  void step() override { ++steps_; }
  void read(std::vector<Motion>&) const override;
  void read_turns(std::vector<Real>& turns) const override { turns.clear(); }
  /// Of reading each step.
  std::int64_t operations() const override { return steps_ * static_cast<std::int64_t>(bodies_.size()); }

 private:
  std::vector<Body> bodies_;
  std::vector<Motion> start_;
  std::vector<FreeRotation> rotations_;
  std::vector<Vector3> gravity_;  // one per body
  Time dt_;
  std::int64_t steps_ = 0;
};

}  // namespace cylon::engine
