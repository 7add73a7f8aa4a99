// What happens between samples: contacts, turning points, turns of an axis, crossings of a surface.
// Each kind is defined by the states alone; no engine is asked.
#pragma once

#include "harness/core/scene.h"

#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace cylon::core {

// Up of a body: against its gravity, or +y where it has none.  Pole of a body: up where gravity acts on it, else the
// body's angular momentum about its centre at t = 0.  Axis: the body's symmetry axis (symmetry_axis).
enum class EventKind {
  bounce,      ///< A pair approaches, touches and separates.
  apex,        ///< The largest gap of a pair after a bounce.  Index 0: before any bounce.
  roll,        ///< A touching pair that slid stops sliding: the contact point's slip speed reaches zero.
  flip,        ///< w on the body's intermediate principal axis changes sign.
  swing,       ///< On a joint that leaves one rotation, w along its axis changes sign: a swing ends.
  apsis,       ///< The distance of the centre from `about`, or from `to`'s centre, turns: d . d' = 0.
  turn,        ///< The centre's height turns: up . v = 0.
  nutation,    ///< The angle between axis and pole turns: pole . (w x axis) = 0.
  precession,  ///< The axis has gone round its pole once more since t = 0, the same way in all.
  crossing     ///< The centre crosses the surface of the water, either way.
};

enum class EventQuantity {
  time,      ///< [s]
  height,    ///< Apex: the gap; turn: up . x [m].
  speed,     ///< Bounce: d(gap)/dt just after [m/s].
  distance,  ///< Apsis [m].
  angle,     ///< Nutation, precession: between axis and pole [rad].
  period,    ///< 2 (t_k - t_1)/(k - 1), k = 3, 5, …: the mean over whole periods of two turns or flips [s].
  rate,  ///< Of the azimuth about the pole: precession: since t = 0; nutation: from event 1 to k = 3, 5, …,
         ///< over whole periods.  Right-handed about the pole is positive [rad/s].
  order,  ///< Bounces: how many of the sequence of pairs are not at their place [1].
  count   ///< How many there are [1].
};

/// Whether the number is of all events of a kind, and not of one of them.
constexpr bool of_all(EventQuantity which) {
  return which == EventQuantity::order || which == EventQuantity::count;
}

struct Event {
  EventKind kind = EventKind::bounce;
  Pair pair;      ///< Or, for kinds of one body: that body alone; apsis: `to` as the other.
  int index = 1;  ///< Counted per pair and kind; an apex has the index of the bounce before it.
  double time = 0, speed = 0, height = 0;  ///< As the quantities; NaN: not known.
  double distance = 0, angle = 0;
  double azimuth =
      0;  ///< Nutation, precession: turned about the pole since t = 0, whole turns counted [rad].
};

/// A row of the table of kinds.
struct EventType {
  EventKind kind;
  std::string_view name, meaning;
  bool of_pairs;                          ///< Of touching pairs; else of bodies.
  int first_index;                        ///< 1, or 0 for an apex.
  std::vector<EventQuantity> quantities;  ///< Those it has.
};
std::span<const EventType> event_types();  ///< In the order of EventKind.
const EventType& event_type(EventKind);

std::string_view name(EventKind);
std::string_view name(EventQuantity);
std::string_view unit(EventQuantity);

/// Whether the quantity is a mean over whole periods, which an index of 3, 5, … ends.
bool over_periods(EventKind, EventQuantity);

/// A number of `event`, which stands in `all`; nothing where it is not known.  Not for what is of_all.
std::optional<double> quantity(std::span<const Event> all, const Event& event, EventQuantity);

}  // namespace cylon::core
