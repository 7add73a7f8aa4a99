// The engine that this program is linked with, as a runner without a process.
#pragma once

#include "harness/core/simulator.h"
#include "harness/study/runner.h"

#include <map>
#include <string>

namespace cylon::levels {

inline study::Runner in_process(const std::map<std::string, std::string>& options = {}) {
  return [=](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    const auto simulator = core::make_simulator();
    core::Setup setup;
    setup.dt = dt, setup.options = options;
    const core::Loaded loaded = simulator->load_if_supported(scene, setup);
    if (loaded.unsupported) {
      process::RunOutcome outcome;
      outcome.status = results::Status::unsupported, outcome.reason = *loaded.unsupported;
      throw study::RunFailed{outcome};
    }
    core::Recording recording;
    recording.dt = dt;
    core::State state(scene.bodies.size());
    for (std::int64_t step = 0; step <= steps; step += every) {
      if (step > 0) simulator->advance(every);
      simulator->read(state);
      recording.steps.push_back(step), recording.states.push_back(state);
    }
    return recording;
  };
}

}  // namespace cylon::levels
