#include "harness/core/event_find.h"

#include "harness/core/event_signal.h"
#include "harness/core/event_watch.h"
#include "harness/core/worst.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <numbers>

namespace cylon::core {
namespace {

using Reading = EventReading;
constexpr double whole_turn = 2 * std::numbers::pi;
constexpr double rest = 1e-6;                   // of the largest signal: less is noise about zero
constexpr double sliding = 1e-2, stuck = 1e-3;  // of the largest slip speed

// Readings at even times, azimuths unwrapped and counted from the first.
using Series = std::vector<Reading>;

void append(Series& series, double start, Reading reading) {
  const double last = series.empty() ? 0 : series.back().azimuth;
  reading.azimuth = last + std::remainder(reading.azimuth - start - last, whole_turn);
  series.push_back(reading);
}

double largest(const Series& series) {
  double size = 0;
  for (const Reading& r : series)
    if (!std::isnan(r.x)) size = std::max(size, std::abs(r.x));
  return size;
}

// Indices of the samples before each event.
std::vector<std::size_t> sign_changes(const Series& series, double threshold) {
  std::vector<std::size_t> found;
  double side = 0;  // the sign that was certain last
  for (std::size_t n = 0; n < series.size(); ++n) {
    const double x = series[n].x;
    if (std::isnan(x) || std::abs(x) < threshold || x == 0) continue;
    if (side * x < 0) {
      std::size_t before = n - 1;
      while (side * series[before].x < 0) --before;
      found.push_back(before);
    }
    side = x;
  }
  return found;
}

std::vector<std::size_t> whole_turns(const Series& series) {
  std::vector<std::size_t> found;
  for (std::size_t n = 1; n < series.size(); ++n)
    if (std::abs(series[n].azimuth) >= whole_turn * static_cast<double>(found.size() + 1))
      found.push_back(n - 1);
  return found;
}

std::vector<std::size_t> ends_of_slip(const Series& series) {
  std::vector<std::size_t> found;
  const double size = largest(series);
  bool slides = false;
  for (std::size_t n = 0; n < series.size(); ++n) {
    const double x = series[n].x;
    if (std::isnan(x)) slides = false;
    if (x > sliding * size) slides = true;
    if (!slides || !(x <= stuck * size)) continue;
    found.push_back(n - 1);
    slides = false;
  }
  return found;
}

// Signals below `noise` have no sign.
std::vector<std::size_t> brackets(EventSearch search, const Series& series, double noise) {
  switch (search) {
    case EventSearch::end_of_slip:
      return ends_of_slip(series);
    case EventSearch::whole_turn:
      return whole_turns(series);
    case EventSearch::sign_change:
      return sign_changes(series, std::max(rest * largest(series), noise));
    case EventSearch::watch:
      break;
  }
  return {};
}

// The polynomial through up to four readings, s counted in steps from sample `before`.
class Arc {
 public:
  Arc(const Series& series, std::size_t before, bool behind) {
    const auto count = std::min<std::size_t>(4, series.size());
    const std::size_t back = behind ? count - 1 : 1;
    const std::size_t first = std::min(before - std::min(before, back), series.size() - count);
    for (std::size_t i = 0; i < count; ++i) {
      node_.push_back(static_cast<double>(first + i) - static_cast<double>(before));
      reading_.push_back(series[first + i]);
    }
  }
  double at(double s, double Reading::*what) const {  // Lagrange
    double sum = 0;
    for (std::size_t i = 0; i < node_.size(); ++i) {
      double weight = 1;
      for (std::size_t j = 0; j < node_.size(); ++j)
        if (j != i) weight *= (s - node_[j]) / (node_[i] - node_[j]);
      sum += weight * (reading_[i].*what);
    }
    return sum;
  }

 private:
  std::vector<double> node_;
  std::vector<Reading> reading_;
};

// Where f has its root in [a, b]; b where it has the same sign at both.
double bisect(const std::function<double(double)>& f, double a, double b) {
  const bool negative = f(a) < 0;
  if (f(a) == 0) return a;
  for (;;) {
    const double middle = a + (b - a) / 2;
    if (middle <= a || middle >= b) return b;
    ((f(middle) < 0) == negative && f(middle) != 0 ? a : b) = middle;
  }
}

// Steps from sample `before` until the slip speed is zero: x + u s + a s^2/2 through the last three samples;
// the step after where the arc has no zero within ten steps.
double slip_root(const Series& series, std::size_t before) {
  const double x = series[before].x;
  if (before == 0 || std::isnan(series[before - 1].x)) return 1;
  double u = x - series[before - 1].x, a = 0;
  if (before >= 2 && !std::isnan(series[before - 2].x)) {
    a = x - 2 * series[before - 1].x + series[before - 2].x;
    u += a / 2;
  }
  const double discriminant = u * u - 2 * a * x;
  if (u >= 0 || discriminant < 0) return 1;
  const double root = 2 * x / (-u + std::sqrt(discriminant));
  return root <= 10 ? root : 1;
}

Event event_of(const EventRow& row, const Pair& pair, int index, double time, double value, double azimuth) {
  Event event{.kind = row.type.kind, .pair = pair, .index = index, .time = time};
  if (row.value) event.*row.value = value;
  event.azimuth = azimuth;
  return event;
}

double whole_turns_at(const Series& series, std::size_t before, std::size_t count) {
  return std::copysign(whole_turn * static_cast<double>(count), series[before + 1].azimuth);
}

void sort_by_time(std::vector<Event>& events) {
  std::stable_sort(events.begin(), events.end(),
                   [](const Event& a, const Event& b) { return a.time < b.time; });
}

std::vector<Event> find_on_arcs(const EventRow& row, const Pair& pair, const Series& series, double dt) {
  std::vector<Event> events;
  for (const std::size_t before : brackets(row.search, series, 0)) {
    const int index = static_cast<int>(events.size()) + 1;
    const Arc arc(series, before, row.force_jumps);
    const double start = static_cast<double>(before);
    if (row.search == EventSearch::end_of_slip) {
      events.push_back(event_of(row, pair, index, (start + slip_root(series, before)) * dt, 0, 0));
      continue;
    }
    const bool turns = row.search == EventSearch::whole_turn;
    const double goal = turns ? whole_turns_at(series, before, events.size() + 1) : 0;
    double Reading::*const what = turns ? &Reading::azimuth : &Reading::x;
    const double s = bisect([&](double x) { return arc.at(x, what) - goal; }, 0, 1);
    events.push_back(event_of(row, pair, index, (start + s) * dt, arc.at(s, &Reading::value),
                              turns ? goal : arc.at(s, &Reading::azimuth)));
  }
  return events;
}

// ---- Truths --------------------------------------------------------------------------------------

// What a truth shows at even times, for each pair; its states are asked for once for all.
struct Sampled {
  double dt = 0;
  std::vector<Series> series;  // by pair
};

Sampled sample(const std::vector<EventSignal>& signals, const Truth& truth, double horizon,
               std::size_t count) {
  Sampled result{horizon / static_cast<double>(count), std::vector<Series>(signals.size())};
  std::vector<double> start(signals.size());
  for (std::size_t n = 0; n <= count; ++n) {
    const double t = n == count ? horizon : static_cast<double>(n) * result.dt;
    const State state = truth.state(t);
    for (std::size_t i = 0; i < signals.size(); ++i) {
      const Reading reading = signals[i](state, t);
      if (n == 0) start[i] = reading.azimuth;
      append(result.series[i], start[i], reading);
    }
  }
  return result;
}

// Signals below what the truth's own error makes of them have no sign.
double noise_of(const EventSignal& signal, const Truth& truth) {
  return 10 * signal.error(truth.state(0), truth.error).x;
}

// Whether both have the same events, but for one at the end.
bool same_events(const EventRow& row, const std::vector<EventSignal>& signals, const Truth& truth,
                 const Sampled& a, const Sampled& b) {
  for (std::size_t i = 0; i < signals.size(); ++i) {
    const double noise = noise_of(signals[i], truth);
    const std::vector<std::size_t> in_a = brackets(row.search, a.series[i], noise),
                                   in_b = brackets(row.search, b.series[i], noise);
    const std::size_t common = std::min(in_a.size(), in_b.size());
    if (std::max(in_a.size(), in_b.size()) > common + 1) return false;
    for (std::size_t k = 0; k < common; ++k)
      if (std::abs(static_cast<double>(in_a[k]) * a.dt - static_cast<double>(in_b[k]) * b.dt) > a.dt + b.dt)
        return false;
  }
  return true;
}

// At so many times that events do not hide between them: others, the golden ratio more, show the same.
Sampled sample_enough(const EventRow& row, const std::vector<EventSignal>& signals, const Truth& truth,
                      double horizon, double step) {
  constexpr double most = 0x1p20;
  double count = std::clamp(std::ceil(horizon / step), 64.0, 2048.0);
  while (count <= most) {
    Sampled few = sample(signals, truth, horizon, static_cast<std::size_t>(count));
    count = std::round(std::numbers::phi * count);
    if (same_events(row, signals, truth, few,
                    sample(signals, truth, horizon, static_cast<std::size_t>(count))))
      return few;
    count *= 4;
  }
  throw OutOfDomain("its events follow each other too fast to be told apart; end the claim sooner");
}

struct Located {
  std::vector<Event> events;
  double error = 0;  ///< Of their times [s].
};

Located locate(const EventRow& row, const EventSignal& signal, const Truth& truth, const Pair& pair,
               double horizon, const Series& series, double dt) {
  const auto read = [&](double t) { return signal(truth.state(t), t); };
  const double start = read(0).azimuth;

  Located located;
  const double still = 1e-9 * largest(series);
  for (const std::size_t before : brackets(row.search, series, noise_of(signal, truth))) {
    const double a = static_cast<double>(before) * dt, b = std::min(a + dt, horizon);
    const bool turns = row.search == EventSearch::whole_turn;
    const double goal = turns ? whole_turns_at(series, before, located.events.size() + 1) : 0;
    const auto unwrapped = [&](double t) {
      const double near = series[before].azimuth;
      return near + std::remainder(read(t).azimuth - start - near, whole_turn);
    };
    const bool slides = row.search == EventSearch::end_of_slip;
    const std::function<double(double)> zero = [&](double t) {
      if (turns) return unwrapped(t) - goal;
      return slides ? read(t).x - still : read(t).x;
    };
    const double t = bisect(zero, a, b);
    located.events.push_back(event_of(row, pair, static_cast<int>(located.events.size()) + 1, t,
                                      read(t).value, turns ? goal : unwrapped(t)));
    // |dt| <= |dx| / |slope|, the slope from before the event, where nothing has jumped yet.
    const State state = truth.state(t);
    const EventError error = signal.error(state, truth.error);
    const double earlier = std::max(0.0, t - dt / 8);
    const double slope = std::abs(zero(t) - zero(earlier)) / (t - earlier);
    const double ulp = 4 * (std::nextafter(t, HUGE_VAL) - t);
    const double size = (turns ? error.azimuth : error.x) + (slides ? still : 0);
    located.error = worst(size / slope + ulp, located.error);
  }
  return located;
}

std::vector<Event> watch(const Observable& q, const Scene& scene, const Truth& truth, double horizon,
                         std::int64_t steps) {
  const double dt = horizon / static_cast<double>(steps);
  EventWatch watch(scene, event_subjects(q, scene), dt);
  for (std::int64_t n = 0; n <= steps; ++n)
    watch.observe(n, truth.state(n == steps ? horizon : static_cast<double>(n) * dt));
  return watch.take();
}

}  // namespace

bool watched(EventKind kind) { return event_row(kind).search == EventSearch::watch; }

std::vector<Event> find_events(const Observable& q, const Scene& scene, const Recording& recording) {
  if (watched(q.event)) return recording.events;
  std::vector<Event> events;
  if (recording.states.empty()) return events;
  for (const Pair& pair : event_subjects(q, scene)) {
    const EventSignal signal(q, scene, pair);
    Series series;
    const double start = signal(recording.states[0], 0).azimuth;
    for (std::size_t i = 0; i < recording.states.size(); ++i)
      append(series, start, signal(recording.states[i], recording.time(i)));
    const auto found = find_on_arcs(event_row(q.event), pair, series, recording.dt);
    events.insert(events.end(), found.begin(), found.end());
  }
  sort_by_time(events);
  return events;
}

Truth with_events(const Observable& q, const Scene& scene, const Truth& truth, double horizon, double step) {
  const auto stated = [&](const Event& event) { return event.kind == q.event; };
  if (!truth.times.empty() || std::any_of(truth.events.begin(), truth.events.end(), stated)) return truth;
  Truth result = truth;
  if (watched(q.event)) {
    const auto steps = static_cast<std::int64_t>(std::clamp(std::ceil(horizon / step), 64.0, 1e6));
    const std::vector<Event> coarse = watch(q, scene, truth, horizon, steps);
    result.events = watch(q, scene, truth, horizon, 2 * steps);
    for (std::size_t i = 0; i < std::min(coarse.size(), result.events.size()); ++i)
      result.error.time = worst(std::abs(coarse[i].time - result.events[i].time), result.error.time);
    if (coarse.size() != result.events.size()) result.error.time = horizon;  // nothing is certain
    return result;
  }
  result.events.clear();
  const std::vector<Pair> pairs = event_subjects(q, scene);
  std::vector<EventSignal> signals;
  for (const Pair& pair : pairs) signals.emplace_back(q, scene, pair);
  const EventRow& row = event_row(q.event);
  const Sampled sampled = sample_enough(row, signals, truth, horizon, step);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const Located located = locate(row, signals[i], truth, pairs[i], horizon, sampled.series[i], sampled.dt);
    result.events.insert(result.events.end(), located.events.begin(), located.events.end());
    result.error.time = worst(located.error, result.error.time);
  }
  sort_by_time(result.events);
  return result;
}

}  // namespace cylon::core
