#include "harness/study/cell.h"

#include "harness/core/event_find.h"
#include "harness/core/input_error.h"
#include "harness/core/uncertain.h"
#include "harness/core/worst.h"
#include "harness/study/row.h"
#include "harness/study/spread.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>
#include <variant>

namespace cylon::study {
namespace {

using core::Claim;
using results::Verdict;
using scenario::Scenario;

std::int64_t steps_of(const Scenario& scenario, double time, double dt, const std::string& what) {
  try {
    return core::whole_steps(time, dt);
  } catch (const std::invalid_argument& error) {
    throw core::InputError(fmt::format("{}: {}: {}", scenario.name, what, error.what()));
  }
}

// The pairs whose events some claim asks for, in the order of touching_pairs; no claim, no search.
std::vector<core::Pair> watched(const Scenario& scenario) {
  std::vector<core::Pair> pairs;
  for (const Claim& claim : scenario.claims) {
    const core::Observable& q = claim.observable;
    if (q.quantity != core::Quantity::event || !core::watched(q.event)) continue;
    if (!q.body) return core::touching_pairs(scenario.scene);
    const auto of_body = core::touching_pairs(scenario.scene, *q.body);
    pairs.insert(pairs.end(), of_body.begin(), of_body.end());
  }
  std::sort(pairs.begin(), pairs.end(), [](const core::Pair& a, const core::Pair& b) {
    return std::tuple(a.body, a.plane, a.other) < std::tuple(b.body, b.plane, b.other);
  });
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

constexpr const char* at_the_file = "the times of the file";

// Where a claim looks: `sampling` below asks the run for these.
std::string sampled(const Claim& claim, const Sampling& plan) {
  if (claim.observable.quantity == core::Quantity::event) return "every step";
  if (core::of_last_step(claim.observable.quantity)) return "the last step";
  if (claim.truth && !claim.truth->times.empty()) return at_the_file;
  return claim.sample && *claim.sample > 0 ? fmt::format("every {} s", *claim.sample) : plan.text;
}

Verdict blank(const Cell& cell, const Claim& claim, const Sampling& plan,
              const scenario::Expectations& expectations) {
  Verdict row = open_row(cell, claim.label, expectations);
  row.sampling = sampled(claim, plan);
  row.observable = core::name(claim.observable.quantity);
  row.unit = core::unit(claim);
  row.evidence = core::evidence(claim);
  row.tolerance_scale = cell.tolerance_scale;
  row.truth_error = claim.truth_error;
  row.tolerance_reason = claim.tolerance.reason;
  row.body_steps = static_cast<std::int64_t>(cell.scenario->scene.bodies.size()) * plan.steps;
  return row;
}

void judge(Verdict& row, const Claim& claim, const Cell& cell, const core::Measured& measured,
           std::span<const core::Recording> recordings, std::optional<std::int64_t> first_bad_step) {
  row.measured = measured.value;
  if (measured.interval) row.interval = results::Bounds{measured.interval->first, measured.interval->second};
  row.allowed = measured.allowed * cell.tolerance_scale;
  row.first_bad_step = first_bad_step;
  row.detail = measured.detail;
  for (const std::string& remark : recordings.front().remarks) add_detail(row, remark);
  row.diagnostics = recordings.front().diagnostics;
  row.status =
      row.interval ? results::judge(*row.interval, row.allowed) : results::judge(measured.value, row.allowed);
  const bool nothing_passes = cell.tolerance_scale == 0;  // a residual of zero neither
  if ((measured.broken && row.status != results::Status::non_finite) ||
      (nothing_passes && row.status == results::Status::pass))
    row.status = results::Status::fail;
  if (measured.unanswered) row.status = results::Status::unsupported;
  // A run that broke within the claim's horizon proves nothing, whatever the claim reads of its states.
  if (!first_bad_step || static_cast<double>(*first_bad_step) * row.dt > claim.until) return;
  row.status = results::Status::non_finite;
  row.measured = std::numeric_limits<double>::quiet_NaN();
  row.interval.reset();
}

// A run of the scene, which is the scenario's or a copy of it.
process::RunOutcome record(const Cell& cell, const core::Scene& scene, double dt, const Sampling& samples,
                           const process::Limits& limits) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.setup.force = cell.force;
  request.steps = samples.steps, request.every = samples.every, request.at = samples.at,
  request.watch = samples.watch, request.contacts = samples.contacts;
  return process::run(cell.engine, request, limits);
}

// Runs whose start or surfaces are off as measured ones may be: once for all claims of one measured motion.
class PushedRuns {
 public:
  PushedRuns(const Cell& cell, const Sampling& plan, const process::Limits& limits)
      : cell_(cell), plan_(plan), limits_(limits) {}

  // Of the claim's; the outcome of the first that did not reach its end.
  std::variant<std::span<const core::Pushed>, process::RunOutcome> of(const Claim& claim) {
    const core::Uncertainty* about = claim.uncertainty.get();
    auto& runs = known_[about];
    for (std::size_t i = runs.size(); i < about->scenes.size(); ++i) {
      process::RunOutcome up = record(cell_, about->scenes[i].first, cell_.dt, plan_, limits_);
      if (!up.recording) return up;
      process::RunOutcome down = record(cell_, about->scenes[i].second, cell_.dt, plan_, limits_);
      if (!down.recording) return down;
      runs.emplace_back(std::move(*up.recording), std::move(*down.recording));
    }
    return std::span<const core::Pushed>(runs);
  }

 private:
  const Cell& cell_;
  const Sampling& plan_;
  const process::Limits& limits_;
  std::map<const core::Uncertainty*, std::vector<core::Pushed>> known_;
};

void judge_uncertain(Verdict& row, const Claim& claim, const Cell& cell, PushedRuns& pushed,
                     std::span<const core::Recording> recordings,
                     std::optional<std::int64_t> first_bad_step) {
  const auto found = pushed.of(claim);
  if (const auto* failed = std::get_if<process::RunOutcome>(&found)) {
    row.status = failed->status;
    row.detail =
        fmt::format("from a start, or with surfaces, off by a standard deviation: {}", failed->reason);
    return;
  }
  const core::Measured measured = core::measure_uncertain(claim, cell.scenario->scene, recordings.front(),
                                                          std::get<std::span<const core::Pushed>>(found));
  judge(row, claim, cell, measured, recordings, first_bad_step);
}

void measure_spread(const Cell& cell, const Sampling& plan, const process::Limits& limits,
                    const core::Recording& recording, std::vector<Verdict>& rows) {
  const Scenario& scenario = *cell.scenario;
  const int copies = copies_of(cell);
  for (int i = 0; i < copies; ++i) {
    const core::Scene nudged = one_ulp_apart(scenario.scene, i, copies);
    const process::RunOutcome outcome = record(cell, nudged, cell.dt, plan, limits);
    for (std::size_t k = 0; k < rows.size(); ++k) {
      if (!outcome.recording) {
        tell_failed_copy(rows[k], i, outcome);
        continue;
      }
      const double apart = spread(scenario.claims[k], scenario.scene, recording, *outcome.recording);
      rows[k].spread = core::worst(apart, rows[k].spread.value_or(0));
    }
  }
  for (Verdict& row : rows) tell_spread(row, copies);
}

// Whole steps up to the end of a claim.
std::int64_t steps_until(const Claim& claim, const Scenario& scenario, double dt) {
  return static_cast<std::int64_t>(std::min(claim.until, scenario.duration) / dt * (1 + 1e-9));
}

// Whether no step of the run counts: it would pass with the start alone.
bool sees_the_start_alone(const Claim& claim, const Scenario& scenario, double dt) {
  return claim.observable.quantity != core::Quantity::event &&
         !core::of_last_step(claim.observable.quantity) && !claim.at_least &&
         (!claim.truth || claim.truth->times.empty()) &&
         steps_until(claim, scenario, dt) < core::samples_needed(claim);
}

}  // namespace

Sampling sampling(const Scenario& scenario, double dt) {
  scenario::require_prepared(scenario);
  Sampling plan;
  plan.steps = steps_of(scenario, scenario.duration, dt, "the duration");
  plan.watch = watched(scenario);
  std::int64_t every = 0;  // gcd of what the claims ask for
  std::set<std::int64_t> at;
  for (const Claim& claim : scenario.claims) {
    if (claim.observable.quantity == core::Quantity::event) {
      if (!core::watched(claim.observable.event)) every = 1;  // found in the states of every step
      continue;
    }
    if (core::of_last_step(claim.observable.quantity)) {
      plan.contacts = true;
      at.insert(std::max<std::int64_t>(1, plan.steps - 1));
      continue;
    }
    if (claim.truth && !claim.truth->times.empty()) {
      for (const double t : claim.truth->times)
        if (t > 0 && t <= std::min(claim.until, scenario.duration))
          at.insert(steps_of(scenario, t, dt, "a time of the recorded truth"));
      continue;
    }
    if (claim.at_least) at.insert(std::min(plan.steps, core::last_step_of_change(claim, dt)));
    const auto last = std::max<std::int64_t>(1, steps_until(claim, scenario, dt));
    std::int64_t stride = 1;
    if (!claim.sample)
      stride = core::sampling_stride(scenario.scene.bodies.size(), plan.steps, dt, 0);
    else if (*claim.sample > 0)
      stride = steps_of(scenario, *claim.sample, dt, "a claim's sampling");
    stride = std::min(stride, last);  // not the start alone
    every = std::gcd(every, stride);
  }
  plan.every = every > 0 ? every : std::max<std::int64_t>(1, plan.steps);
  plan.at.assign(at.begin(), at.end());
  plan.text = every == 0 && !at.empty()       ? at_the_file  // no claim asks for a stride
              : plan.every == 1 || every == 0 ? "every step"
                                              : fmt::format("every {} steps", plan.every);
  return plan;
}

std::vector<Verdict> run(const Cell& cell, const process::Limits& limits,
                         const scenario::Expectations& expectations) {
  const Scenario& scenario = *cell.scenario;
  const Sampling plan = sampling(scenario, cell.dt);
  std::vector<Verdict> rows;
  for (const Claim& claim : scenario.claims) rows.push_back(blank(cell, claim, plan, expectations));

  int runs = 1;
  for (const Claim& claim : scenario.claims) runs = std::max(runs, core::runs_needed(claim));
  std::vector<core::Recording> recordings;
  std::vector<core::Reading> readings;  // of the first run
  for (int i = 0; i < runs; ++i) {
    const double dt = std::ldexp(cell.dt, -i);
    const Sampling samples = i == 0 ? plan : sampling(scenario, dt);
    process::RunOutcome outcome = record(cell, scenario.scene, dt, samples, limits);
    if (i == 0) {
      if (outcome.recording)
        for (const Claim& claim : scenario.claims)
          readings.push_back(core::read(claim, scenario.scene, *outcome.recording, scenario.duration));
      if (cell.seen) cell.seen(outcome, readings);
    }
    for (Verdict& row : rows) {
      if (i == 0) {
        sign(row, outcome.engine, outcome.terms, expectations);
        if (outcome.recording)
          row.cpu_seconds = outcome.recording->cpu_seconds,
          row.cpu_verified = outcome.recording->cpu_verified;
      }
      row.complaints = outcome.stderr_tail;
      if (outcome.status != results::Status::pass) row.status = outcome.status, row.detail = outcome.reason;
    }
    if (outcome.status != results::Status::pass || !outcome.recording) return rows;
    recordings.push_back(std::move(*outcome.recording));
  }
  const auto bad = core::first_bad_step(recordings.front());
  PushedRuns pushed(cell, plan, limits);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Claim& claim = scenario.claims[i];
    if (core::validates(claim))
      judge_uncertain(rows[i], claim, cell, pushed, recordings, bad);
    else
      judge(rows[i], claim, cell,
            core::measure(claim, scenario.scene, recordings, scenario.duration, readings[i]), recordings,
            bad);
  }
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (sees_the_start_alone(scenario.claims[i], scenario, cell.dt)) {
      rows[i].status = results::Status::unsupported;
      const Claim& claim = scenario.claims[i];
      rows[i].detail = fmt::format(
          "the claim ends at {} s, within the first {}", std::min(claim.until, scenario.duration),
          core::samples_needed(claim) == 1 ? "step" : "two steps, of which the last has no weight");
    }
  if (!bad) measure_spread(cell, plan, limits, recordings.front(), rows);
  return rows;
}

}  // namespace cylon::study
