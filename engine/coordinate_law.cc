#include "engine/coordinate_law.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::engine {

std::size_t Target::piece_at(Time t) const {
  return static_cast<std::size_t>(std::upper_bound(times.begin(), times.end(), t) - times.begin());
}

Target::Now Target::at(Time t) const {
  if (times.empty()) {
    if (amplitude == 0) return {value, 0};
    const Real angle =
        phase + static_cast<Real>(std::fmod(static_cast<Time>(frequency) * t, 2 * std::numbers::pi_v<Time>));
    return {value + amplitude * std::cos(angle), -amplitude * frequency * std::sin(angle)};
  }
  const std::size_t i = piece_.value_or(piece_at(t));
  if (i == 0) return {values.front(), 0};
  if (i == times.size()) return {values.back(), 0};
  const Real rate = (values[i] - values[i - 1]) / static_cast<Real>(times[i] - times[i - 1]);
  return {values[i - 1] + rate * static_cast<Real>(t - times[i - 1]), rate};
}

Time Target::next_kink(Time t) const {
  const std::size_t i = piece_at(t);
  return i < times.size() ? times[i] : std::numeric_limits<Time>::infinity();
}

void Target::start_piece(Time t) {
  if (!times.empty()) piece_ = piece_at(t);
}

}  // namespace cylon::engine
