#include "harness/core/event.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::core {
namespace {

struct Word {
  std::string_view name, unit;
};
constexpr std::array<Word, 8> words = {{{"time", "s"},
                                        {"height", "m"},
                                        {"speed", "m/s"},
                                        {"distance", "m"},
                                        {"angle", "rad"},
                                        {"period", "s"},
                                        {"rate", "rad/s"},
                                        {"order", ""}}};
static_assert(words.size() == static_cast<std::size_t>(EventQuantity::order) + 1);

}  // namespace

std::span<const EventType> event_types() {
  using enum EventQuantity;
  static const std::vector<EventType> types = {
      {EventKind::bounce, "bounce", "a pair touches and separates", true, 1, {time, speed, order}},
      {EventKind::apex, "apex", "the largest gap after a bounce", true, 0, {time, height}},
      {EventKind::roll, "roll", "a touching pair stops sliding", true, 1, {time}},
      {EventKind::flip,
       "flip",
       "the spin about the intermediate axis changes sign",
       false,
       1,
       {time, period}},
      {EventKind::swing, "swing", "a swing about a hinge ends", false, 1, {time, period}},
      {EventKind::apsis,
       "apsis",
       "the distance from `about`, or from `to`, turns",
       false,
       1,
       {time, distance, period}},
      {EventKind::turn, "turn", "the height turns", false, 1, {time, height, period}},
      {EventKind::nutation,
       "nutation",
       "the axis' angle from its pole turns",
       false,
       1,
       {time, angle, period, rate}},
      {EventKind::precession,
       "precession",
       "the axis has gone round its pole once more",
       false,
       1,
       {time, angle, rate}},
      {EventKind::crossing, "crossing", "the centre crosses the water's surface", false, 1, {time}}};
  return types;
}

const EventType& event_type(EventKind kind) { return event_types()[static_cast<std::size_t>(kind)]; }

std::string_view name(EventKind kind) { return event_type(kind).name; }

std::string_view name(EventQuantity which) { return words[static_cast<std::size_t>(which)].name; }

std::string_view unit(EventQuantity which) { return words[static_cast<std::size_t>(which)].unit; }

bool over_periods(EventKind kind, EventQuantity which) {
  return which == EventQuantity::period || (which == EventQuantity::rate && kind == EventKind::nutation);
}

std::optional<double> quantity(std::span<const Event> all, const Event& event, EventQuantity which) {
  const auto known = [](double x) { return std::isnan(x) ? std::nullopt : std::optional(x); };
  double since = 0, azimuth = 0;  // of the event from which a mean is taken
  if (over_periods(event.kind, which)) {
    const auto first = std::find_if(all.begin(), all.end(), [&](const Event& e) {
      return e.kind == event.kind && e.pair == event.pair && e.index == 1;
    });
    if (first == all.end() || event.index < 3) return std::nullopt;
    since = first->time, azimuth = first->azimuth;
  }
  switch (which) {
    case EventQuantity::time:
      return known(event.time);
    case EventQuantity::height:
      return known(event.height);
    case EventQuantity::speed:
      return known(event.speed);
    case EventQuantity::distance:
      return known(event.distance);
    case EventQuantity::angle:
      return known(event.angle);
    case EventQuantity::period:
      return known(2 * (event.time - since) / (event.index - 1));
    case EventQuantity::rate:
      return known((event.azimuth - azimuth) / (event.time - since));
    case EventQuantity::order:
      break;
  }
  return std::nullopt;
}

}  // namespace cylon::core
