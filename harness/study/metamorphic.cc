#include "harness/study/metamorphic.h"

#include "harness/core/measure.h"
#include "harness/core/recording.h"
#include "harness/core/worst.h"
#include "harness/study/relation_tools.h"
#include "harness/study/relations.h"
#include "harness/study/row.h"
#include "harness/study/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace cylon::study {
namespace {

using results::Verdict;

// At most 200 samples, a divisor of the steps where there is one, so that samples meet when time runs back.
std::int64_t stride(std::int64_t steps) {
  const std::int64_t least = std::max<std::int64_t>(1, (steps + 199) / 200);
  for (std::int64_t every = least; every <= 10 * least; ++every)
    if (steps % every == 0) return every;
  return least;
}

double horizon(const scenario::Scenario& scenario) {
  double until = scenario.duration;
  for (const core::Claim& claim : scenario.claims)
    if (claim.truth) until = std::min(until, claim.until);
  return until;
}

void fail(Verdict& row, const process::RunOutcome& outcome) {
  row.status = outcome.status, row.detail = outcome.reason, row.complaints = outcome.stderr_tail;
}

// How far the states of runs that start one ulp apart get from each other: below that no relation says anything.
void measure_spread(const Cell& cell, const Subject& subject, const Runner& run, std::vector<Verdict>& rows) {
  const int copies = copies_of(cell);
  for (int i = 0; i < copies; ++i) {
    try {
      const core::Recording copy = again(subject, run, one_ulp_apart(subject.scene, i, copies));
      const double apart = worst(subject, copy, [](const core::State& state, double) { return state; });
      for (Verdict& row : rows) row.spread = core::worst(apart, row.spread.value_or(0));
    } catch (const RunFailed& failed) {
      for (Verdict& row : rows) tell_failed_copy(row, i, failed.outcome);
    }
  }
  for (Verdict& row : rows) tell_spread(row, copies);
}

}  // namespace

std::vector<Verdict> relate(const Cell& cell, const process::Limits& limits,
                            const scenario::Expectations& expectations) {
  const scenario::Scenario& scenario = *cell.scenario;
  const std::int64_t steps = sampling(scenario, cell.dt).steps, every = stride(steps);
  process::RunOutcome last;
  // What the engine says of the runs of one relation.
  std::vector<told::Diagnostic> told;
  const Runner run = [&, engine = worker_runner(cell.engine, limits, &last)](
                         const core::Scene& scene, double dt, std::int64_t count, std::int64_t stride_of) {
    core::Recording recording = engine(scene, dt, count, stride_of);
    for (const told::Diagnostic& one : recording.diagnostics)
      if (std::ranges::find(told, one) == told.end()) told.push_back(one);
    return recording;
  };

  std::vector<const Relation*> asked;
  std::vector<Verdict> rows;
  for (const Relation& relation : relations()) {
    if (relation.undefined_in(scenario.scene)) continue;
    asked.push_back(&relation);
    Verdict row = open_row(cell, fmt::format("relation {}", relation.name), expectations);
    row.observable = "state", row.unit = "1";
    row.sampling = every == 1 ? "every step" : fmt::format("every {} steps", every);
    row.allowed = relation.exact ? 0 : allowed_of_relations;
    row.tolerance_reason =
        relation.exact ? fmt::format("{}: exact in any arithmetic", relation.says)
                       : fmt::format("{}: convention: 1/1000 of the scales of the scene", relation.says);
    row.body_steps = static_cast<std::int64_t>(scenario.scene.bodies.size()) * steps;
    rows.push_back(std::move(row));
  }

  core::Recording plain;
  try {
    plain = run(scenario.scene, cell.dt, steps, every);
  } catch (const RunFailed& failed) {
    for (Verdict& row : rows) sign(row, last.engine, last.terms, expectations), fail(row, failed.outcome);
    return rows;
  }
  for (Verdict& row : rows) sign(row, last.engine, last.terms, expectations);
  const Subject subject{scenario.scene, plain, every, scales(scenario.scene, scenario.duration),
                        horizon(scenario)};
  const std::vector<told::Diagnostic> of_plain = plain.diagnostics;
  const std::optional<std::int64_t> bad = core::first_bad_step(plain);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    told = of_plain;
    rows[i].first_bad_step = bad;
    if (bad) {  // no scene can be told from such a state, and none needs be
      rows[i].measured = std::numeric_limits<double>::quiet_NaN();
      rows[i].cpu_seconds = plain.cpu_seconds, rows[i].cpu_verified = plain.cpu_verified;
      rows[i].status = results::judge(rows[i].measured, rows[i].allowed);
      continue;
    }
    try {
      rows[i].measured = asked[i]->deviation(subject, run);
      rows[i].cpu_seconds = plain.cpu_seconds, rows[i].cpu_verified = plain.cpu_verified;
      rows[i].complaints = last.stderr_tail;
      rows[i].diagnostics = told;
      rows[i].status = results::judge(rows[i].measured, rows[i].allowed);
    } catch (const RunFailed& failed) {
      fail(rows[i], failed.outcome);
      rows[i].detail = "in the transformed run: " + rows[i].detail;
    }
  }
  if (!bad) measure_spread(cell, subject, run, rows);
  return rows;
}

}  // namespace cylon::study
