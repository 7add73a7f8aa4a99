#include "harness/validation/drawing.h"

#include "harness/validation/curves.h"
#include "harness/validation/path.h"
#include "harness/validation/split.h"
#include "reference/measured/coordinates.h"

namespace cylon::validation {
namespace {

using core::State, measured::Coordinates, measured::Experiment;

// As measured where that is known, as predicted elsewhere.
State seen(const Experiment& e, const State& state, State predicted) {
  const core::Scene scene = measured::started(e, state);
  for (const std::size_t i : e.bodies) predicted[i] = scene.bodies[i].initial;
  return predicted;
}

void to_lengths_of_data(const Experiment& e, std::vector<State>& states) {
  for (State& state : states)
    for (core::BodyState& s : state) s.position *= e.length;
}

}  // namespace

Drawing drawing(const Experiment& e, std::size_t run, const study::Runner& runner, const Band& band,
                const Fitted& fitted) {
  const Experiment at = with_fit(with_run(e, run), fitted);
  const std::vector<State>& states = at.runs[0].states;
  Drawing made;
  made.run = at.runs[0].name;
  made.measured = curves(at, states, states.front());
  made.scene = measured::started(at, states.front());
  try {
    made.poses = whole_path(at, made.scene, states.size(), runner);
    std::vector<State> path;
    for (const State& state : made.poses) path.push_back(measured::measured_of(at, state));
    if (path.size() != states.size() || !finite(path)) {
      made.failure = "the prediction is not finite";
      return made;
    }
    made.predicted = curves(at, path, states.front());
    for (std::size_t i = 0; i < path.size(); ++i) {
      if (at.coordinates == Coordinates::free)
        made.turn.push_back(path[i][0].orientation.angularDistance(states[i][0].orientation));
      made.seen.push_back(seen(at, states[i], made.poses[i]));
    }
    to_lengths_of_data(at, made.poses), to_lengths_of_data(at, made.seen);
    if (band.members > 0) made.band = range(e, run, runner, band, fitted);
  } catch (const study::RunFailed& failed) {
    made.failure = failed.outcome.reason;
  }
  return made;
}

}  // namespace cylon::validation
