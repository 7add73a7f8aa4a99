#include "harness/study/yardstick.h"

#include "harness/core/event_find.h"
#include "harness/core/input_error.h"
#include "harness/core/measure.h"
#include "harness/core/scale.h"
#include "harness/core/turns.h"
#include "harness/core/worst.h"
#include "harness/scenario/bind_motion.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace cylon::study {
namespace {

using core::Claim;
using core::Quantity;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool is_place(Quantity q) {
  return q == Quantity::position || q == Quantity::orientation || q == Quantity::axis;
}
bool is_motion(Quantity q) {
  return is_place(q) || q == Quantity::velocity || q == Quantity::angular_velocity;
}

// What claims are measured by too (claims.md, scales); of angles a radian, and of counts one.
double scale_of(const Claim& claim, const scenario::Scenario& scenario) {
  const core::Observable& q = claim.observable;
  const bool count = q.quantity == Quantity::event && core::of_all(q.event_quantity);
  return count || core::unit(q) == "rad" ? 1 : core::scale(claim, scenario.scene, scenario.duration);
}

core::Truth truth_of(const Reference& reference, double duration) {
  const double last = static_cast<double>(reference.states.size() - 1);
  core::Truth truth;
  truth.source = reference.name;
  truth.state = [states = reference.states, last, duration](double t) {
    return states[static_cast<std::size_t>(std::llround(t / duration * last))];
  };
  return truth;
}

}  // namespace

Yardstick::Yardstick(const scenario::Scenario& scenario, std::int64_t samples,
                     const std::optional<Reference>& reference)
    : scenario_(&scenario), samples_(samples) {
  scenario::require_prepared(scenario);
  std::vector<Claim> claims = scenario.claims;
  std::set<std::string> truths;
  std::set<Quantity> constant;
  for (const Claim& claim : claims) {
    if (!core::measures_motion(claim)) continue;
    if (claim.truth && claim.observable.quantity != Quantity::event) truths.insert(claim.follows);
    if (!claim.truth) constant.insert(claim.observable.quantity);
  }
  truth_ = truths.empty() && reference ? reference->name : fmt::format("{}", fmt::join(truths, ", "));
  if (reference && truths.empty())
    for (const Quantity quantity : {Quantity::position, Quantity::orientation}) {
      Claim& claim = claims.emplace_back();
      claim.observable.quantity = quantity;
      claim.follows = reference->name;
      claim.truth = truth_of(*reference, scenario.duration);
    }
  for (const Quantity quantity : conserved(scenario.scene))
    if (!constant.contains(quantity)) claims.emplace_back().observable.quantity = quantity;
  scenario::bind_motion(claims, scenario.duration);

  std::map<std::string, std::vector<core::State>> states;  // of a truth, at the samples; made once
  for (const Claim& claim : claims) {
    if (!core::measures_motion(claim)) continue;
    if (claim.observable.quantity == Quantity::event) {
      ask_event(claim);
      continue;
    }
    if (!claim.truth) {
      ask(claim, nullptr, 0);
      continue;
    }
    if (reference && claim.follows == reference->name) {
      ask(claim, &reference->states, reference->resolution);
      continue;
    }
    std::vector<core::State>* known = nullptr;
    if (claim.truth->times.empty()) {
      known = &states[fmt::format("{} {}", claim.follows, claim.until)];
      const double end = std::min(claim.until, scenario.duration) * (1 + 1e-12);
      for (std::int64_t k = static_cast<std::int64_t>(known->size()); k <= samples_; ++k) {
        const double t = scenario.duration * static_cast<double>(k) / static_cast<double>(samples_);
        if (t > end) break;
        known->push_back(claim.truth->state(std::min(t, scenario.duration)));
      }
    }
    ask(claim, known, claim.truth_error);
  }
  choose_trajectory();
}

std::size_t Yardstick::measure_named(const std::string& name, const std::string& unit,
                                     const std::string& against) {
  for (std::size_t i = 0; i < measures_.size(); ++i)
    if (measures_[i].name == name) return i;
  measures_.push_back({name, unit, 0, against, 0});
  return measures_.size() - 1;
}

void Yardstick::ask(Claim claim, const std::vector<core::State>* states, double resolution) {
  const core::Scene& scene = scenario_->scene;
  if (core::undefined_in(claim.observable, scene)) return;
  Question q;
  q.scale = scale_of(claim, *scenario_);
  const bool follows = claim.truth.has_value();
  q.in_trajectory = follows && is_motion(claim.observable.quantity);

  const double end = std::min(claim.until, scenario_->duration) * (1 + 1e-12);
  core::Values values;
  core::AlongMotion motion(claim.observable, scene);
  for (std::int64_t k = 0; k <= samples_; ++k) {
    const double t = scenario_->duration * static_cast<double>(k) / static_cast<double>(samples_);
    if (t > end) break;
    if (!follows || states) {
      if (states) motion.evaluate(t, (*states)[static_cast<std::size_t>(k)], values);
    } else {
      const auto& times = claim.truth->times;  // known at these alone
      const auto near = std::find_if(times.begin(), times.end(), [&](double known) {
        return std::abs(known - t) <= 1e-9 * scenario_->duration;
      });
      if (near == times.end()) continue;
      motion.evaluate(*near, claim.truth->state(*near), values);
    }
    q.at.push_back(k);
    if (follows) q.want.push_back(values);
  }
  if (motion.lost()) return;  // the samples of the truth are too far apart to count its turns
  if (motion.counts()) every_step_ = true;
  q.measure = measure_named(std::string(core::name(claim.observable.quantity)),
                            std::string(core::unit(claim.observable)), follows ? claim.follows : "its start");
  results::TradeMeasure& measure = measures_[q.measure];
  measure.scale = std::max(measure.scale, q.scale);
  measure.resolution = std::max(measure.resolution, resolution / q.scale);
  if (!follows) {
    core::evaluate(claim.observable, scene, core::initial_state(scene), values);
    q.want = {values};
  }
  if (claim.reduction == core::Reduction::end && !q.at.empty()) {
    q.at = {q.at.back()};
    q.want = {q.want.back()};
  }
  q.claim = std::move(claim);
  questions_.push_back(std::move(q));
}

void Yardstick::ask_event(const Claim& claim) {
  Question q;
  q.scale = scale_of(claim, *scenario_);
  q.measure = measure_named("events", "", claim.follows);
  results::TradeMeasure& measure = measures_[q.measure];
  measure.resolution = std::max(measure.resolution, claim.truth_error / q.scale);
  q.claim = claim;
  questions_.push_back(std::move(q));
  if (!core::watched(claim.observable.event)) {
    every_step_ = true;
    return;
  }
  const auto pairs = claim.observable.body ? core::touching_pairs(scenario_->scene, *claim.observable.body)
                                           : core::touching_pairs(scenario_->scene);
  for (const core::Pair& pair : pairs)
    if (std::find(watch_.begin(), watch_.end(), pair) == watch_.end()) watch_.push_back(pair);
}

// Places and orientations make the trajectory; where none is followed, velocities.
void Yardstick::choose_trajectory() {
  const auto place = [](const Question& q) { return is_place(q.claim.observable.quantity); };
  const bool any_place = std::any_of(questions_.begin(), questions_.end(),
                                     [&](const Question& q) { return q.in_trajectory && place(q); });
  results::TradeMeasure trajectory{"trajectory", "", 0, truth_, 0};
  bool any = false;
  for (Question& q : questions_) {
    q.in_trajectory = q.in_trajectory && (place(q) || !any_place);
    if (!q.in_trajectory) continue;
    any = true;
    trajectory.resolution = std::max(trajectory.resolution, measures_[q.measure].resolution);
  }
  if (any) {
    measures_.insert(measures_.begin(), trajectory);
    for (Question& q : questions_) ++q.measure;
    return;
  }
  for (const char* name : {"events", "energy", "angular_momentum", "linear_momentum"})
    for (std::size_t i = 0; i < measures_.size(); ++i)
      if (measures_[i].name == name) {
        principal_ = i;
        return;
      }
}

std::size_t Yardstick::find(const std::string& name) const {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < measures_.size(); ++i) {
    if (measures_[i].name == name) return i;
    names.push_back(measures_[i].name);
  }
  throw core::InputError(fmt::format("--observable '{}': {} is not measured by that{} (measures: {})", name,
                                     scenario_->name, core::did_you_mean(name, names),
                                     fmt::join(names, ", ")));
}

process::RunRequest Yardstick::request(std::int64_t steps) const {
  process::RunRequest request;
  request.scene = &scenario_->scene;
  request.setup.dt = scenario_->duration / static_cast<double>(steps);
  request.steps = steps;
  request.every = every_step_ ? 1 : steps / samples_;  // events are found on the arcs between all steps
  request.watch = watch_;
  return request;
}

double Yardstick::worst_deviation(const Question& q, const core::Recording& recording) const {
  const std::int64_t stride = recording.steps.back() / samples_;
  core::Values got;
  core::AlongMotion motion(q.claim.observable, scenario_->scene);
  double worst = 0;
  std::size_t i = 0;
  for (std::size_t k = 0; k < q.at.size(); ++k) {
    for (; recording.steps[i] < q.at[k] * stride; ++i)
      if (motion.counts()) motion.evaluate(recording.time(i), recording.states[i], got);
    motion.evaluate(recording.time(i), recording.states[i], got);
    worst = core::worst(core::distance(q.claim.observable, got, q.claim.truth ? q.want[k] : q.want.front()),
                        worst);
  }
  return worst;
}

std::vector<double> Yardstick::errors(const core::Recording& recording) const {
  if (core::first_bad_step(recording)) return std::vector<double>(measures_.size(), nan);
  std::vector<double> errors(measures_.size(), 0);
  for (const Question& q : questions_) {
    const bool event = q.claim.observable.quantity == Quantity::event;
    const double value =
        event ? core::measure(q.claim, scenario_->scene, std::span(&recording, 1), scenario_->duration).value
              : worst_deviation(q, recording);
    const double error = value / q.scale;
    errors[q.measure] = core::worst(error, errors[q.measure]);
    if (q.in_trajectory) errors.front() = core::worst(error, errors.front());
  }
  return errors;
}

}  // namespace cylon::study
