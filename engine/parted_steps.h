// Steps in equal parts: for a run whose steps are only the times at which it is looked at.
#pragma once

#include "engine/model.h"
#include "engine/stepper.h"

#include <cstdint>
#include <memory>

namespace cylon::engine {

/// In how many parts a step of EventStepper goes where its integrator controls the error, so that `dt` is only how often
/// the motion is looked at.  What EventStepper leaves out of the laws of contact it leaves out for at most a step of its
/// own.  A step of up to h goes as it is, a longer one in parts of at most h/4:
///   h = sqrt(r/g)/4,
/// in which a body falls by r/32; r the least half-width of what can touch or be held by a limit or by dry friction [m].
/// 1 without gravity; at most 10^6, beyond which they are longer.
std::int64_t parts_of_step(const Model&, Time dt);

/// Goes `parts` steps of `run`, each dt/parts long, in each of its own.
class PartedSteps final : public Stepper {
 public:
  /// `start`: time at which the run starts [s].
  PartedSteps(std::unique_ptr<Stepper> run, std::int64_t parts, Time dt, Time start);

  void step() override;
  void read(std::vector<Motion>& motions) const override { run_->read(motions); }
  void read_turns(std::vector<Real>& turns) const override { run_->read_turns(turns); }
  const std::vector<Impact>& impacts() const override { return impacts_; }
  /// In the last part.
  bool struck() const override { return run_->struck(); }
  void keep_contacts(bool keep) override {
    Stepper::keep_contacts(keep);
    run_->keep_contacts(keep);
  }
  const Real* works() const override { return run_->works(); }
  std::vector<Diagnostic> diagnostics() const override { return run_->diagnostics(); }
  std::int64_t operations() const override { return run_->operations(); }
  bool gave_up() const override { return run_->gave_up(); }
  bool ran_out() const override { return run_->ran_out(); }

 private:
  void add_contacts();

  std::unique_ptr<Stepper> run_;
  std::int64_t parts_, part_ = 0, step_ = 0;  // counted from t = 0
  std::vector<Impact> impacts_;
};

}  // namespace cylon::engine
