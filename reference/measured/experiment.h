// Measured motions: a third kind of truth beside exact and certified ones.  An experiment is a table of somebody's data, a
// file that says what its columns mean, and the scene that models it.  Knows no engine, and no law of motion.
#pragma once

#include "harness/scenario/scenario.h"
#include "reference/measured/parameter.h"

#include <Eigen/Core>

#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

namespace cylon::measured {

/// Standard deviations of what the scene states of its surfaces, independent and normal, cut at what is possible.
struct MaterialError {
  double friction = 0;
  double restitution = 0;
};

/// One motion: states of the measured bodies at times k / rate, k = 0, 1, …
struct Run {
  std::string name;  ///< As in the table.
  std::vector<core::State> states;
  std::string hash = {};  ///< Of what was measured, in its own units; empty: nothing was.
};

/// What was measured of a state, and so how a start may err.
enum class Coordinates {
  free,   ///< One body: position, a small turn about world axes, velocity, angular velocity; 12 numbers.
  chain,  ///< Bodies in a chain of parallel hinges: the angle of each, then the rate of each.
};

/// How parameters are fitted.
struct FitPlan {
  double horizon =
      0;  ///< Length of a window: each is predicted from its own first frame [s]; 0: none stated.
  /// Degrees of freedom of the model's discrepancy: the covariance of each window has an unknown factor of its own, whose
  /// reciprocal is chi-squared with so many degrees over their number; infinite: the factor is 1.
  double degrees = std::numeric_limits<double>::infinity();
};

/// Everything of an experiment but its motions.
struct Setup {
  std::string file;   ///< As given.
  std::string hash;   ///< Of this file, the table and the scene.
  std::string title;  ///< One line.
  std::string source, licence, instrument;
  std::vector<std::string> known;  ///< What is known to be wrong with the data.
  scenario::Scenario model;  ///< Its scene has the bodies that were measured; where those start is the run's.
  std::vector<std::size_t> bodies;  ///< Which of the scene's; of a chain from its fixed end on.
  Coordinates coordinates = Coordinates::free;
  double rate = 0;  ///< Frames a second [1/s].
  /// L of the covariance L L^T of a measured state, in its coordinates, which has the errors of a run's start [m, rad, m/s, rad/s].
  Eigen::MatrixXd start;
  MaterialError material;
  double noise = 0;  ///< Standard deviation of each coordinate of a measured position [m].
  double angle_noise =
      0;  ///< Of a measured orientation about each axis, or of an angle [rad]; 0: not compared in fits.
  double length = 1;  ///< What measured lengths were divided by to become these (parameter "length").
  std::vector<Parameter> parameters;  ///< What may be fitted.
  FitPlan fit;
};

struct Experiment : Setup {
  std::vector<Run> runs;

  std::size_t longest() const;  ///< Frames of the longest run.
};

/// Reads the description (TOML), the table that it names (CSV, plain or gzip) and the scene.  Lengths and angles are converted
/// to SI units, axes to y up, angular velocities to world axes.
/// Throws core::InputError with file, line and column or key for all that cannot be: an unknown key, a column that is not
/// there or that is named twice, a number that is not finite, a quaternion that is not of unit length within 1e-3, a run of fewer than two frames or
/// with a frame missing or at another time than its rate says, a rate that the scene's step does not divide, correlations that are none.
Experiment read(const std::filesystem::path&);

}  // namespace cylon::measured
