// What steps take, as Stepper::operations() counts it: in units of about 0.05 us.
#pragma once

#include <cstdint>

namespace cylon::engine {

/// Of the linear equations of so many rows, solved anew.
constexpr std::int64_t linear_operations(std::int64_t rows) { return 20 + rows * rows * rows / 10; }

/// Of one round over so many points, each of which all others act on.
constexpr std::int64_t sweep_operations(std::int64_t points) { return 30 * points; }

/// Of so many multiplications in a row.
constexpr std::int64_t row_operations(std::int64_t multiplications) { return 1 + multiplications / 100; }

/// Of so many evaluations of the forces on a state of so many numbers: some three for a body that turns.
constexpr std::int64_t rate_operations(std::int64_t evaluations, std::int64_t numbers) {
  return evaluations * (numbers / 4 + 1);
}

}  // namespace cylon::engine
