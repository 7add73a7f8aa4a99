// A certified solution rounded to double: a polynomial in time per step and number.
#pragma once

#include "reference/certified/truth.h"

#include <cstdint>

namespace cylon::certified {

struct Dense {
  static constexpr std::size_t numbers = 13;  ///< Of a body: p, q (w, x, y, z), v, w as in core::BodyState.

  std::uint64_t bodies = 0;
  std::vector<double> starts;        ///< Of the steps [s], from 0.
  std::vector<std::uint64_t> first;  ///< Index of a step's first coefficient, and one past the end.
  std::vector<double> coefficients;  ///< Per step, body and number: all of the same degree.
  double horizon = 0;                ///< [s]
  core::StateError error;
  std::vector<Amplified> ulp;
  bool lost = false;
  double work = 0;  ///< As Solution has it.

  core::State at(double t) const;
};

/// Solves and rounds.  Throws core::OutOfDomain; TooMuchWork where it takes more than `most_work`.
Dense make_dense(const core::Scene&, double horizon, double most_work);

/// Throws TooMuchWork where the work up to `time` exceeds `most`.
void require_work(double work, double most, double time);

/// Known again by this: the equations themselves, their numbers, the initial state and the horizon, as 16 hex
/// digits.  Names and colours do not count.
std::string key_of(const core::Scene&, double horizon);

}  // namespace cylon::certified
