#include "harness/study/theory.h"

#include "harness/core/measure.h"
#include "harness/core/observable_rows.h"
#include "harness/core/scale.h"
#include "harness/core/worst.h"
#include "harness/study/row.h"
#include "harness/study/runner.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace cylon::study {
namespace {

using core::Claim;
using core::Recording;
using results::Verdict;
using scenario::Scenario;
using scenario::Theory;

// Half a power short of the declared order: steps are in the asymptotic range, yet two terms of the error may
// still partly cancel.
constexpr double order_slack = 0.5;
// A closed form states no tolerance; it is held to this.
constexpr double closed_form = 1e-10;
constexpr double misjudged = 10;  // An estimate of an error may be too small by this.
constexpr double roundings_a_step = 10;
constexpr int finest = 2;  // halvings, to see an order

// In the quantities that err.
double degree(const Claim& claim) {
  const core::Quantity q = claim.observable.quantity;
  const bool product = q == core::Quantity::energy || q == core::Quantity::kinetic_energy ||
                       q == core::Quantity::angular_momentum;
  return product ? 2 : 1;
}

class Judge {
 public:
  Judge(const Scenario& cut, double step, const std::function<Recording(int)>& run)
      : scenario_(cut), theory_(*cut.theory), step_(step), run_(run) {
    recordings_.push_back(run_(0));
    promise_ = promise_of(recordings_[0].engine, recordings_[0].terms);
  }

  std::vector<TheoryFinding> findings() {
    for (const Claim& claim : scenario_.claims) ask(claim);
    return std::move(findings_);
  }

 private:
  void ask(const Claim& claim) {
    const Bound bound = bound_of(scenario_, claim, step_, recordings_[0]);
    TheoryFinding found;
    found.claim = "theory: " + claim.label;
    found.observable = core::name(claim.observable.quantity);
    found.unit = core::unit(claim.observable);
    found.measured = deviation(claim, 0);
    found.allowed = bound.allowed;
    found.truth_error = claim.truth_error;
    found.reason = bound.reason;
    const double scale = core::scale(claim, scenario_.scene, scenario_.duration);
    found.binds = bound.allowed < scale;
    findings_.push_back(found);
    const bool asymptotic = bound.allowed < 0.1 * scale;
    if (claim.truth && !promise_.adaptive && asymptotic && theory_.forces == Theory::Forces::smooth)
      ask_order(claim, bound);
  }

  void ask_order(const Claim& claim, const Bound& bound) {
    std::vector<double> steps, errors;
    for (int k = 0; k <= finest; ++k) {
      errors.push_back(deviation(claim, k));
      steps.push_back(std::ldexp(step_, -k));
      if (errors.back() <= 4 * (bound.rounding + claim.truth_error)) return;
    }
    const double order = core::observed_order(steps, errors);
    TheoryFinding found;
    found.claim = "theory: order of " + claim.label;
    found.observable = core::name(claim.observable.quantity);
    found.measured = std::max(0.0, promise_.order - order);
    found.allowed = order_slack;
    found.reason = fmt::format("theory: the error falls as h^{}, less {:g} for terms that cancel",
                               promise_.order, order_slack);
    found.detail = fmt::format("observed order {:.2f}, declared {}", order, promise_.order);
    findings_.push_back(found);
  }

  double deviation(const Claim& claim, int k) {
    while (recordings_.size() <= static_cast<std::size_t>(k))
      recordings_.push_back(run_(static_cast<int>(recordings_.size())));
    const core::Series series =
        core::deviation(claim, scenario_.scene, recordings_[static_cast<std::size_t>(k)]);
    if (series.deviation.empty()) return std::numeric_limits<double>::quiet_NaN();
    if (claim.reduction == core::Reduction::end) return series.deviation.back();
    double most = 0;
    for (const double d : series.deviation) most = core::worst(d, most);
    return most;
  }

  const Scenario& scenario_;
  const Theory& theory_;
  double step_;
  const std::function<Recording(int)>& run_;
  Promise promise_;
  std::vector<Recording> recordings_;  // at h, h/2, h/4
  std::vector<TheoryFinding> findings_;
};

double tolerance_of(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error == std::errc() && stop == end && value > 0 && std::isfinite(value)) return value;
  process::RunOutcome outcome;
  outcome.status = results::Status::protocol;
  outcome.reason = fmt::format("the engine states the tolerance '{}', which is no number above 0", text);
  throw RunFailed{outcome};
}

bool theory_speaks_of(const Claim& claim, double until) {
  const auto known = [&](double t) { return t <= until; };
  return claim.observable.quantity != core::Quantity::event && core::measures_motion(claim) &&
         claim.reduction <= core::Reduction::end &&
         !(claim.truth && !claim.truth->times.empty() && std::ranges::none_of(claim.truth->times, known));
}

}  // namespace

Promise promise_of(const core::Engine& engine, const core::Terms& terms) {
  Promise promise{terms.order, core::controls_its_error(engine, terms), closed_form, false};
  if (!promise.adaptive) return promise;
  for (const core::Setting& setting : terms.settings) {
    if (setting.name != "tolerance" && setting.name != "tolerance of a step") continue;
    promise.tolerance = tolerance_of(setting.value);
    promise.each_step = setting.name == "tolerance of a step";
  }
  return promise;
}

namespace {

// What the rounding of the state alone makes of the quantity, in units of epsilon: its first-order error where
// each place, velocity and turn is wrong by its own size.  A spring 10^6 m from the origin feels its length only
// to the rounding of 10^6 m.
double rounding_of_state(const Claim& claim, const core::Scene& scene) {
  const core::State start = core::initial_state(scene);
  core::StateError sizes{0, 0, 1, 0};
  for (const core::BodyState& s : start) {
    sizes.position = std::max(sizes.position, s.position.norm());
    sizes.velocity = std::max(sizes.velocity, s.velocity.norm());
    sizes.angular_velocity = std::max(sizes.angular_velocity, s.angular_velocity.norm());
  }
  return core::observable_row(claim.observable.quantity).error(claim.observable, scene, start, sizes);
}

}  // namespace

Bound bound_of(const Scenario& scenario, const Claim& claim, double step, const Recording& run) {
  const Theory& theory = scenario.theory.value();
  const Promise promise = promise_of(run.engine, run.terms);
  const double scale = core::scale(claim, scenario.scene, scenario.duration);
  const double size = scale * theory.magnification, turns = theory.rate * scenario.duration;
  const double largest = std::max({scale, core::largest_value(claim, scenario.scene, scenario.duration),
                                   rounding_of_state(claim, scenario.scene)});
  Bound bound;
  bound.rounding = roundings_a_step * core::epsilon(run.engine) * (scenario.duration / step) * largest *
                   theory.magnification;
  const std::string of = fmt::format(
      "W = {:.4g}/s ({}), scale {:.4g}{}", theory.rate, theory.reason, scale,
      theory.magnification == 1 ? "" : fmt::format(", magnified {:.4g} times", theory.magnification));
  if (promise.adaptive) {
    bound.allowed = misjudged * promise.tolerance * size * (promise.each_step ? turns : 1);
    bound.reason =
        fmt::format("theory: {:g} times the tolerance {:.3g}{} of {}; {}", misjudged, promise.tolerance,
                    promise.each_step ? " of each step" : "", run.terms.integrator, of);
  } else {
    const int order = theory.forces == Theory::Forces::jumping ? 1 : promise.order;
    bound.allowed = size * std::expm1(degree(claim) * std::pow(theory.rate * step, order) * turns);
    bound.reason = fmt::format("theory: S (e^x - 1), x = {}(W h)^{} W T, of {}; {}",
                               degree(claim) == 2 ? "2 " : "", order, run.terms.integrator, of);
  }
  bound.allowed += bound.rounding + claim.truth_error;
  return bound;
}

Scenario cut_to_theory(const Scenario& scenario) {
  Scenario cut = scenario;
  cut.duration = std::min(scenario.duration, scenario.theory->until);
  std::erase_if(cut.claims, [&](const Claim& claim) { return !theory_speaks_of(claim, cut.duration); });
  for (Claim& claim : cut.claims) claim.until = std::min(claim.until, cut.duration);
  return cut;
}

std::vector<TheoryFinding> judge_by_theory(const Scenario& cut, double step,
                                           const std::function<Recording(int)>& run) {
  return Judge(cut, step, run).findings();
}

std::vector<Verdict> theorize(const Cell& cell, const process::Limits& limits,
                              const scenario::Expectations& expectations) {
  if (!cell.scenario->theory) return {};
  const Scenario cut = cut_to_theory(*cell.scenario);
  process::RunOutcome last;
  double cpu = 0;
  bool verified = false;
  std::string sampled;
  const auto run_at = [&](int k) {
    const double dt = std::ldexp(cell.dt, -k);
    const Sampling plan = sampling(cut, dt);
    process::RunRequest request;
    request.scene = &cut.scene;
    request.setup.dt = dt;
    request.setup.force = cell.force;
    request.steps = plan.steps, request.every = plan.every, request.at = plan.at;
    last = process::run(cell.engine, request, limits);
    if (last.status != results::Status::pass || !last.recording) throw RunFailed{last};
    if (k == 0)
      cpu = last.recording->cpu_seconds, verified = last.recording->cpu_verified, sampled = plan.text;
    return *last.recording;
  };
  const auto row_of = [&](const TheoryFinding& found) {
    Verdict row = open_row(cell, found.claim, expectations);
    row.observable = found.observable, row.unit = found.unit;
    row.measured = found.measured, row.truth_error = found.truth_error;
    row.allowed = found.allowed * cell.tolerance_scale, row.tolerance_scale = cell.tolerance_scale;
    row.tolerance_reason = found.reason, row.detail = found.detail;
    row.sampling = sampled;
    row.body_steps = static_cast<std::int64_t>(cut.scene.bodies.size()) *
                     static_cast<std::int64_t>(std::llround(cut.duration / cell.dt));
    row.cpu_seconds = cpu, row.cpu_verified = verified, row.complaints = last.stderr_tail;
    sign(row, last.engine, last.terms, expectations);
    return row;
  };
  std::vector<Verdict> rows;
  try {
    for (const TheoryFinding& found : judge_by_theory(cut, cell.dt, run_at)) {
      rows.push_back(row_of(found));
      Verdict& row = rows.back();
      row.status = results::judge(row.measured, row.allowed);
      if (!found.binds && row.status != results::Status::non_finite) {
        row.status = row.expected = results::Status::undecided;  // it ran, and is no refusal
        row.detail =
            "Theory bounds nothing at this step: it allows an error as large as the motion. Take a "
            "smaller step.";
      }
      const bool nothing_passes = cell.tolerance_scale == 0;
      if (nothing_passes && row.status == results::Status::pass) row.status = results::Status::fail;
    }
  } catch (const RunFailed& failed) {
    rows.clear();
    for (const Claim& claim : cut.claims) {
      rows.push_back(row_of({.claim = "theory: " + claim.label,
                             .observable = std::string(core::name(claim.observable.quantity)),
                             .unit = std::string(core::unit(claim.observable)),
                             .measured = std::numeric_limits<double>::quiet_NaN()}));
      rows.back().status = failed.outcome.status, rows.back().detail = failed.outcome.reason;
    }
  }
  return rows;
}

}  // namespace cylon::study
