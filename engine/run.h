// One island of a scene on its way through time, by the plan that its model asks for.
#pragma once

#include "engine/gimbal_watch.h"
#include "engine/plan.h"
#include "engine/stepper.h"

#include <cstdint>
#include <memory>

namespace cylon::engine {

class Ballistic;

class Run {
 public:
  /// Starts at t = first dt, with the model's motions then; its bodies are those of t = 0.  Requires
  /// unsupported(model, options) to be empty, options.dt > 0, one motion and one shape per body.
  Run(std::shared_ptr<const Model>, const Options&, std::int64_t first = 0);
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;
  ~Run();

  /// Advances by exactly one step.
  void step();

  /// Advances by n steps, n >= 1: the bits of as many step(), for less, as nothing is read between them.
  /// impacts() are then those of the last.
  void advance(std::int64_t n);

  Time time() const { return static_cast<Time>(steps_) * options_.dt; }
  const Plan& plan() const { return plan_; }

  /// Whether the motion goes on in fixed steps with impulses now.
  bool is_stepped() const { return stepped_; }

  /// The motion now, of centres of mass.
  const std::vector<Motion>& motions() const { return motions_; }

  /// What the angles of laws are near to now (Stepper::read_turns).
  void read_turns(std::vector<Real>& turns) const { stepper_->read_turns(turns); }

  /// The impacts of the last step, in order of time.
  const std::vector<Impact>& impacts() const { return impacts_; }

  void keep_contacts(bool keep) { stepper_->keep_contacts(keep_contacts_ = keep); }
  const std::vector<Contact>& contacts() const { return stepper_->contacts(); }
  const Real* works() const { return stepper_->works(); }
  /// What a user must know of the run so far; its island has a method and an order, and no bodies yet.
  std::vector<Diagnostic> diagnostics() const;
  /// Work done so far (Stepper::operations()).
  std::int64_t operations() const { return spent_ + stepper_->operations(); }

 private:
  void hand_over();
  void take_impacts();
  void watch_gimbals();
  std::vector<Diagnostic> diagnostics_of_stepper() const;

  std::shared_ptr<const Model> model_;
  Options options_;
  Plan plan_;
  Time start_;  // [s]
  std::unique_ptr<Stepper> stepper_;
  Ballistic* ballistic_ = nullptr;  // stepper_, while it is one
  DiagnosticLog log_;
  IslandName now_;  // how it moves now
  GimbalWatch gimbals_;
  std::vector<Motion> motions_;
  std::vector<Impact> impacts_;
  std::int64_t steps_, spent_ = 0;  // spent_: operations of the stepper before a handover
  bool keep_contacts_ = false, stepped_ = false;
};

}  // namespace cylon::engine
