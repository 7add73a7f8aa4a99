// Coulomb friction along one line: when slip ends, and what follows.
#pragma once

#include "reference/exact/wide.h"

#include <vector>

namespace cylon::exact {

/// From `start` [s] on, slip u obeys u' = rate, and points along `sign` of the line (0: none, it sticks).
struct SlipPhase {
  Wide start = 0, slip = 0, rate = 0;
  int sign = 0;
};

/// u' = pull - drag u/|u| while u != 0; at u = 0 it sticks if |pull| <= drag, else it slips along the pull.
/// One phase, or two if the slip comes to an end.  pull, drag >= 0: accelerations of the slip [m/s^2].
inline std::vector<SlipPhase> slip_phases(Wide slip, Wide pull, Wide drag, Wide start) {
  const auto sign = [](Wide x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
  const auto from_rest = [&](Wide t) -> SlipPhase {
    if (std::abs(pull) <= drag) return {t, 0, 0, 0};
    return {t, 0, pull - static_cast<Wide>(sign(pull)) * drag, sign(pull)};
  };
  if (slip == 0) return {from_rest(start)};
  const Wide rate = pull - static_cast<Wide>(sign(slip)) * drag;
  std::vector<SlipPhase> phases = {{start, slip, rate, sign(slip)}};
  if (sign(rate) == -sign(slip)) phases.push_back(from_rest(start - slip / rate));
  return phases;
}

}  // namespace cylon::exact
