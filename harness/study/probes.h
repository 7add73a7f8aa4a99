// What an engine really does, found out by small scenes and told apart by what theory says each integrator
// leaves behind; nothing that the engine says of itself is read.
#pragma once

#include "harness/study/runner.h"

#include <cmath>
#include <span>
#include <string>
#include <string_view>

namespace cylon::study {

struct Finding {
  std::string answer;    ///< "semi-implicit Euler", "off", "after the step's gravity"
  std::string evidence;  ///< The numbers that say so, in one sentence.
};

/// By what a free body loses velocity and spin [1/s]:  v' = a - c v.  All other answers are of what an engine does besides.
struct Damping {
  double linear = 0, angular = 0;  // [1/s]

  /// r = exp(-c t)
  static double left(double c, double t) { return std::exp(-c * t); }
  /// What a velocity has of a push of 1 that lasts for t, and a way of it:  (1 - r)/c  and  (t - (1 - r)/c)/c.
  static double gained(double c, double t) { return c == 0 ? t : (1 - left(c, t)) / c; }
  static double moved(double c, double t) { return c == 0 ? t * t / 2 : (t - gained(c, t)) / c; }
};

/// Throws RunFailed.
Damping damping_of(const Runner&);

struct Probe {
  std::string_view name;  ///< "fall", "gyroscopic torque"
  std::string_view asks;  ///< What is found out, one sentence.
  Finding (*ask)(const Runner&, const Damping&);
};

std::span<const Probe> probes();

/// All probes in their order.  One that the engine refuses or does not survive answers "unsupported",
/// "crash", …, with its reason.
std::vector<Finding> find_out(const Runner&);

}  // namespace cylon::study
