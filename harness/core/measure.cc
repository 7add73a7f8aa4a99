#include "harness/core/measure.h"

#include "harness/core/equipartition.h"
#include "harness/core/event_find.h"
#include "harness/core/event_rows.h"
#include "harness/core/last_step.h"
#include "harness/core/scale.h"
#include "harness/core/turns.h"
#include "harness/core/worst.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>

namespace cylon::core {

std::int64_t last_step_of_change(const Claim& claim, double dt) {
  constexpr double most = 0x1p62;
  return static_cast<std::int64_t>(std::min(std::ceil(claim.until / dt * (1 - 1e-12)), most));
}

namespace {

// "0.013 m"; a number without a unit stays alone.
std::string with_unit(double value, std::string_view unit) {
  return fmt::format("{:.3g}{}{}", value, unit.empty() ? "" : " ", unit);
}

double horizon(const Claim& claim, double duration) { return std::min(claim.until, duration); }

// Whether the claim looks at the sample after `step` steps.
class Chosen {
 public:
  Chosen(const Claim& claim, double dt, std::int64_t last)
      : last_(claim.at_least ? std::min(last, last_step_of_change(claim, dt)) : last),
        until_(claim.at_least ? static_cast<double>(last_) : claim.until / dt * (1 + 1e-12)) {
    if (claim.truth && !claim.truth->times.empty())
      for (const double t : claim.truth->times) at_.insert(std::llround(t / dt));
    else if (claim.sample && *claim.sample > 0)
      stride_ = whole_steps(*claim.sample, dt);
  }
  bool operator()(std::int64_t step) const {
    if (static_cast<double>(step) > until_) return false;
    if (!at_.empty()) return at_.contains(step);
    return step % stride_ == 0 || step == last_;
  }

 private:
  std::int64_t last_, stride_ = 1;
  double until_;
  std::set<std::int64_t> at_;
};

double reduce(Reduction reduction, const Series& series) {
  const std::size_t n = series.deviation.size();
  double result = 0;
  switch (reduction) {
    case Reduction::end:
      return n ? series.deviation.back() : 0;
    case Reduction::max:
    case Reduction::order:
    case Reduction::increase:
    case Reduction::decrease:
      for (const double d : series.deviation) result = worst(d, result);
      return result;
    case Reduction::mean_square: {
      // (1/T) sum d_n^2 (t_{n+1} - t_n)
      for (std::size_t i = 0; i + 1 < n; ++i)
        result += series.deviation[i] * series.deviation[i] * (series.time[i + 1] - series.time[i]);
      return n > 1 ? result / (series.time.back() - series.time.front()) : 0;
    }
    case Reduction::rate: {
      double st = 0, sd = 0, stt = 0, std_ = 0;
      for (std::size_t i = 0; i < n; ++i) {
        st += series.time[i], sd += series.deviation[i];
        stt += series.time[i] * series.time[i], std_ += series.time[i] * series.deviation[i];
      }
      const double count = static_cast<double>(n), spread = count * stt - st * st;
      return spread > 0 ? std::abs((count * std_ - st * sd) / spread) : 0;
    }
  }
  return result;
}

std::vector<Event> asked_for(const Claim& claim, const std::vector<Event>& events) {
  std::vector<Event> chosen;
  for (const Event& event : events)
    if (claimed(claim.observable, event) && !(event.time > claim.until)) chosen.push_back(event);
  return chosen;
}

std::string pair_name(const Scene& scene, const Pair& pair) {
  const auto body = [&](int i) { return scene.bodies[static_cast<std::size_t>(i)].name; };
  return fmt::format(
      "{} and {}", body(pair.body),
      pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name : body(pair.other));
}

// How many of the two sequences of pairs are not at the same place.
void measure_order(const Claim& claim, const Scene& scene, const Recording& recording, Measured& result) {
  const std::vector<Event> want = asked_for(claim, claim.truth->events),
                           got = asked_for(claim, recording.events);
  const std::size_t most = std::max(want.size(), got.size());
  for (std::size_t i = 0; i < most; ++i) {
    if (i < want.size() && i < got.size() && want[i].pair == got[i].pair) continue;
    if (result.value++ > 0) continue;
    const auto what = [&](const std::vector<Event>& events) {
      return i < events.size() ? pair_name(scene, events[i].pair) : "nothing";
    };
    result.detail = fmt::format("collision {} is of {}, but {} was expected", i + 1, what(got), what(want));
  }
}

// How many events there are too many, or too few.
void measure_count(const Claim& claim, const std::vector<Event>& found, Measured& result) {
  const std::size_t want = asked_for(claim, claim.truth->events).size(), got = asked_for(claim, found).size();
  result.value = std::abs(static_cast<double>(got) - static_cast<double>(want));
  if (got != want) result.detail = fmt::format("{} came, but {} were expected", got, want);
}

void measure_event(const Claim& claim, const Scene& scene, const Recording& recording, Measured& result) {
  const Observable& q = claim.observable;
  if (q.event_quantity == EventQuantity::order) return measure_order(claim, scene, recording, result);
  const std::vector<Event> found = find_events(q, scene, recording);
  if (q.event_quantity == EventQuantity::count) return measure_count(claim, found, result);
  for (const Event& want : asked_for(claim, claim.truth->events)) {
    const double due = quantity(claim.truth->events, want, q.event_quantity).value_or(0);
    const auto event = std::find_if(found.begin(), found.end(), [&](const Event& e) {
      return e.kind == want.kind && e.index == want.index && e.pair == want.pair;
    });
    const auto came = event == found.end() ? std::nullopt : quantity(found, *event, q.event_quantity);
    if (!came) {
      result.broken = true;
      result.detail = fmt::format("the {} number {} never came", name(q.event), q.index);
      result.value = std::abs(due);  // all of it is missing
      return;
    }
    result.value = worst(std::abs(*came - due), result.value);
  }
}

// The highest order up to `declared` that has a constant, and that constant.
std::optional<std::pair<int, double>> constant_of(const Tolerance& tolerance, int declared) {
  if (tolerance.constants.empty()) return std::pair(declared, tolerance.constant);
  const auto above = tolerance.constants.upper_bound(declared);
  if (above == tolerance.constants.begin()) return std::nullopt;
  return *std::prev(above);
}

// Whether the run was of an integrator that chooses its steps, and went by it: events in between lower the
// order.
bool chose_its_steps(const Recording& recording) {
  const Engine& engine = recording.engine;
  const Terms& terms = recording.terms;
  return controls_its_error(engine, terms) && engine.integrator(terms.integrator)->order == terms.order;
}

// What rounding alone makes of n steps: 64 eps sqrt(n) S.
double rounding(const Recording& recording, double size, double horizon) {
  return 64 * epsilon(recording.engine) * std::sqrt(std::max(1.0, horizon / recording.dt)) *
         (size > 0 ? size : 1);
}

// Of the runs at dt, dt/2, dt/4: value, bound C_p dt^p T + rounding, and the order itself, which must not
// fall 0.1 below p.
void measure_order_of_integrator(const Claim& claim, const Scene& scene,
                                 std::span<const Recording> recordings, double duration, const Reading& first,
                                 Measured& result) {
  const Recording& coarsest = recordings.front();
  const double span = horizon(claim, duration);
  const double floor = rounding(recordings.back(), first.largest, span);
  const bool adaptive = chose_its_steps(coarsest);
  const int declared = coarsest.terms.order;
  std::vector<double> steps, errors;
  for (const Recording& run : recordings) {
    steps.push_back(run.dt);
    errors.push_back(reduce(Reduction::max, &run == &coarsest ? first.series : deviation(claim, scene, run)));
  }
  const bool at_floor = *std::min_element(errors.begin(), errors.end()) <= floor;
  const bool meaningless = adaptive || at_floor;
  const double order = meaningless ? declared : observed_order(steps, errors);
  result.detail = adaptive   ? "order not measured: the integrator chooses its own steps"
                  : at_floor ? "order not measured: the error is at the rounding floor"
                             : fmt::format("observed order {:.2f}, declared {}", order, declared);
  if (claim.reduction == Reduction::order) {
    result.value = std::abs(order - declared);
    return;
  }
  const auto constant = constant_of(claim.tolerance, declared);
  if (!constant) {
    result.broken = true;
    result.detail += fmt::format("; the claim has no constant for order {} or less", declared);
    return;
  }
  const auto [p, c] = *constant;
  if (p != declared) result.detail += fmt::format(", held to order {}", p);
  result.allowed = c * std::pow(coarsest.dt, p) * span + floor;
  if (!meaningless && !(order >= p - 0.1)) result.broken = true;
}

// A test has a level and no quality: what is beyond its bound has failed.
void measure_chance(const Claim& claim, const Scene& scene, Measured& result) {
  const double chance = chance_of_share(claim.observable, scene, result.value);
  result.broken = !(result.value <= result.allowed);
  result.detail =
      fmt::format("expected {:.4g}; chance alone goes as far in {:.2g} of all runs, the level is {:g}",
                  expected_share(claim.observable, scene), chance, claim.tolerance.level);
}

// Of `at_least`, after a sample that is `apart` from the start.  NaN where a state is.
double still_missing(double before, double at_least, double apart) {
  if (std::isnan(apart)) return apart;
  return std::max(0.0, at_least - apart) < before ? std::max(0.0, at_least - apart) : before;
}

// How far each entry of an observable of one number has risen above its least value so far, or fallen below
// its greatest; the worst counts.  What lasts one step is neither: a step may end between a blow and its rebound.
class OneSided {
 public:
  OneSided(Reduction reduction, const Values& start) : sense_(reduction == Reduction::increase ? 1 : -1) {
    for (const auto& entry : start) least_.push_back(sense_ * entry.sum());
    before_ = least_;
  }
  double operator()(std::int64_t step, const Values& now) {
    const bool next = step - step_ <= 1;  // where steps are left out nobody knows how long a value lasted
    double most = 0;
    for (std::size_t i = 0; i < least_.size(); ++i) {
      const double x = sense_ * now[i].sum();  // one coordinate, and zeros
      most = worst(x - least_[i], most);
      least_[i] = std::min(least_[i], next ? std::max(before_[i], x) : x);
      before_[i] = x;
    }
    step_ = step;
    return most;
  }

 private:
  double sense_;
  std::int64_t step_ = 0;               // of the last sample
  std::vector<double> least_, before_;  // the least of what lasted, the last sample
};

}  // namespace

Series deviation(const Claim& claim, const Scene& scene, const Recording& recording) {
  require_truth(claim);
  if (of_last_step(claim.observable.quantity))
    return {{recording.time(recording.steps.size() - 1)}, {deviation_of_last_step(claim, scene, recording)}};
  Series series;
  const Chosen chosen(claim, recording.dt, recording.steps.empty() ? 0 : recording.steps.back());
  Values start, want, got;
  double missing = claim.at_least.value_or(0);
  if (of_chance(claim.observable.quantity))
    start = {{expected_share(claim.observable, scene), 0, 0, 0}};
  else if (!claim.truth)
    evaluate(claim.observable, scene, initial_state(scene), start);
  OneSided one_way(claim.reduction, start);
  AlongMotion truth(claim.observable, scene), motion(claim.observable, scene);
  for (std::size_t i = 0; i < recording.states.size(); ++i) {
    const bool looked_at = chosen(recording.steps[i]);
    if (!looked_at && !motion.counts()) continue;
    const double t = recording.time(i);
    motion.evaluate(t, recording.states[i], got);
    if (claim.truth) truth.evaluate(t, claim.truth->state(t), want);
    if (!looked_at) continue;
    series.time.push_back(t);
    const double apart = one_sided(claim.reduction)
                             ? one_way(recording.steps[i], got)
                             : distance(claim.observable, got, claim.truth ? want : start);
    if (claim.at_least) missing = still_missing(missing, *claim.at_least, apart);
    series.deviation.push_back(claim.at_least ? missing : apart);
  }
  return series;
}

std::optional<std::int64_t> first_bad_step(const Recording& recording) {
  for (std::size_t i = 0; i < recording.states.size(); ++i) {
    double zero = 0;  // 0 x is NaN where x is not finite
    for (const BodyState& s : recording.states[i])
      zero += (0 * s.position + 0 * s.velocity + 0 * s.angular_velocity).sum() +
              (0 * s.orientation.coeffs()).sum();
    if (std::isnan(zero)) return recording.steps[i];
  }
  return std::nullopt;
}

double observed_order(std::span<const double> dt, std::span<const double> error) {
  double sx = 0, sy = 0, sxx = 0, sxy = 0;
  const double n = static_cast<double>(dt.size());
  for (std::size_t i = 0; i < dt.size(); ++i) {
    const double x = std::log(dt[i]), y = std::log(error[i]);
    sx += x, sy += y, sxx += x * x, sxy += x * y;
  }
  return (n * sxy - sx * sy) / (n * sxx - sx * sx);
}

int runs_needed(const Claim& claim) {
  return claim.tolerance.order || claim.reduction == Reduction::order ? 3 : 1;
}

double allowed(const Claim& claim, const Scene& scene, double duration, double epsilon) {
  const Tolerance& tolerance = claim.tolerance;
  if (tolerance.level > 0) return allowed_share(claim.observable, scene, tolerance.level);
  double result = tolerance.absolute;
  if (tolerance.relative > 0) result += tolerance.relative * scale(claim, scene, duration);
  if (tolerance.roundings > 0) {
    const double size = tolerance.size > 0 ? tolerance.size : largest_value(claim, scene, duration);
    result += tolerance.roundings * epsilon * (size > 0 ? size : 1);
  }
  return result;
}

double widest(const Claim& claim, const Scene& scene, double duration) {
  const Tolerance& tolerance = claim.tolerance;
  const bool known = claim.truth || claim.motion || claim.at_least;
  if (!known || tolerance.order || claim.reduction == Reduction::order || tolerance.level > 0 ||
      validates(claim))
    return std::numeric_limits<double>::infinity();
  const double tenth = scale(claim, scene, duration) / 10;
  if (claim.reduction == Reduction::mean_square) return tenth * tenth;
  return claim.reduction == Reduction::rate ? tenth / std::min(claim.until, duration) : tenth;
}

Reading read(const Claim& claim, const Scene& scene, const Recording& recording, double duration) {
  require_truth(claim);
  Reading result;
  if (claim.observable.quantity != Quantity::event) result.series = deviation(claim, scene, recording);
  if (runs_needed(claim) > 1) result.largest = largest_value(claim, scene, duration);
  result.allowed = allowed(claim, scene, duration, epsilon(recording.engine));
  return result;
}

Measured measure(const Claim& claim, const Scene& scene, std::span<const Recording> recordings,
                 double duration, const Reading& first) {
  Measured result;
  result.allowed = first.allowed;
  if (claim.observable.quantity == Quantity::event) {
    measure_event(claim, scene, recordings.front(), result);
    return result;
  }
  if (of_last_step(claim.observable.quantity)) {
    auto what = untold_of_last_step(claim.observable, scene, recordings.front());
    if (!what) what = too_short_a_step(claim, scene, recordings.front(), first.allowed);
    if (what) {
      result.unanswered = true, result.detail = *what;
      result.value = std::numeric_limits<double>::quiet_NaN();
      return result;
    }
  }
  if (const auto what = untold_turns(claim, scene, recordings.front())) {
    result.unanswered = true, result.detail = *what;
    result.value = std::numeric_limits<double>::quiet_NaN();
    return result;
  }
  result.value = reduce(claim.reduction, first.series);
  if (claim.at_least)
    result.detail = fmt::format(
        "changed by {}{}, required {}", with_unit(*claim.at_least - result.value, unit(claim.observable)),
        result.value > 0 ? "" : " or more", with_unit(*claim.at_least, unit(claim.observable)));
  if (of_chance(claim.observable.quantity)) measure_chance(claim, scene, result);
  const int runs = runs_needed(claim);
  if (runs > 1 && std::isfinite(result.value))
    measure_order_of_integrator(claim, scene, recordings.first(static_cast<std::size_t>(runs)), duration,
                                first, result);
  return result;
}

}  // namespace cylon::core
