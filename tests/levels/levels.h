// How often what a fit says is true: one synthetic experiment, of which the truth is known, fitted with an engine that is right or
// wrong in one known way.
#pragma once

#include "harness/study/runner.h"
#include "reference/measured/experiment.h"

#include <cstdint>
#include <string>
#include <vector>

namespace cylon::levels {

struct Case {
  std::string name;
  measured::Experiment like;  ///< Its parameters are fitted; its runs say where motions start.
  std::vector<double> truth;  ///< Of those parameters.
  study::Runner world;        ///< What made the data.
  study::Runner engine;       ///< What is fitted to them.
};

struct Trial {
  std::vector<bool> held;          ///< By parameter: the interval by the stated uncertainties has the truth.
  std::vector<bool> held_between;  ///< The interval by how much runs differ has it.
  bool told = false;               ///< The misfit refuses the model at 5 %.
  bool settled = false;
};

Trial trial(const Case&, std::uint64_t seed);

/// Ten throws of a ball (ball_world.h): "ball", "ball, larger errors" and "ball, inertia known" of a right engine; "ball, pyramid", "ball, no restitution" and
/// "ball, inertia +10 %" of one that is wrong, which is told what inertia the ball has.
std::vector<Case> ball_cases(int throws = 10);

/// That of a name; throws std::invalid_argument where there is none.
const Case& find(const std::vector<Case>&, const std::string& name);

}  // namespace cylon::levels
