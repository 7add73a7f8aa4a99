// The certified solution of a model, step by step.
#pragma once

#include "reference/certified/enclosure.h"
#include "reference/certified/model.h"
#include "reference/certified/series.h"
#include "reference/certified/variation.h"

#include <Eigen/Core>

#include <functional>
#include <stdexcept>

namespace cylon::certified {

/// How the integration goes about it; the result is proven whatever they are, only wider or narrower.
struct Effort {
  double step_error = 1e-28;  ///< Aimed at for what a step leaves out, in the states' own units.
  slong bits = 128;
  bool remainder =
      true;  ///< false leaves out what the polynomials leave out: nothing is proven then (for tests).
  double offset = 0;  ///< When time 0 was, to rounding, for messages [s].
};

/// The solution cannot be continued: the right-hand side has a pole, or bounds exceed double.
struct Stuck : std::runtime_error {
  double time;  ///< Reached [s].
  Stuck(double t, const std::string& what) : std::runtime_error(what), time(t) {}
};

/// One step: every node over [start, start + length] as polynomial, rest and spread.
class Step {
 public:
  double start = 0, length = 0;
  const Series* centre = nullptr;
  const Tails* tails = nullptr;
  const Variation* variation = nullptr;
  const Enclosure* set = nullptr;         ///< At the start.
  const Eigen::MatrixXd* path = nullptr;  ///< d state(start)/d state(0), to rounding.
  bool remainder = true;
  double offset = 0;  ///< As in Effort.

  /// The node's value at time t in [start, start + length], enclosed for every start of the set.
  Ball at(int node, double t) const;
  /// The same for all times `since` after the start, within [0, length].
  Ball within(int node, const Ball& since) const;
  /// Radius of at() beyond the centre's rounding, for all t of the step.
  double radius(int node) const;
  /// d node(t)/d state(0): one number per state variable, to rounding.
  Eigen::VectorXd sensitivity(int node, double t) const;
};

/// Of the polynomials of a step.
int order_of(const Effort&);

/// Integrates over [0, horizon] and shows every step, in order, until `show` says false.  Throws Stuck.
void follow(const Model&, double horizon, const Effort&, const std::function<bool(const Step&)>& show);

}  // namespace cylon::certified
