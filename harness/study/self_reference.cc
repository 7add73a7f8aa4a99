#include "harness/study/self_reference.h"

#include "harness/core/measure.h"
#include "harness/study/settings.h"

#include <algorithm>
#include <utility>

namespace cylon::study {

std::optional<Reference> self_reference(const scenario::Scenario& scenario, std::int64_t samples,
                                        std::span<const process::EngineRow> rows,
                                        const process::Limits& limits) {
  scenario::require_prepared(scenario);
  constexpr double tolerance = 1e-11;
  const auto follows = [](const core::Claim& claim) {
    return claim.truth.has_value() && !core::validates(claim);
  };
  const auto row =
      std::find_if(rows.begin(), rows.end(), [](const process::EngineRow& r) { return r.id == "in-house"; });
  if (row == rows.end() || touches(scenario.scene) ||
      std::any_of(scenario.claims.begin(), scenario.claims.end(), follows))
    return std::nullopt;
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = scenario.duration / static_cast<double>(samples);
  request.setup.integrator = "auto";
  request.setup.tolerance = tolerance;
  request.steps = samples;
  process::RunOutcome outcome = process::run(process::parse_engine(row->id, rows), request, limits);
  if (!outcome.recording || !outcome.recording->remarks.empty() || core::first_bad_step(*outcome.recording))
    return std::nullopt;
  return Reference{"in-house auto at 1e-11 (not certified)", std::move(outcome.recording->states),
                   10 * tolerance};
}

}  // namespace cylon::study
