#include "harness/study/limits_step.h"

#include "harness/core/recording.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace cylon::study {
namespace {

bool whole(double x) { return std::abs(x - std::round(x)) <= 1e-9 * std::max(1.0, x); }

// The least divisor of `most` by which every time is a whole number of parts of the duration.
std::int64_t parts_for(const std::vector<double>& times, double duration, std::int64_t most) {
  for (std::int64_t n = 1; n < most; ++n)
    if (most % n == 0 && std::all_of(times.begin(), times.end(),
                                     [&](double t) { return whole(t / duration * static_cast<double>(n)); }))
      return n;
  return most;
}

}  // namespace

StepSearch step_search(const scenario::Scenario& scenario) {
  scenario::require_prepared(scenario);
  const std::int64_t nominal = core::whole_steps(scenario.duration, scenario.step);
  StepSearch search;
  for (const core::Claim& claim : scenario.claims) {
    if (claim.truth && !claim.truth->times.empty())
      search.unit = std::lcm(search.unit, parts_for(claim.truth->times, scenario.duration, nominal));
    else if (claim.sample && *claim.sample > 0)
      search.unit = std::lcm(search.unit, core::whole_steps(scenario.duration, *claim.sample));
  }
  const auto in_units = [&](std::int64_t n) {
    return static_cast<double>(std::max<std::int64_t>(1, n / search.unit));
  };
  search.range = {.low = std::max(in_units(nominal / 64), search.unit > 1 ? 1.0 : 2.0),
                  .high = std::max(in_units(8 * nominal), 8.0),
                  .downward = true,
                  .whole = true};
  return search;
}

Probed step_probe(const scenario::Scenario& scenario, const process::EngineChoice& engine,
                  const process::Limits& limits, std::int64_t steps) {
  Cell cell;
  cell.scenario = &scenario;
  cell.engine = engine;
  cell.dt = scenario.duration / static_cast<double>(steps);
  cell.dt_text = fmt::format("{}", cell.dt);
  for (const results::Verdict& row : run(cell, limits, {})) {
    if (row.status == results::Status::unsupported) throw Unsupported{row.detail};
    if (row.status != results::Status::pass)
      return {false, fmt::format("{}: {}, {:.3g} where {:.3g} is allowed", row.claim,
                                 results::name(row.status), row.measured, row.allowed)};
  }
  return {};
}

}  // namespace cylon::study
