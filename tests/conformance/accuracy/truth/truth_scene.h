// The reference solutions of tests/data/truth as scenes, and what must be seen of their motion.
// Knows no engine and no exact solution: numbers of the files alone.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::accuracy {

/// What a file says of one body at one time; what it does not say is absent.
struct Expected {
  int body = 0;
  std::optional<core::Vector3> position;          ///< [m]
  std::optional<core::Vector3> velocity;          ///< [m/s]
  std::optional<core::Quaternion> orientation;    ///< Up to its sign.
  std::optional<core::Vector3> angular_velocity;  ///< World axes [rad/s].
};

struct Sample {
  double time = 0;  ///< [s]
  std::vector<Expected> bodies;
};

/// One scene and its motion at some times, ascending.
struct TruthScene {
  std::string name;  ///< The file's, and "/case" where it holds several.
  core::Scene scene;
  std::vector<Sample> samples;
  double conditioning =
      1;  ///< Largest amplification of an error by the motion itself; 1 where the file gives none.
};

/// Names of all files, in alphabetical order.
std::vector<std::string> truth_names();

/// The scenes of a file; none where it holds no motion (composite_body).  Throws std::runtime_error for a
/// file that holds what is not known here.
std::vector<TruthScene> truth_scenes(const std::string& name);

}  // namespace cylon::accuracy
