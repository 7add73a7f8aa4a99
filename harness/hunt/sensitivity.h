// How much of a millionth a motion makes.
#pragma once

#include "harness/hunt/trial.h"
#include "harness/process/client.h"

namespace cylon::hunt {

/// How far two runs of the engine, twice as long as the trial, get from each other that begin one millionth apart, in
/// millionths of the scales of the scene; of everything that a scene states: places, turns, speeds, masses,
/// stiffnesses, friction, restitution.
double sensitivity(const Trial&, const process::EngineChoice&, const process::Limits&);

}  // namespace cylon::hunt
