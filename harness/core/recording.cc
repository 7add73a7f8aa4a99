#include "harness/core/recording.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

namespace cylon::core {

std::int64_t whole_steps(double duration, double dt) {
  if (!(dt > 0) || !std::isfinite(dt) || !(duration >= 0) || !std::isfinite(duration))
    throw std::invalid_argument(
        fmt::format("a step of {} s over {} s: both must be finite, the step positive", dt, duration));
  const double ratio = duration / dt, steps = std::round(ratio);
  if (std::abs(ratio - steps) > 1e-9 * std::max(1.0, ratio) || (steps == 0 && duration > 0))
    throw std::invalid_argument(
        fmt::format("{} s is not a whole number of steps of {} s; nearest: {:.12g} s, or steps of {} s",
                    duration, dt, std::max(1.0, steps) * dt, duration / std::max(1.0, steps)));
  if (steps > 9e15) throw std::invalid_argument(fmt::format("{} steps are too many", steps));
  return static_cast<std::int64_t>(steps);
}

std::int64_t sampling_stride(std::size_t bodies, std::int64_t steps, double dt, double sample) {
  if (sample > 0) return whole_steps(sample, dt);
  constexpr double dense = 1e6;  // bodies x steps
  constexpr std::int64_t samples = 200;
  if (static_cast<double>(bodies) * static_cast<double>(steps) <= dense) return 1;
  return (steps + samples - 1) / samples;
}

}  // namespace cylon::core
