// What happens between samples: contacts and the turning points after them.
#pragma once

#include "harness/core/scene.h"

#include <string>
#include <vector>

namespace cylon::core {

enum class EventKind {
  bounce,  ///< A pair approaches, touches and separates; time and separation speed.
  apex     ///< The largest gap after a bounce; time and height of the gap.  Index 0: before any bounce.
};

struct Event {
  EventKind kind = EventKind::bounce;
  Pair pair;
  int index = 1;      ///< Counted per pair and kind; an apex has the index of the bounce before it.
  double time = 0;    ///< [s]
  double speed = 0;   ///< Bounce: d(gap)/dt just after [m/s].
  double height = 0;  ///< Apex: the gap [m].
};

}  // namespace cylon::core
