// What mechanics requires of two runs of one engine, whatever the right motion is: needs no truth, so it
// serves every scene that a user brings.
#pragma once

#include "harness/study/runner.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace cylon::study {

/// The scales of a scene's motion, from the scene alone.
struct Scales {
  bool impacts = false;         ///< Bodies may touch: velocities jump.
  double length = 0;            ///< Extent, sizes, rest lengths; else what speed and gravity cover [m].
  double speed = 0;             ///< The first speeds, and those that forces give over `length` [m/s].
  double angular_velocity = 0;  ///< The first ones, and speed/length [rad/s].
};
Scales scales(const core::Scene&, double duration);

/// Largest difference of two states in units of the scales, turns in rad; NaN where either is.  Velocities
/// count where they are continuous: at a sample that falls on an impact they are those before or after it.
double apart(const core::State&, const core::State&, const Scales&);

/// What a relation is asked of: a scene, and how it was run.
struct Subject {
  const core::Scene& scene;
  const core::Recording& plain;  ///< Its run, from which the other one must follow.
  std::int64_t every = 1;        ///< Steps between its samples.
  Scales scales;
  double until = 0;  ///< Beyond it nothing is compared: the motion is chaotic [s].
};

struct Relation {
  std::string_view name;  ///< "translation"
  std::string_view says;  ///< What must hold, one sentence.
  /// Why the relation says nothing about this scene, or nothing when it does.
  std::optional<std::string> (*undefined_in)(const core::Scene&);
  /// Largest distance, over the samples, between the run that must follow and the one that does.
  double (*deviation)(const Subject&, const Runner&);
  bool exact = false;  ///< To the last bit, in any arithmetic.
};

std::span<const Relation> relations();

}  // namespace cylon::study
