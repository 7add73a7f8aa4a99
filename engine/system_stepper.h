// What steppers of a System have in common: the state that is shown, and how it is read.
#pragma once

#include "engine/operations.h"
#include "engine/stepper.h"
#include "engine/system.h"

#include <cstdint>
#include <utility>
#include <vector>

namespace cylon::engine {

/// `Read` copies the state into motions:  void(const S&, const Real* y, std::vector<Motion>&).  `initial` is
/// the state at t = first dt.
template <System S, class Read>
class SystemStepper : public Stepper {
 public:
  SystemStepper(S system, std::vector<Real> initial, Time dt, Read read, std::int64_t first)
      : system_(std::move(system)),
        y_(std::move(initial)),
        dt_(dt),
        first_(first),
        steps_(first),
        read_(std::move(read)) {}

  void read(std::vector<Motion>& motions) const final { read_(system_, y_.data(), motions); }
  void read_turns(std::vector<Real>& turns) const final {
    if constexpr (requires { system_.read_turns(y_.data(), turns); })
      system_.read_turns(y_.data(), turns);
    else
      turns.clear();
  }
  std::vector<Diagnostic> diagnostics() const override {
    if constexpr (requires { system_.diagnostics(); })
      return system_.diagnostics();
    else
      return {};
  }
  const Real* works() const final {
    if constexpr (requires { system_.works(y_.data()); })
      return system_.works(y_.data());
    else
      return nullptr;
  }

 protected:
  /// Of so many evaluations of the forces.
  std::int64_t operations_of(std::int64_t evaluations) const {
    return rate_operations(evaluations, static_cast<std::int64_t>(system_.size()));
  }

  S system_;
  std::vector<Real> y_;
  Time dt_;
  std::int64_t first_, steps_;

 private:
  Read read_;
};

}  // namespace cylon::engine
