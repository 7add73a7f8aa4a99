// What an error does when the step is halved says whether it is truncation, which is no fault.
//
//   at every step     e > 10 allowed at dt, dt/2, … dt/16, and what is left of it by a halving is more than 3/4, of the
//                     last one 9/10; an error of first order falls to a half.  One that is as large as its scale lets it
//                     be does not fall, either, until the step is fine enough: above a twentieth of the scale it must
//                     also be there at dt/64, no less than 9/10 of a halving.
//   slow to fall      It is not: truncation, which is no fault, but of what is conserved where dt/16 resolves all rates.
//   own promise       Where the motion is smooth and no more sensitive than most_sensitive.  A scheme that states the order p > 1 errs
//                     by C dt^p: a fault falls by less than 2^-(p - 1/2) three times, while it is small against the
//                     motion.  One that bounds its error by a tolerance errs by no more than
//                     promised = 10 tolerance (what the motion makes of it), and is held to ten times that.
//   coarse step alone e > 10 allowed at dt, perhaps at dt/2, then within allowed at once and less than 2^-(p + 4) of what it was:
//                     no scheme of order p falls so fast.  Of smooth motions whose rates the step resolves: an unstable
//                     scheme does the same, and its remedy is a smaller step.
//   fine steps alone  Where bodies touch: e > 10 allowed at dt/8 and dt/16, and not at dt.  Truncation does not rise.
//   with no order     Where a step makes no error whatever its size, as of what rests: e > 10 allowed at dt, and the larger of
//                     the last two is too, and above half the larger of the first two.  Of first order it is an eighth.
#pragma once

#include "harness/hunt/trial.h"
#include "harness/study/theory.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>

namespace cylon::hunt {

/// How many steps are asked, each half of the one before.
inline constexpr std::size_t halvings = 5;

enum class Kind { every_step, own_promise, coarse_step, fine_step, slow, erratic };

/// "at every step", "more than the engine's own promise", "at the coarse step alone", "at fine steps alone",
/// "until steps are far finer", "with no order".
std::string_view name(Kind);
std::optional<Kind> kind_from(std::string_view);

/// What is known beforehand of an error's course.
struct Expected {
  study::Promise promise;
  bool smooth = false;    ///< No velocity or force jumps: the promise holds.
  bool resolved = false;  ///< The step resolves all rates of the scene.
  double rounding =
      0;  ///< Below this part of the scale nothing is said of orders: 1e-7, in single precision 1e-4.
  bool stepless = false;  ///< A step makes no error of it, however large.
};

/// Whether dt resolves springs, dampers, spins, drives and what swings on joints: no stable scheme needs less, and no turn is
/// ambiguous.  Nothing where the rates are not known.
std::optional<bool> resolves(const Trial&);

class Course {
 public:
  Course(const Expected& expected, double relative) : expected_(expected), relative_(relative) {}

  /// The engine says that a part of a run moved by a method of that order: where it is less than what the engine promises, or
  /// the promise is of a bounded error, neither the promise nor a fall that no order explains is held against it.
  void not_promised(int order);

  /// What came of the next step.  A `measured` that is no number is a fault whatever the step.
  void add(double measured, double allowed, double truth_error);

  /// Whether further steps may still show a fault.
  bool open() const { return every_step_ || own_promise_ || coarse_step_ || may_be_erratic(); }

  /// The fault, once it is not open to change: after `halvings` steps, or when open() is false.
  std::optional<Kind> fault() const;

  const std::array<double, halvings>& measured() const { return measured_; }
  double allowed() const { return allowed_; }
  std::size_t count() const { return count_; }

  /// Whether errors at all steps, of which the first is no fault, rise to one.
  static bool rises(const std::array<double, halvings>& measured, double allowed);

  /// Of the scale, the least of the errors so far; and what an integrator that bounds its error is held to, where the
  /// motion makes nothing of an error.
  double least_part() const;
  static double held_to(const study::Promise&);

  /// Whether errors at all steps may be large because they cannot be larger, so that they do not tell; and whether the error
  /// at dt/64 tells that they are truncation.
  bool may_be_saturated() const;
  bool falls_at_last(double at_a_64th) const;

 private:
  bool may_be_erratic() const { return expected_.stepless && measured_[0] > 10 * allowed_; }
  bool is_erratic() const;
  double left() const { return measured_[count_ - 1] / measured_[count_ - 2]; }
  bool keeps_every_step() const;
  bool keeps_own_promise(double truth_error) const;
  bool keeps_coarse_step() const;

  Expected expected_;
  double relative_;
  std::array<double, halvings> measured_ = {};
  double allowed_ = 0;
  std::size_t count_ = 0;
  bool every_step_ = true, own_promise_ = true, coarse_step_ = true;
};

}  // namespace cylon::hunt
