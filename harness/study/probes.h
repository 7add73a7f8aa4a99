// What an engine really does, found out by small scenes and told apart by what theory says each integrator
// leaves behind; nothing that the engine says of itself is read.
#pragma once

#include "harness/study/runner.h"

#include <span>
#include <string>
#include <string_view>

namespace cylon::study {

struct Finding {
  std::string answer;    ///< "semi-implicit Euler", "off", "after the step's gravity"
  std::string evidence;  ///< The numbers that say so, in one sentence.
};

struct Probe {
  std::string_view name;  ///< "fall", "gyroscopic torque"
  std::string_view asks;  ///< What is found out, one sentence.
  Finding (*ask)(const Runner&);
};

std::span<const Probe> probes();

/// All probes in their order.  One that the engine refuses or does not survive answers "unsupported",
/// "crash", …, with its reason.
std::vector<Finding> find_out(const Runner&);

}  // namespace cylon::study
