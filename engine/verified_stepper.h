// The integrator `auto`: a bound on the global error, shown by two runs that must agree.
#pragma once

#include "engine/stepper.h"

#include <cstdint>
#include <functional>
#include <memory>

namespace cylon::engine {

/// A run from its start with a tolerance for the error made in each of its own steps.
using MakeRun = std::function<std::unique_ptr<Stepper>(Real local_tolerance)>;

/// Runs at a local tolerance and, beside it, at a tenth of that.  Where their samples part by more than
/// `bound` of the motion's scales, both tolerances fall to a tenth and the finer run starts again from its
/// start, up to the same sample.  A sample is the finer run's, and is given out once both agree on it; at the
/// end of what the number type can resolve it is given out all the same, and a diagnostic says how far they part.
/// Where the finer run gave up (Stepper::gave_up()), both may agree and be wrong: nothing is known of the error from there on,
/// a diagnostic says so, and the finer run goes on alone.  A run that is made to refine and gives up is not taken.
/// So it is where a finer run ends before the sample, as it does where rounding leaves no step that is small enough:
/// the two finest runs that go on are taken; where both runs end, none finer is tried.
/// Where the finer run gave up for want of operations, both start again once, at 10^5 of its tolerance and ten times
/// that, with a reserve of operations of their own: what they are given out for parts by a known amount.
/// A sample within a step of an impact may part by as much as the impact changes it; it is compared again one
/// step later.  Of the last sample of a run a diagnostic says so.
class VerifiedStepper final : public Stepper {
 public:
  /// `first`: the step at which the runs start.  `reserve`: operations that all runs share, if they do.
  VerifiedStepper(MakeRun, Real bound, Time dt, std::vector<Body> bodies, std::int64_t first = 0,
                  std::shared_ptr<std::int64_t> reserve = {});

  void step() override;
  void read(std::vector<Motion>& motions) const override { fine_->read(motions); }
  void read_turns(std::vector<Real>& turns) const override { fine_->read_turns(turns); }
  const std::vector<Impact>& impacts() const override { return fine_->impacts(); }
  bool struck() const override { return fine_->struck(); }
  void keep_contacts(bool keep) override {
    Stepper::keep_contacts(keep);
    fine_->keep_contacts(keep);
  }
  const std::vector<Contact>& contacts() const override { return fine_->contacts(); }
  const Real* works() const override { return fine_->works(); }
  std::vector<Diagnostic> diagnostics() const override;
  std::int64_t operations() const override { return spent_ + coarse_->operations() + fine_->operations(); }
  bool gave_up() const override { return fine_->gave_up(); }

 private:
  Real parted();
  bool compare(Real error);  // whether the sample is given out as it is
  std::unique_ptr<Stepper> replay(Real tolerance) const;
  bool tighten();  // whether the finer run goes on
  void loosen();
  bool loosen_far();

  MakeRun make_;
  Real bound_;
  Time dt_;
  Real tolerance_;  // of the finer run
  std::vector<Body> bodies_;
  std::vector<std::size_t> movable_;  // of bodies_
  std::unique_ptr<Stepper> coarse_, fine_;
  std::vector<Motion> coarse_motion_, fine_motion_;
  Real length_ = 0, speed_ = 0,
       turn_ = 0;  // the motion's scales so far, locked bodies included [m, m/s, rad/s]
  std::int64_t first_, steps_ = 0, missed_at_ = -1, unknown_at_ = -1;  // steps since the start
  Real worst_ = 0, last_ = 0;
  std::int64_t spent_ = 0;  // operations of runs that were given up
  std::shared_ptr<std::int64_t> reserve_;
  bool loosened_ = false;  // by loosen_far()
  bool waiting_ = false;   // for a sample away from an impact
};

}  // namespace cylon::engine
