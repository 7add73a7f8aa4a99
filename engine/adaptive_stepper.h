// Smooth motion by error-controlled steps, sampled between them by dense output.
#pragma once

#include "engine/schemes/dop853.h"
#include "engine/stepper.h"

#include <cstdint>
#include <cstdio>
#include <limits>
#include <utility>

namespace cylon::engine {

/// `Read` copies the state into motions:  void(const S&, const Real* y, std::vector<Motion>&).  Where no step
/// meets the tolerance any more (a collision of attracting points) the motion ends: all later states are not
/// a number, and a remark says when.
template <System S, class Read>
class AdaptiveStepper final : public Stepper {
 public:
  AdaptiveStepper(S system, std::vector<Real> initial, Real tolerance, Time dt, Read read)
      : system_(std::move(system)),
        y_(std::move(initial)),
        scheme_(y_.size(), tolerance),
        dt_(dt),
        read_(std::move(read)) {
    scheme_.start(system_, 0, y_.data());
  }

  void step() override {
    const Time now = static_cast<Time>(++steps_) * dt_;
    while (going_ && scheme_.end() < now) {
      going_ = scheme_.step(system_, scheme_.end() + farthest * dt_) == Outcome::done;
    }
    if (going_)
      scheme_.at(system_, now, y_.data());
    else
      std::fill(y_.begin(), y_.end(), std::numeric_limits<Real>::quiet_NaN());
  }
  void read(std::vector<Motion>& motions) const override { read_(system_, y_.data(), motions); }
  const std::vector<Impact>& impacts() const override { return none_; }
  const Real* works() const override {
    if constexpr (requires { system_.works(y_.data()); })
      return system_.works(y_.data());
    else
      return nullptr;
  }
  std::vector<std::string> remarks() const override {
    if (going_) return {};
    char text[120];
    std::snprintf(text, sizeof text,
                  "the motion cannot be followed beyond t = %.17g s: no step is short enough", scheme_.end());
    return {text};
  }

 private:
  static constexpr Time farthest = 1e6;  // steps of dt that one step of the scheme may span

  S system_;
  std::vector<Real> y_;
  Dop853<S> scheme_;
  Time dt_;
  Read read_;
  std::int64_t steps_ = 0;
  bool going_ = true;
  std::vector<Impact> none_;
};

}  // namespace cylon::engine
