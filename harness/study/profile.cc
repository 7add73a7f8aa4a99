#include "harness/study/profile.h"

#include "harness/core/last_step.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/study/paired_times.h"
#include "harness/study/spread.h"
#include "harness/tracking/statistics/metric_rules.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

namespace cylon::study {
namespace {

using core::Claim;
using core::Recording;
using scenario::Scenario;
using statistics::MetricKind;

process::RunOutcome record(const process::EngineChoice& engine, const core::Scene& scene, double dt,
                           const Sampling& plan, const process::Limits& limits) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = plan.steps, request.every = plan.every, request.at = plan.at, request.watch = plan.watch;
  request.contacts = plan.contacts;
  return process::run(engine, request, limits);
}

bool is_event(const Claim& claim) { return claim.observable.quantity == core::Quantity::event; }

double largest(const core::Series& series) {
  double most = 0;
  for (const double d : series.deviation) most = std::isnan(d) ? d : std::max(most, d);
  return most;
}

/// Of the claim's deviation, in the observable's unit.
double floor_of(const Claim& claim, const Scenario& scenario, const Recording& recording) {
  const double epsilon = recording.engine.precision == "float" ? 0x1p-23 : 0x1p-52;
  const double size = core::largest_value(claim, scenario.scene, scenario.duration);
  const double steps = std::max(1.0, scenario.duration / recording.dt);
  return claim.truth_error + 64 * epsilon * std::sqrt(steps) * (size > 0 ? size : 1);
}

/// The floor of the number that the claim makes of its deviation e: d(e^2) = 2 e de; a slope is per second.
double reduced(double floor, const Claim& claim, double value, double duration) {
  if (claim.reduction == core::Reduction::mean_square)
    return floor * (2 * std::sqrt(std::max(0.0, value)) + floor);
  return claim.reduction == core::Reduction::rate ? floor / duration : floor;
}

double chaos(const Claim& claim, const Scenario& scenario, const process::EngineChoice& engine,
             const Sampling& plan, const Recording& recording, const process::Limits& limits) {
  double apart = 0;
  constexpr int copies = 2;
  for (int i = 0; i < copies; ++i) {
    const process::RunOutcome outcome =
        record(engine, one_ulp_apart(scenario.scene, i, copies), recording.dt, plan, limits);
    if (outcome.recording)
      apart = std::fmax(apart, spread(claim, scenario.scene, recording, *outcome.recording));
  }
  return 4 * apart;
}

ClaimProfile profile_of(const Claim& claim, const Scenario& scenario, std::span<const Recording> recordings) {
  const Recording& recording = recordings.front();
  ClaimProfile result{.claim = claim.label, .unit = core::unit(claim)};
  const auto needed = static_cast<std::size_t>(core::runs_needed(claim));
  if (recordings.size() < needed) return result;
  const core::Reading reading = core::read(claim, scenario.scene, recording, scenario.duration);
  result.error =
      core::measure(claim, scenario.scene, recordings.first(needed), scenario.duration, reading).value;
  result.floor =
      core::of_chance(claim.observable.quantity) ? reading.allowed : floor_of(claim, scenario, recording);
  if (recordings.size() < 2 || is_event(claim) || !core::measures_motion(claim) ||
      core::controls_its_error(recording.engine, recording.terms))
    return result;
  const double coarse = largest(reading.series);
  const double fine = largest(core::deviation(claim, scenario.scene, recordings[1]));
  if (std::min(coarse, fine) > 10 * result.floor) result.order = std::log2(coarse / fine);
  return result;
}

/// The rule's sentence without the rule's own name, which stands in the metric's.
std::string without_name(std::string sentence, std::string_view name) {
  if (sentence.starts_with(std::string(name) + " ")) sentence.erase(0, name.size() + 1);
  return sentence;
}

results::ComparedMetric judged(std::string name, MetricKind kind, double before, double after,
                               double floor = 0) {
  const statistics::MetricResult result = statistics::judge(kind, before, after, floor);
  return {std::move(name), finding_of(result.outcome),
          without_name(result.sentence, statistics::rule_of(kind).subject)};
}

bool is_an_order(double order) {
  return std::isfinite(order) && std::round(order) >= 1 && std::abs(order - std::round(order)) <= 0.25;
}

}  // namespace

Profile profile(const Scenario& scenario, const process::EngineChoice& engine, double dt, Counter counter,
                const process::Limits& limits) {
  Profile result;
  const Sampling plan = sampling(scenario, dt);
  int runs = 2;
  for (const Claim& claim : scenario.claims) runs = std::max(runs, core::runs_needed(claim));
  std::vector<Recording> recordings;
  for (int i = 0; i < runs; ++i) {
    const double step = std::ldexp(dt, -i);
    process::RunOutcome outcome =
        record(engine, scenario.scene, step, i == 0 ? plan : sampling(scenario, step), limits);
    if (i == 0)
      result.status = outcome.status, result.reason = outcome.reason, result.version = outcome.engine.version;
    if (!outcome.recording) break;  // at half the step: there is no order then
    recordings.push_back(std::move(*outcome.recording));
  }
  if (recordings.empty()) return result;
  result.facts = exact_facts(recordings.front());
  const bool chaotic = std::find(scenario.tags.begin(), scenario.tags.end(), "chaos") != scenario.tags.end();
  for (const Claim& claim : scenario.claims) {
    if (core::of_last_step(claim.observable.quantity) &&
        core::untold_of_last_step(claim.observable, scenario.scene, recordings.front()))
      continue;  // forces that are not told have no error
    ClaimProfile row = profile_of(claim, scenario, recordings);
    if (chaotic) row.floor += chaos(claim, scenario, engine, plan, recordings.front(), limits);
    row.floor = reduced(row.floor, claim, row.error, scenario.duration);
    result.claims.push_back(row);
  }
  const std::int64_t steps = steps_to_count(scenario.scene.bodies.size(), plan.steps);
  result.instructions = count_instructions(
      engine, {.scene = &scenario.scene, .dt = dt, .steps = steps, .every = plan.every}, limits, counter);
  return result;
}

std::vector<results::ComparedMetric> compare_profiles(const Profile& before, const Profile& after) {
  std::vector<results::ComparedMetric> metrics;
  for (const ClaimProfile& b : before.claims) {
    const auto same = std::find_if(after.claims.begin(), after.claims.end(),
                                   [&](const ClaimProfile& other) { return other.claim == b.claim; });
    if (same == after.claims.end()) continue;
    const ClaimProfile& a = *same;
    metrics.push_back(
        judged("error of " + b.claim, MetricKind::error, b.error, a.error, std::max(b.floor, a.floor)));
    if (is_an_order(b.order) && std::isfinite(a.order))
      metrics.push_back(judged("order of " + b.claim, MetricKind::order, b.order, a.order));
  }
  if (!before.facts.state_hash.empty()) {  // a history may lack it
    const statistics::MetricResult hash =
        statistics::judge_hash(before.facts.state_hash, after.facts.state_hash);
    metrics.push_back({"state hash", finding_of(hash.outcome), without_name(hash.sentence, "hash")});
  }
  const struct {
    const char* name;
    std::int64_t before, after;
  } counts[] = {{"events", before.facts.events, after.facts.events},
                {"contacts", before.facts.contacts, after.facts.contacts}};
  for (const auto& c : counts)
    if (c.before > 0 || c.after > 0)
      metrics.push_back(
          judged(c.name, MetricKind::exact, static_cast<double>(c.before), static_cast<double>(c.after)));
  const InstructionCount &b = before.instructions, &a = after.instructions;
  if (b.instructions && a.instructions && b.steps == a.steps && b.counter == a.counter) {
    const bool exact = b.steps_alone && a.steps_alone;
    constexpr double printed =
        2000;  // digits that a worker prints, a few runs of it: some hundred were measured
    metrics.push_back(judged("instructions", MetricKind::exact, static_cast<double>(*b.instructions),
                             static_cast<double>(*a.instructions), exact ? 0 : printed));
  }
  return metrics;
}

}  // namespace cylon::study
