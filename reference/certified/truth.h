// The certified solution as a core::Truth: known at any time, in double, with its proven error.
#pragma once

#include "harness/core/truth.h"

#include <string>
#include <vector>

namespace cylon::certified {

/// What an error of one unit in the last place of the initial state has become by some time: each initial
/// vector (position, velocity, quaternion, angular velocity of a body) off by 2^-52 of its length in every
/// component.
struct Amplified {
  double time = 0;         ///< [s]
  core::StateError error;  ///< The largest up to then, over all bodies.
};

struct Solution {
  core::Truth truth;           ///< Its horizon is shorter than asked for where `lost` says so.
  std::vector<Amplified> ulp;  ///< Ascending times, ending with the truth's horizon.
  bool lost =
      false;  ///< An error of one unit in the last place grows beyond 1 (m, m/s, rad, rad/s) on the way.
};

/// From the cache where it is known, else solved and kept there.  Throws core::OutOfDomain.
Solution solution(const core::Scene&, double horizon);

}  // namespace cylon::certified
