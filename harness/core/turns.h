// Whole turns of joints: what a state does not tell, and the states before it do.
#pragma once

#include "harness/core/claim.h"
#include "harness/core/held_joint.h"
#include "harness/core/observable.h"
#include "harness/core/recording.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::core {

/// Observes a motion state by state.  An energy is that of springs and forces on angles which have turned any number of
/// times, where evaluate() has the angle within half a turn of its start: of all values 2 pi apart, an angle takes the
/// one nearest to where its rates lead from the state before,
///   q = q_before + (q'_before + q'_now) dt/2.
/// Where it comes nowhere near one of them (more than a quarter turn off), turns are lost, and energies NaN from there on.
class AlongMotion {
 public:
  AlongMotion(const Observable&, const Scene&);

  /// The values of a state; times ascend [s], and the motion begins with the scene's at t = 0.
  void evaluate(double time, const State&, Values&);

  /// Whether every state of a motion matters, not only those that are evaluated.
  bool counts() const { return !angles_.empty(); }
  bool lost() const { return lost_; }

 private:
  struct Angle {
    std::size_t joint = 0;  ///< In joints_.
    JointAngle law;
    double turned = 0;  ///< Since t = 0 [rad].
    double rate = 0;    ///< [rad/s]
  };

  void follow(double time, const State&);
  double beyond(const State&) const;

  const Observable& observable_;
  const Scene& scene_;
  std::vector<HeldJoint> joints_;
  std::vector<Angle> angles_;
  double time_ = 0;
  bool lost_ = false;
};

/// What of a recording, or of the claim's truth at its times, cannot be told since angles turn too far from one state to
/// the next; or nothing.
std::optional<std::string> untold_turns(const Claim&, const Scene&, const Recording&);

}  // namespace cylon::core
