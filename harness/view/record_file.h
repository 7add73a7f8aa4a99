// What happened in the viewer, as a scenario that `cylon run` judges, with the recorded motion beside it.
#pragma once

#include "harness/scenario/scenario.h"
#include "harness/view/recorder.h"

#include <filesystem>

namespace cylon::view {

/// Writes `file` (….toml) and the motion (….json, truth/1) beside it: the scene from the last interaction on,
/// the time since then as its duration, and claims that positions and orientations follow the recorded
/// motion.  Files that are there are kept: a number is added to the name.  Returns the scenario's path.
/// Requires that the recorder is not empty.  Throws core::InputError where a file cannot be written, or where
/// the scenario would be refused (spheres that overlap at its start, because an engine had let them), saying
/// why; nothing is left then.
std::filesystem::path save_recording(const Recorder&, const scenario::Scenario& from,
                                     const std::filesystem::path& file);

}  // namespace cylon::view
