// The number whose zero is an event, and what stands beside it, from a Scene and a State alone.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::core {

/// One kind of event of one pair or body.
class EventSignal {
 public:
  struct Reading {
    /// Changes sign at the event; precession: nothing; roll: the slip speed, NaN while apart.
    double x = 0;
    double value = 0;    ///< Height, distance or angle of the kind.
    double azimuth = 0;  ///< Of the axis about its pole, in (-pi, pi].
  };

  /// Requires undefined_in(q, scene) to be empty.
  EventSignal(const Observable& q, const Scene&, const Pair&);

  Reading operator()(const State&, double t) const;

  /// First-order bounds on the errors of x and of the azimuth that an error of the state makes.
  struct Error {
    double x = 0, azimuth = 0;
  };
  Error error(const State&, const StateError&) const;

 private:
  double arm(const State&) const;  // from the centre to the contact
  double slip(const State&) const;

  const Scene& scene_;
  EventKind kind_;
  Pair pair_;
  std::size_t body_;
  Vector3 about_, up_, pole_, first_, second_;  // the pole and two unit vectors across it, right-handed
  Vector3 axis_;                                // of the body, or its intermediate one, in the body frame
  int hinged_to_ = world;
  const Water* water_ = nullptr;
};

/// The pairs or bodies that an event of the observable is counted for.
std::vector<Pair> event_subjects(const Observable&, const Scene&);

/// Why the scene has no such event, or nothing when it may have.
std::optional<std::string> event_undefined(const Observable&, const Scene&);

}  // namespace cylon::core
