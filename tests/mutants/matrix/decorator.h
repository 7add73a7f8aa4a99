// An engine behind a mask: the in-house engine with one thing wrong on the way in, on the way, or on the way
// out.
#pragma once

#include "tests/mutants/matrix/subject.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

namespace cylon::mutants {

/// After a step.
struct Moment {
  const core::Scene& scene;   ///< As the user gave it.
  const core::State& before;  ///< The true state one step ago.
  std::int64_t step = 0;
  double dt = 0;         ///< [s]
  std::int64_t run = 0;  ///< Counts all runs of this process: what a result must not depend on.
};

struct Mask {
  std::function<void(core::Scene&)> scene;  ///< What the engine is given.
  std::function<void(core::Setup&)> setup;
  std::function<void(core::Terms&)> terms;                   ///< What the engine says of itself.
  std::function<bool(std::int64_t step)> skips;              ///< Whether this step is left out.
  std::function<void(const Moment&, core::State&)> reading;  ///< What is handed out.
  std::function<void(core::Contact&)> telling;               ///< What is told of each contact.
  std::function<void(core::Reaction&)> reacting;             ///< What is told of each joint.
  /// Whether the state was changed; the engine starts again from it.
  std::function<bool(const Moment&, core::State&)> tampers;
};

std::unique_ptr<core::Simulator> masked(const Mask&);

/// Right simulators behind a mask that changes nothing that mechanics knows.
struct HarmlessRow {
  const char* name;
  Mask mask;
};
std::vector<HarmlessRow> harmless_masks();

struct MaskedRow {
  const char *name, *fault;
  const char *judge, *claim;
  Mask mask;
};
std::vector<MaskedRow> faults_of_the_scene();    ///< The engine is given another scene or another step.
std::vector<MaskedRow> faults_of_the_joints();   ///< Of a scene: of its joints and what acts along them.
std::vector<MaskedRow> faults_of_the_reading();  ///< The motion is right; what is handed out is not.
std::vector<MaskedRow> faults_of_the_motion();   ///< The state is changed on the way.

}  // namespace cylon::mutants
