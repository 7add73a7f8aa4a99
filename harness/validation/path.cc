#include "harness/validation/path.h"

#include "harness/core/recording.h"
#include "reference/measured/coordinates.h"

#include <algorithm>

namespace cylon::validation {

std::vector<core::State> whole_path(const measured::Experiment& e, const core::Scene& scene,
                                    std::size_t frames, const study::Runner& runner) {
  const std::int64_t every = core::whole_steps(1 / e.rate, e.model.step);
  const auto last = static_cast<std::int64_t>(frames) - 1;
  const core::Recording r = runner(scene, e.model.step, last * every, every);
  std::vector<core::State> states;
  for (std::size_t i = 0; i < r.states.size(); ++i)
    if (r.steps[i] % every == 0) states.push_back(r.states[i]);
  return states;
}

std::vector<core::State> predicted(const measured::Experiment& e, const core::Scene& scene,
                                   std::size_t frames, const study::Runner& runner) {
  std::vector<core::State> states = whole_path(e, scene, frames, runner);
  for (core::State& state : states) state = measured::measured_of(e, state);
  return states;
}

bool finite(const std::vector<core::State>& states) {
  return std::ranges::all_of(states, [](const core::State& state) {
    return std::ranges::all_of(state, [](const core::BodyState& s) {
      return s.position.allFinite() && s.orientation.coeffs().allFinite();
    });
  });
}

}  // namespace cylon::validation
