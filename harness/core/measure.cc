#include "harness/core/measure.h"

#include "harness/core/worst.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

namespace cylon::core {
namespace {

double horizon(const Claim& claim, double duration) { return std::min(claim.until, duration); }

// Whether the claim looks at the sample after `step` steps.
class Chosen {
 public:
  Chosen(const Claim& claim, double dt, std::int64_t last)
      : last_(last), until_(claim.until / dt * (1 + 1e-12)) {
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

double quantity(const Event& event, EventQuantity which) {
  switch (which) {
    case EventQuantity::time:
      return event.time;
    case EventQuantity::height:
      return event.height;
    case EventQuantity::speed:
      return event.speed;
  }
  return 0;
}

bool asked_for(const Observable& q, const Event& event) {
  return event.kind == q.event && event.index == q.index &&
         (!q.body || *q.body == event.pair.body || *q.body == event.pair.other);
}

void measure_event(const Claim& claim, const Recording& recording, Measured& result) {
  const Observable& q = claim.observable;
  for (const Event& want : claim.truth->events) {
    if (!asked_for(q, want) || want.time > claim.until) continue;
    const auto got = std::find_if(recording.events.begin(), recording.events.end(), [&](const Event& event) {
      return event.kind == want.kind && event.index == want.index && event.pair == want.pair;
    });
    if (got == recording.events.end()) {
      result.broken = true;
      result.detail = fmt::format("the {} number {} never came",
                                  q.event == EventKind::bounce ? "bounce" : "apex", q.index);
      result.value = std::abs(quantity(want, q.event_quantity));  // all of it is missing
      return;
    }
    result.value =
        worst(std::abs(quantity(*got, q.event_quantity) - quantity(want, q.event_quantity)), result.value);
  }
}

}  // namespace

Series deviation(const Claim& claim, const Scene& scene, const Recording& recording) {
  Series series;
  const Chosen chosen(claim, recording.dt, recording.steps.empty() ? 0 : recording.steps.back());
  Values start, want, got;
  if (!claim.truth) evaluate(claim.observable, scene, initial_state(scene), start);
  for (std::size_t i = 0; i < recording.states.size(); ++i) {
    if (!chosen(recording.steps[i])) continue;
    const double t = recording.time(i);
    if (claim.truth) evaluate(claim.observable, scene, claim.truth->state(t), want);
    evaluate(claim.observable, scene, recording.states[i], got);
    series.time.push_back(t);
    series.deviation.push_back(distance(claim.observable, got, claim.truth ? want : start));
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

double scale(const Claim& claim, const Scene& scene, double duration) {
  const Observable& q = claim.observable;
  if (q.quantity == Quantity::event) {
    double size = 0;
    if (claim.truth)
      for (const Event& event : claim.truth->events)
        if (asked_for(q, event)) size = worst(std::abs(quantity(event, q.event_quantity)), size);
    return size;
  }
  Values values;
  if (!claim.truth) {
    if (q.quantity == Quantity::energy) return energy_scale(scene, initial_state(scene));
    evaluate(q, scene, initial_state(scene), values);
    return magnitude(q, values);
  }
  const auto size_at = [&](double t) {
    const State state = claim.truth->state(t);
    if (q.quantity == Quantity::energy) return energy_scale(scene, state);
    evaluate(q, scene, state, values);
    return magnitude(q, values);
  };
  double size = 0;
  if (!claim.truth->times.empty()) {
    for (const double t : claim.truth->times) size = worst(size_at(t), size);
    return size;
  }
  constexpr int samples = 256;
  for (int i = 0; i <= samples; ++i) size = worst(size_at(horizon(claim, duration) * i / samples), size);
  return size;
}

int runs_needed(const Claim& claim) {
  return claim.tolerance.order || claim.reduction == Reduction::order ? 3 : 1;
}

Measured measure(const Claim& claim, const Scene& scene, std::span<const Recording> recordings,
                 double duration) {
  const Recording& recording = recordings.front();
  const Tolerance& tolerance = claim.tolerance;
  Measured result;
  result.allowed = tolerance.absolute;
  if (tolerance.relative > 0) result.allowed += tolerance.relative * scale(claim, scene, duration);

  if (claim.observable.quantity == Quantity::event) {
    measure_event(claim, recording, result);
    return result;
  }
  result.value = reduce(claim.reduction, deviation(claim, scene, recording));
  if (runs_needed(claim) == 1 || !std::isfinite(result.value)) return result;

  // C dt^p T, and the order itself: the slope over dt, dt/2, dt/4 must not fall 0.1 below p.
  const int declared = recording.terms.order;
  std::vector<double> steps, errors;
  for (const Recording& run : recordings.first(static_cast<std::size_t>(runs_needed(claim)))) {
    steps.push_back(run.dt);
    errors.push_back(reduce(Reduction::max, deviation(claim, scene, run)));
  }
  const double floor = 1e-12 * std::max(1.0, scale(claim, scene, duration));
  const bool rounding = *std::min_element(errors.begin(), errors.end()) < floor;
  const double order = rounding ? declared : observed_order(steps, errors);
  result.detail = rounding ? "order not measured: the error is at the rounding floor"
                           : fmt::format("observed order {:.2f}, declared {}", order, declared);
  if (claim.reduction == Reduction::order) {
    result.value = std::abs(order - declared);
    return result;
  }
  result.allowed = tolerance.constant * std::pow(recording.dt, declared) * horizon(claim, duration);
  if (!(order >= declared - 0.1)) result.broken = true;
  return result;
}

}  // namespace cylon::core
