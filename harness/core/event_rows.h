// The tables of events: one row for each EventKind, one for each EventQuantity.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/truth.h"

#include <optional>
#include <string>

namespace cylon::core {

/// One pair or body of a scene, with what the signals of its events refer to.
struct EventSubject {
  const Scene& scene;
  Pair pair;
  std::size_t body;                 ///< pair.body
  Vector3 about, up, pole;          ///< See event.h; `about` as in Observable.
  Vector3 first, second;            ///< Two unit vectors across the pole, right-handed.
  Vector3 axis = Vector3::UnitY();  ///< In the body frame: the kind says which.
  int turns_against = world;        ///< Of kind swing: the other body of the joint.
  const Water* water = nullptr;
};

/// The number whose zero is an event, and what stands beside it.
struct EventReading {
  double x = 0;        ///< Changes sign at the event; roll: the slip speed, NaN while apart.
  double value = 0;    ///< Height, distance or angle of the kind.
  double azimuth = 0;  ///< Of the axis about its pole, in (-pi, pi].
};

/// First-order bounds on the errors of a reading that an error of the state makes.
struct EventError {
  double x = 0, azimuth = 0;
};

/// How the events of a kind are found.
enum class EventSearch {
  watch,        ///< By EventWatch, while the run goes on.
  sign_change,  ///< Where x changes sign.
  whole_turn,   ///< Where the azimuth has gone round once more.
  end_of_slip   ///< Where x falls to zero and stays there.
};

/// A new kind is its functions, its row in event_kinds.cc and its enumerator.
struct EventRow {
  EventType type;
  EventSearch search = EventSearch::sign_change;
  bool force_jumps = false;        ///< At the event, so that the arc is taken from the samples before it.
  bool of_two_bodies = false;      ///< `to` may name the other.
  bool rate_over_periods = false;  ///< The mean rate is taken from event 1, else from t = 0.
  double Event::*value = nullptr;  ///< Where a reading's value is kept; null: nowhere.
  void (*prepare)(EventSubject&) = nullptr;  ///< Finds the subject's axis; null: the kind has none.
  EventReading (*signal)(const EventSubject&, const State&, double t) = nullptr;
  EventError (*error)(const EventSubject&, const State&, const StateError&) = nullptr;
  std::optional<std::string> (*undefined)(const Scene&, const Pair&) = nullptr;  ///< Null: always defined.
};
const EventRow& event_row(EventKind);

/// A new number of an event is its functions, its row in event.cc and its enumerator.
struct EventQuantityRow {
  EventQuantity quantity;
  std::string_view name, unit;
  /// `first`: the event from which a mean is taken, or one at t = 0 with azimuth 0.  NaN: not known.
  double (*value)(const Event&, const Event& first);
  double (*error)(const Observable&, const Truth&);  ///< First-order bound.
};
const EventQuantityRow& event_row(EventQuantity);

/// Towards the sky of a body: against its gravity, or +y where it has none.
Vector3 event_up(const Scene&, const Body&);

/// See event.h; zero where the body has none.
Vector3 event_pole(const Scene&, const Body&);

/// The scene's water; null where there is none.
const Water* event_water(const Scene&);

}  // namespace cylon::core
