// What steps take, as Stepper::operations() counts it: in units of about 0.05 us.
#pragma once

#include <algorithm>
#include <cstdint>
#include <memory>
#include <utility>

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

/// Operations that a run may spend: some in each step, and beside them a reserve, which several runs share.
class Allowance {
 public:
  explicit Allowance(std::shared_ptr<std::int64_t> reserve) : reserve_(std::move(reserve)) {}

  void add(std::int64_t operations) { allowed_ += operations; }

  /// Whether `operations`, all so far, are more than is allowed and than the reserve has left, which it draws on.
  bool is_spent(std::int64_t operations) {
    const std::int64_t beyond = operations - allowed_;
    if (beyond <= 0) return false;
    const std::int64_t drawn = std::min(beyond, *reserve_);
    allowed_ += drawn, *reserve_ -= drawn;
    return drawn < beyond;
  }

  std::int64_t reserve() const { return *reserve_; }

 private:
  std::int64_t allowed_ = 0;
  std::shared_ptr<std::int64_t> reserve_;
};

}  // namespace cylon::engine
