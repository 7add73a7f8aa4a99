// The number whose zero is an event, and what stands beside it, from a Scene and a State alone.
#pragma once

#include "harness/core/event_rows.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::core {

/// One kind of event of one pair or body.
class EventSignal {
 public:
  using Reading = EventReading;
  using Error = EventError;

  /// Requires undefined_in(q, scene) to be empty.
  EventSignal(const Observable& q, const Scene&, const Pair&);

  Reading operator()(const State& state, double t) const { return row_.signal(subject_, state, t); }
  Error error(const State& state, const StateError& e) const { return row_.error(subject_, state, e); }

 private:
  const EventRow& row_;
  EventSubject subject_;
};

/// The pairs or bodies that an event of the observable is counted for.
std::vector<Pair> event_subjects(const Observable&, const Scene&);

/// Why the scene has no such event, or nothing when it may have.
std::optional<std::string> event_undefined(const Observable&, const Scene&);

}  // namespace cylon::core
