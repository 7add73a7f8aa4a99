// Finds bounces and apexes in a sequence of states, by the same code for every engine.
#pragma once

#include "harness/core/event.h"
#include "harness/core/scene.h"

#include <cstdint>
#include <vector>

namespace cylon::core {

/// Watches the gap g of some pairs, step by step.
///
/// A bounce is a change of the gap's rate u = dg/dt from approach (u < 0) to separation (u > 0) that
/// free flight cannot make, while the gap is within ten steps' way at the rate of approach: what a third body
/// does to one of them from afar is no bounce of theirs.  The arc on either side, g + u s + a s^2/2 with a
/// from the two states on that side, is followed to its root g = 0; the event time is the mean of the two
/// roots (equal for an exact engine), and its speed is the outgoing arc's rate there.  An apex is the vertex
/// of the arc where u turns from + to - in free flight.
class EventWatch {
 public:
  EventWatch(const Scene&, std::vector<Pair>, double dt);

  /// The state after `step` steps; every step from 0 in order.
  void observe(std::int64_t step, const State&);

  /// What was found so far, in order of time, and forgets it.
  std::vector<Event> take();

 private:
  struct Sample {
    double gap = 0, rate = 0;
  };
  struct Track {
    Pair pair;
    Sample last[4];  ///< Newest last.
    int kept = 0;    ///< How many of them are there.
    int bounces = 0;
    int since_bounce = 2;  ///< Steps since the last bounce was found.
    bool rising = false;   ///< Has separated, and its apex is still to come.
    double fastest = 0;    ///< Largest |rate| so far [m/s].
  };
  void detect(Track&, std::int64_t step);

  const Scene& scene_;
  double dt_;
  std::vector<Track> tracks_;
  std::vector<Event> found_;
};

}  // namespace cylon::core
