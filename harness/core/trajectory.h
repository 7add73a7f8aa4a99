// How all bodies of a scene went, whoever says so: a run, a truth, a file.
#pragma once

#include "harness/core/scene.h"

#include <vector>

namespace cylon::core {

/// States at ascending times.
struct Trajectory {
  std::vector<double> time;  ///< [s]
  std::vector<State> states;
};

}  // namespace cylon::core
