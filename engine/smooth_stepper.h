// Smooth motion by fixed steps of a scheme.
#pragma once

#include "engine/schemes/advance.h"
#include "engine/stepper.h"

#include <cstdint>
#include <utility>

namespace cylon::engine {

/// `Read` copies the state into motions:  void(const S&, const Real* y, std::vector<Motion>&).
template <System S, class Read>
class SmoothStepper final : public Stepper {
 public:
  SmoothStepper(S system, std::vector<Real> initial, const Scheme& scheme, Time dt, Read read)
      : system_(std::move(system)),
        y_(std::move(initial)),
        advance_(scheme, y_.size()),
        dt_(dt),
        read_(std::move(read)) {}

  void step() override {
    advance_(system_, static_cast<Time>(steps_) * dt_, dt_, y_.data());
    ++steps_;
  }
  void advance(std::int64_t n) override {
    advance_.run(system_, static_cast<Time>(steps_) * dt_, dt_, y_.data(), static_cast<std::size_t>(n));
    steps_ += n;
  }
  void read(std::vector<Motion>& motions) const override { read_(system_, y_.data(), motions); }
  const std::vector<Impact>& impacts() const override { return none_; }
  const Real* works() const override {
    if constexpr (requires { system_.works(y_.data()); })
      return system_.works(y_.data());
    else
      return nullptr;
  }

 private:
  S system_;
  std::vector<Real> y_;
  Advance<S> advance_;
  Time dt_;
  Read read_;
  std::int64_t steps_ = 0;
  std::vector<Impact> none_;
};

}  // namespace cylon::engine
