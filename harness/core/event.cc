#include "harness/core/event.h"

#include "harness/core/event_rows.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::core {
namespace {

template <double Event::*which>
double own(const Event& event, const Event&) {
  return event.*which;
}

// 2 (t_k - t_1)/(k - 1)
double mean_period(const Event& event, const Event& first) {
  return 2 * (event.time - first.time) / (event.index - 1);
}

// (azimuth_k - azimuth_1)/(t_k - t_1)
double mean_rate(const Event& event, const Event& first) {
  return (event.azimuth - first.azimuth) / (event.time - first.time);
}

// First order: a turning point's height and distance do not feel the error of its time.
template <double StateError::*which>
double error_of_state(const Observable&, const Truth& truth) {
  return truth.error.*which;
}

double distance_error(const Observable& q, const Truth& truth) {
  return q.to ? 2 * truth.error.position : truth.error.position;
}

double period_error(const Observable& q, const Truth& truth) { return 4 * truth.error.time / (q.index - 1); }

// (2 dtheta/lever + 2 |rate| dt)/(t_k - t_1), with the axis' lever about its pole sin(angle), the least of
// all.
double rate_error(const Observable& q, const Truth& truth) {
  const StateError& e = truth.error;
  double bound = 0, since = 0, lever = 1;
  for (const Event& event : truth.events) {
    if (event.kind != q.event) continue;
    lever = std::min(lever, std::sin(event.angle));
    if (event.index == 1 && event_row(q.event).rate_over_periods) since = event.time;
    const auto rate = quantity(truth.events, event, q.event_quantity);
    if (event.index == q.index && rate)
      bound =
          std::max(bound, (2 * e.orientation / lever + 2 * std::abs(*rate) * e.time) / (event.time - since));
  }
  return bound;
}

double no_error(const Observable&, const Truth&) { return 0; }

double not_a_number(const Event&, const Event&) { return std::nan(""); }

constexpr std::array rows = {
    EventQuantityRow{EventQuantity::time, "time", "s", own<&Event::time>, error_of_state<&StateError::time>},
    EventQuantityRow{EventQuantity::height, "height", "m", own<&Event::height>,
                     error_of_state<&StateError::position>},
    EventQuantityRow{EventQuantity::speed, "speed", "m/s", own<&Event::speed>,
                     error_of_state<&StateError::velocity>},
    EventQuantityRow{EventQuantity::distance, "distance", "m", own<&Event::distance>, distance_error},
    EventQuantityRow{EventQuantity::angle, "angle", "rad", own<&Event::angle>,
                     error_of_state<&StateError::orientation>},
    EventQuantityRow{EventQuantity::period, "period", "s", mean_period, period_error},
    EventQuantityRow{EventQuantity::rate, "rate", "rad/s", mean_rate, rate_error},
    EventQuantityRow{EventQuantity::order, "order", "", not_a_number, no_error},
    EventQuantityRow{EventQuantity::count, "count", "", not_a_number, no_error},
};
static_assert([] {
  for (std::size_t i = 0; i < rows.size(); ++i)
    if (static_cast<std::size_t>(rows[i].quantity) != i) return false;
  return rows.back().quantity == EventQuantity::count;
}());

}  // namespace

const EventQuantityRow& event_row(EventQuantity which) { return rows[static_cast<std::size_t>(which)]; }

const EventType& event_type(EventKind kind) { return event_row(kind).type; }

std::string_view name(EventKind kind) { return event_type(kind).name; }

std::string_view name(EventQuantity which) { return event_row(which).name; }

std::string_view unit(EventQuantity which) { return event_row(which).unit; }

bool over_periods(EventKind kind, EventQuantity which) {
  return which == EventQuantity::period ||
         (which == EventQuantity::rate && event_row(kind).rate_over_periods);
}

std::optional<double> quantity(std::span<const Event> all, const Event& event, EventQuantity which) {
  Event since;  // the event from which a mean is taken
  if (over_periods(event.kind, which)) {
    const auto first = std::find_if(all.begin(), all.end(), [&](const Event& e) {
      return e.kind == event.kind && e.pair == event.pair && e.index == 1;
    });
    if (first == all.end() || event.index < 3) return std::nullopt;
    since = *first;
  }
  const double x = event_row(which).value(event, since);
  return std::isnan(x) ? std::nullopt : std::optional(x);
}

}  // namespace cylon::core
