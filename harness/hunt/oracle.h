// What must hold of every scene, whatever the right motion is.  None of it is the word of another engine.
//
// Truncation is no fault.  A run at a step dt may be wrong by C dt^p; a fault is what does not go away: it must be
// there at dt, dt/2, … dt/16, each time more than ten times what is allowed, and fall by less than a quarter from
// one to the next, in the end by less than a tenth, where an error of first order falls to a half.  Nor is chaos: where two runs that begin one
// millionth apart end more than a ten-thousandth apart, no oracle speaks that compares trajectories.
#pragma once

#include "harness/hunt/trial.h"
#include "harness/process/client.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::hunt {

/// What a claim of a scenario can ask.
struct Oracle {
  std::string_view name;   ///< "energy"
  std::string_view says;   ///< What must hold, one sentence.
  std::string_view claim;  ///< TOML without its tolerance.
  double relative;         ///< Of the claim's scale, allowed; ten times that is a fault.
  /// Why it says nothing about this scene, or nothing when it does.  What the reader refuses is left out, too.
  std::optional<std::string> (*undefined_in)(const core::Scene&);
  bool of_trajectories = false;  ///< Compares trajectories: needs a motion that is not sensitive.
};

/// Beside these the relations of mechanics (study/relations.h) are asked, and that runs end, with numbers.
std::span<const Oracle> oracles();

/// How many steps a fault must survive, each half of the one before.
inline constexpr std::size_t halvings = 5;

struct Fault {
  std::string oracle;  ///< Name; of a relation "relation mirror"; of a run that does not end "crash".
  std::string says;    ///< What must hold.
  std::array<double, halvings> measured = {};  ///< At dt, dt/2, ….
  double allowed = 0;
  std::string unit;
  std::string claim;   ///< TOML; empty: the relations are asked.
  std::string detail;  ///< What an engine that did not end said.
};

/// Asks one engine one scene.  `only`, where it is not empty, is the name of the one oracle that is asked.  A scene
/// that the engine refuses has no faults.  Throws what process::run throws.
std::vector<Fault> examine(const Trial&, const process::EngineChoice&, const process::Limits&,
                           const std::string& only = "");

/// How far two runs of the engine, twice as long as the trial, get from each other that begin one millionth apart, in
/// millionths of the scales of the scene; of everything that a scene states: places, turns, speeds, masses, stiffnesses, friction, restitution.
double sensitivity(const Trial&, const process::EngineChoice&, const process::Limits&);

}  // namespace cylon::hunt
