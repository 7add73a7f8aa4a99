#include "harness/study/ladder.h"

#include "harness/core/input_error.h"
#include "harness/core/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>

namespace cylon::study {
namespace {

constexpr std::int64_t coarsest_multiple = 64;  // of the nominal step
constexpr std::int64_t fewest_samples = 16;     // of a rung

// Whether every time of every recorded truth is one of k T/M.
bool has_all_times(const scenario::Scenario& scenario, std::int64_t samples) {
  scenario::require_prepared(scenario);
  for (const core::Claim& claim : scenario.claims) {
    if (!claim.truth) continue;
    for (const double t : claim.truth->times) {
      const double k = t / scenario.duration * static_cast<double>(samples);
      if (t <= scenario.duration && std::abs(k - std::round(k)) > 1e-6) return false;
    }
  }
  return true;
}

bool has_times(const scenario::Scenario& scenario) {
  scenario::require_prepared(scenario);
  return std::any_of(scenario.claims.begin(), scenario.claims.end(),
                     [](const core::Claim& c) { return c.truth && !c.truth->times.empty(); });
}

}  // namespace

std::int64_t nominal_steps(const scenario::Scenario& scenario) {
  return std::max<std::int64_t>(1, std::llround(scenario.duration / scenario.step));
}

std::int64_t coarsest_samples(const scenario::Scenario& scenario, std::int64_t divisor, std::int64_t least) {
  const std::int64_t nominal = nominal_steps(scenario);
  for (; divisor > 1; divisor /= 2) {
    // Only a divisor of the nominal steps is sure to meet recorded times.
    if (has_times(scenario) && (nominal % divisor != 0 || !has_all_times(scenario, nominal / divisor)))
      continue;
    const std::int64_t samples = (nominal + divisor / 2) / divisor;
    if (samples >= least) return samples;
  }
  return nominal;
}

Ladder ladder_down_to(const scenario::Scenario& scenario, double finest) {
  Ladder result;
  result.samples = coarsest_samples(scenario, coarsest_multiple, fewest_samples);
  constexpr double most_steps = 0x1p40;
  if (!(scenario.duration / finest <= most_steps))
    throw core::InputError(
        fmt::format("--finest: {:g} s is too fine for {}, which lasts {:g} s; valid: {:.2g} s "
                    "or more",
                    finest, scenario.name, scenario.duration, scenario.duration / most_steps));
  const std::int64_t most = std::max(
      result.samples, static_cast<std::int64_t>(std::floor(scenario.duration / finest * (1 + 1e-9))));
  for (std::int64_t steps = result.samples; steps <= most; steps *= 2) result.steps.push_back(steps);
  const std::int64_t last = most / result.samples * result.samples;
  if (10 * last >= 11 * result.steps.back()) result.steps.push_back(last);
  return result;
}

Ladder ladder(const scenario::Scenario& scenario, int rungs, std::int64_t most) {
  Ladder result;
  result.samples = coarsest_samples(scenario, coarsest_multiple, fewest_samples);
  std::int64_t steps = result.samples;
  for (int i = 0; i < rungs && (i == 0 || steps <= most); ++i, steps *= 2) result.steps.push_back(steps);
  return result;
}

Ladder ladder(const scenario::Scenario& scenario, std::span<const double> given) {
  Ladder result{0, {}};
  for (const double dt : given) try {
      const std::int64_t steps = core::whole_steps(scenario.duration, dt);
      result.samples = std::gcd(result.samples, steps);
      result.steps.push_back(steps);
    } catch (const std::invalid_argument& error) {
      throw core::InputError(fmt::format("--dt: {}: {}", scenario.name, error.what()));
    }
  std::sort(result.steps.begin(), result.steps.end());
  result.steps.erase(std::unique(result.steps.begin(), result.steps.end()), result.steps.end());
  if (result.samples < 8 || (has_times(scenario) && !has_all_times(scenario, result.samples)))
    throw core::InputError(
        fmt::format("--dt: {}: runs with these steps have {} times in common in {} s, which is too few to "
                    "compare; use steps that divide one another, such as 1/100 and 1/200",
                    scenario.name, result.samples, scenario.duration));
  return result;
}

std::string step_text(const scenario::Scenario& scenario, std::int64_t steps) {
  if (steps == nominal_steps(scenario)) return scenario.step_text;
  return fmt::format("{}/{}", scenario.duration, steps);
}

}  // namespace cylon::study
