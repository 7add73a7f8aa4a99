// What a scenario says must hold, and how well.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/truth.h"

#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace cylon::core {

/// allowed = absolute + relative S + roundings eps R, with S the claim's scale (scale.h), eps of the engine's
/// precision, and R the size of what is rounded: `size`, or the largest value of the observable, or 1 rad; or,
/// where `order` is set, the bound of theory C_p dt^p T plus rounding, with p the order that the simulator declares, the observed order
/// being checked as well.
///
/// An integrator of order p is held to the constant of the highest order q <= p that has one: C_q dt^q T, and
/// order q. One that chooses its own steps (dt is then only the grid) is held to the last constant by its
/// value alone. Rounding is 64 eps sqrt(n) S (S = 1 for angles), eps of the engine's precision, n = T/dt;
/// where an error comes that low, the slope means nothing and the value alone decides. Where `level` is set, the
/// bound is the distance that chance exceeds with that probability (equipartition.h).  Without a reason there
/// is no tolerance.
struct Tolerance {
  double absolute = 0;  ///< In the observable's unit.
  double relative = 0;
  bool order = false;
  double constant = 0;  ///< C_p of every order [unit / s^(p+1)]; 0: see constants.
  std::string reason;
  std::map<int, double> constants = {};  ///< By order [unit / s^(p+1)].
  double level = 0;                      ///< The part of right engines that fail; 0: no test of chance.
  double roundings = 0;                  ///< How many, all of one sign.
  double size = 0;                       ///< Of what is rounded, in the observable's unit; 0: see above.
};

/// How a recording becomes one number.
enum class Reduction {
  max,          ///< Largest deviation over the samples.
  end,          ///< Deviation at the end.
  mean_square,  ///< Mean over time of the squared deviation, each sample weighted by the step after it.
  order,        ///< Observed order of convergence of the largest deviation under halving of the step.
  rate,         ///< Slope of the deviation against time, least squares.
  increase,  ///< One-sided: the largest rise of the value above its least one so far, the start included, and what lasts
             ///< one sample left out.
  decrease  ///< One-sided: the largest fall below its greatest one so far.
};

/// How uncertain a measured motion is, and a run from its measured start: independent normal errors, of which each pair has one a
/// standard deviation up and down.
struct Uncertainty {
  std::vector<std::pair<Scene, Scene>> scenes;  ///< Of the start, and of what the surfaces are said to be.
  std::function<std::vector<std::pair<State, State>>(double t)> measured;  ///< Of what was measured at t.
};

/// A measured motion as a truth: its error has no bound, so that Truth::error says nothing.
struct MeasuredTruth {
  Truth truth;
  std::shared_ptr<const Uncertainty> uncertainty;
};

class RequiredMotion;  // scale.h

struct Claim {
  std::string label;  ///< Unique in its scenario: "axis follows heavy_top", "energy".
  Observable observable;
  std::string follows;         ///< Name of the truth; empty: compared with the observable's initial value.
  std::optional<Truth> truth;  ///< What it follows, once that is known; cannot be measured before.
  double truth_error = 0;      ///< Its bound in the observable's unit.
  std::shared_ptr<const Uncertainty>
      uncertainty;  ///< Of a measured truth, which has no bound; null: it was not measured.
  /// Set: the claim is one-sided.  The observable must at some sample differ from its initial value by this
  /// much, and what is missing is measured: max(0, at_least - |Q(t) - Q(0)|), at the sample with the largest
  /// difference up to the first one at or after `until`.  Of all bodies the one that changes most counts.
  std::optional<double> at_least;
  Reduction reduction = Reduction::max;
  double until = std::numeric_limits<double>::infinity();  ///< Horizon [s].
  std::optional<double> sample;  ///< Time between samples [s]; 0: every step; absent: the default rule.
  Tolerance tolerance;
  /// Without a truth: the motion that its scale is taken from, where another claim of the scenario knows it.
  std::shared_ptr<const RequiredMotion> motion;
};

/// Whether the claim is about a real thing: its truth was measured.
inline bool validates(const Claim& claim) { return claim.uncertainty != nullptr; }

/// "validated": model and engine against a measured motion; "verified": the engine against mathematics.
inline std::string_view evidence(const Claim& claim) { return validates(claim) ? "validated" : "verified"; }

/// Whether the claim says how far a motion is from the required one.  Others say that something happens, that forces are
/// told right, that a motion is like most, or how far it is from a measured one.
inline bool measures_motion(const Claim& claim) {
  const Quantity quantity = claim.observable.quantity;
  return !claim.at_least && !of_last_step(quantity) && !of_chance(quantity) && !validates(claim);
}

/// Throws std::logic_error where a claim follows a truth that is not there: it is never measured against
/// anything else.
void require_truth(const Claim&);

/// Whether an observable of events speaks of this one.
bool claimed(const Observable&, const Event&);

std::string_view name(Reduction);

/// Whether the claim forbids one direction of change alone.
constexpr bool one_sided(Reduction reduction) {
  return reduction == Reduction::increase || reduction == Reduction::decrease;
}

/// Of the measured number: the observable's, squared for mean_square, per second for rate, none for order.
std::string unit(const Claim&);

/// Bound on a truth's error in the observable's own unit, from its bound on the state by the triangle
/// inequality (first order), at the states that the truth takes over [0, until]; of what is told of a last step, of
/// the one of `step` [s] that ends at `until`.
double truth_error(const Observable&, const Scene&, const Truth&, double until, double step);

}  // namespace cylon::core
