// Numbers that others have published, beside what the same scenes give here.
#pragma once

#include "harness/study/runner.h"

#include <functional>
#include <string>
#include <vector>

namespace cylon::study {

/// One published number and ours.
struct Reproduction {
  std::string source;       ///< "Gazebo boxes, 2015"
  std::string what;         ///< "energy, bullet, dt 0.001"
  std::string published;    ///< As it was printed.
  double here = 0;          ///< Measured now.
  double within = 0;        ///< Largest difference that counts as reproduced, in the number's own unit.
  std::string explanation;  ///< Why a difference is known; empty: none is.

  double difference() const;  ///< |here - published|; NaN where either is none.
  bool reproduced() const { return difference() <= within; }
  /// Reproduced, or known and said why not; a number that agrees against its explanation is not as it should
  /// be either.
  bool as_explained() const { return reproduced() == explanation.empty(); }
};

/// Half a unit of the last digit that `published` shows, or `units` of them.
double last_digit(const std::string& published, double units = 0.5);

/// Gives the runner of an engine by its id, "bullet/gyro=none".
using Engines = std::function<Runner(const std::string& id)>;

/// The numbers that stand in no suite: Gazebo's boxes, the tumbling brick of NASA's check case Atmos-02, and
/// the free boxes of MuJoCo's tests.  Throws RunFailed.
std::vector<Reproduction> published_numbers(const Engines&);

}  // namespace cylon::study
