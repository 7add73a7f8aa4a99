#include "harness/validation/synthetic.h"

#include "harness/validation/normal.h"
#include "harness/validation/path.h"
#include "harness/validation/surfaces.h"
#include "reference/measured/coordinates.h"

namespace cylon::validation {

measured::Experiment synthetic(const measured::Experiment& like, std::span<const std::size_t> runs,
                               std::span<const double> values, const study::Runner& runner,
                               std::uint64_t seed, Surfaces surfaces) {
  measured::Experiment made = measured::with_values(like, like.parameters, values);
  std::vector<measured::Run> seen;
  for (const std::size_t i : runs) {
    const measured::Run& run = made.runs[i];
    Normal normal(seed, i, 0);
    const auto erred = [&](const core::State& state) {
      Eigen::VectorXd drawn(made.start.cols());
      for (double& one : drawn) one = normal(1);
      return measured::moved(made, state, made.start * drawn);
    };
    const core::State start = erred(run.states.front());
    measured::Run drawn{run.name, {}};
    core::Scene scene = measured::started(made, start);
    if (surfaces == Surfaces::drawn) add_surfaces(scene, drawn_surfaces(made, normal));
    for (const core::State& state : predicted(made, scene, run.states.size(), runner))
      drawn.states.push_back(erred(state));
    seen.push_back(drawn);
  }
  made.runs = seen;
  // Back into the lengths of the data, and the model without the values.
  for (measured::Run& run : made.runs)
    for (core::State& state : run.states)
      for (core::BodyState& s : state)
        s.position *= made.length / like.length, s.velocity *= made.length / like.length;
  measured::Experiment told = like;
  told.runs = made.runs;
  return told;
}

}  // namespace cylon::validation
