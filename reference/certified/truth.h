// The certified solution as a core::Truth: known at any time, in double, with its proven error.
#pragma once

#include "harness/core/truth.h"

#include <limits>
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
  double work = 0;  ///< What it cost to solve, also where it came from the cache: see work_per_second.
};

/// A unit of work is a product of two numbers of 128 bits.  A machine of 2020 does about as many in a second;
/// the limits count work and not time, so that every machine refuses the same.
inline constexpr double work_per_second = 1.5e9;

/// More work than the caller allows.
struct TooMuchWork : core::OutOfDomain {
  using core::OutOfDomain::OutOfDomain;
};

/// From the cache where it is known, else solved and kept there.  Throws core::OutOfDomain; TooMuchWork where
/// it takes more than `most_work`, whether it is in the cache or not.
Solution solution(const core::Scene&, double horizon,
                  double most_work = std::numeric_limits<double>::infinity());

}  // namespace cylon::certified
