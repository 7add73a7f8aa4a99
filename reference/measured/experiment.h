// Measured motions: a third kind of truth beside exact and certified ones.  An experiment is a table of somebody's data, a
// file that says what its columns mean, and the scene that models it.  Knows no engine, and no law of motion.
#pragma once

#include "harness/scenario/scenario.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::measured {

/// Standard deviations of the first state of each run, of each component, independent and normal.
struct StartError {
  double position = 0;          ///< [m]
  double orientation = 0;       ///< Of a small turn about each axis [rad].
  double velocity = 0;          ///< [m/s]
  double angular_velocity = 0;  ///< [rad/s]
};

/// Standard deviations of what the scene states of its surfaces, independent and normal, cut at what is possible.
struct MaterialError {
  double friction = 0;
  double restitution = 0;
};

/// One motion: states at times k / rate, k = 0, 1, …
struct Run {
  std::string name;  ///< As in the table.
  std::vector<core::BodyState> states;
};

struct Experiment {
  std::string file;   ///< As given.
  std::string title;  ///< One line.
  std::string source, licence, instrument;
  std::vector<std::string> known;  ///< What is known to be wrong with the data.
  scenario::Scenario model;  ///< Its scene has the body that was measured; where that starts is the run's.
  std::size_t body = 0;      ///< Which of the scene's bodies.
  double rate = 0;           ///< Frames a second [1/s].
  StartError start;
  MaterialError material;
  double noise = 0;  ///< Standard deviation of each coordinate of a measured position [m].
  std::vector<Run> runs;

  std::size_t longest() const;  ///< Frames of the longest run.
};

/// Reads the description (TOML), the table that it names (CSV, plain or gzip) and the scene.  Lengths and angles are converted
/// to SI units, axes to y up, angular velocities to world axes.
/// Throws core::InputError with file, line and column or key for all that cannot be: an unknown key, a column that is not
/// there, a number that is not finite, a quaternion that is not of unit length within 1e-3, a run of fewer than two frames or
/// with a frame missing, a rate that the scene's step does not divide.
Experiment read(const std::filesystem::path&);

}  // namespace cylon::measured
