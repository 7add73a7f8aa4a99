// What each part of a scene costs, and what it changes: the same setting with it and without it.
#pragma once

#include "harness/results/advice.h"
#include "harness/study/starts.h"
#include "harness/study/sweep.h"

#include <span>
#include <vector>

namespace cylon::study {

/// A part that can be taken away.
struct Feature {
  std::string name;              ///< "friction"
  process::EngineChoice engine;  ///< That runs without it.
  core::Integrator integrator;
  core::Scene scene;  ///< Without it.
};

/// Those that the scene and the engine have: the gyroscopic term (where a body turns, of engines with an
/// option `gyro`), friction, joints, contacts, and double precision (of engines with a row "…-float").  A
/// scene with joints moves otherwise without them; what is priced is their work.
std::vector<Feature> features(const core::Scene&, const Setting&, std::span<const process::EngineRow>);

/// Each feature of each pick, with and without timed in turns.
std::vector<results::FeaturePrice> price_features(const Start&, const std::vector<results::Pick>&,
                                                  const std::vector<Setting>&,
                                                  std::span<const process::EngineRow>, int rounds,
                                                  const process::Limits&);

}  // namespace cylon::study
