// The laws of a scene that a reference engine does not have, as forces of the state before a step: springs, drag,
// thrust, changing mass, drive, attraction, water, what acts along joints, and a frame of reference that turns or accelerates.
#pragma once

#include "harness/core/scene.h"
#include "reference/applied/immersion.h"
#include "reference/applied/joint_forces.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::applied {

/// Why an adapter maps not all forces of a scene, or nothing.
std::optional<std::string> unmapped(const core::Scene&);

/// The same for tables of settings: what is applied, and how.
inline constexpr const char* applied_forces =
    "springs, drag, thrust, drive, attraction, water, forces along joints, forces of a frame that turns or "
    "accelerates";
inline constexpr const char* as_applied = "force of the state before the step";
inline constexpr const char* why_applied =
    "the engine has no such forces; they are constant during the step, and so is a mass that changes";

class Forces {
 public:
  /// Without those forces of the scene, by index, that the engine has as joints.  Requires that
  /// unmapped(scene) says nothing.
  explicit Forces(core::Scene scene, const std::vector<std::size_t>& joints = {});

  /// Whether anything is to be applied before a step.
  bool any() const { return any_; }

  /// One per body, of the state at t [s].  Throws std::runtime_error where a mass is used up.
  const std::vector<Wrench>& at(double t, const core::State&);

  /// Bodies whose mass changes.
  const std::vector<std::size_t>& changing() const { return changing_; }

  /// Mass of a body at the last t of at() [kg].  What enters or leaves does so at the centre of mass, so the
  /// inertia stays.
  double mass(std::size_t body) const { return scene_.bodies[body].mass; }

 private:
  core::Scene scene_;  // masses as they are at t
  std::vector<double> start_, rate_;
  std::vector<std::size_t> changing_;
  std::vector<std::optional<Immersion>> immersions_;
  JointForces joints_;
  std::vector<Wrench> wrenches_;
  bool any_ = false;
};

}  // namespace cylon::applied
