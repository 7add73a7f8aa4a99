#include "tests/mutants/matrix/scenes.h"

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/core/scale.h"
#include "tests/paths.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>

namespace cylon::mutants {
namespace {

// The largest number of even samples, at most 256, that many steps can be cut into.
std::int64_t stride(std::int64_t steps) {
  constexpr std::int64_t few = 1024;  // all of them
  if (steps <= few) return 1;
  for (std::int64_t samples = std::min<std::int64_t>(256, steps); samples > 1; --samples)
    if (steps % samples == 0) return steps / samples;
  return steps;
}

// The truth at multiples of `spacing`, computed once; other times are computed as they come.
core::Truth remembered(const core::Truth& truth, double spacing, double until) {
  auto states = std::make_shared<std::vector<core::State>>();
  const auto count = std::llround(until / spacing);
  for (std::int64_t i = 0; i <= count; ++i)
    states->push_back(truth.state(std::min(static_cast<double>(i) * spacing, truth.horizon)));
  core::Truth result = truth;
  result.state = [states, spacing, original = truth.state](double t) {
    const double place = t / spacing, nearest = std::round(place);
    if (std::abs(place - nearest) < 1e-9 && nearest < static_cast<double>(states->size()))
      return (*states)[static_cast<std::size_t>(nearest)];
    return original(t);
  };
  return result;
}

}  // namespace

Examined examine(const SceneRow& row) {
  Examined result{scenario::load(std::filesystem::path(source_dir) / row.file), {}};
  scenario::Scenario& scenario = result.scenario;
  if (row.step > 0) scenario.step = row.step;
  if (scenario.theory && row.duration > 0) scenario.theory->until = row.duration;
  if (scenario.theory) scenario.duration = scenario.theory->until;
  const std::int64_t steps = core::whole_steps(scenario.duration, scenario.step);
  const double spacing = static_cast<double>(stride(steps)) * scenario.step;
  for (core::Claim& claim : scenario.claims) {
    claim.until = std::min(claim.until, scenario.duration);
    const bool gap = claim.observable.quantity == core::Quantity::normal_gap;
    result.shipped.push_back(
        core::allowed(claim, scenario.scene, scenario.duration, core::epsilon_of_double));
    if (claim.truth && claim.truth->times.empty() && claim.observable.quantity != core::Quantity::event)
      claim.truth = remembered(*claim.truth, spacing, scenario.duration);
    if (!gap && !claim.at_least) claim.sample = spacing;  // a least change is looked for at its own step
    claim.tolerance.relative = 0, claim.tolerance.roundings = 0;
    claim.tolerance.absolute = result.shipped.back();
  }
  return result;
}

}  // namespace cylon::mutants
