// Smooth motion by fixed steps of an integrator.
#pragma once

#include "engine/integrators/advance.h"
#include "engine/system_stepper.h"

#include <cstdint>
#include <utility>

namespace cylon::engine {

template <System S, class Read>
class SmoothStepper final : public SystemStepper<S, Read> {
  using Base = SystemStepper<S, Read>;
  using Base::dt_, Base::first_, Base::steps_, Base::system_, Base::y_;

 public:
  SmoothStepper(S system, std::vector<Real> initial, const Integrator& integrator, Time dt, Read read,
                std::int64_t first)
      : Base(std::move(system), std::move(initial), dt, std::move(read), first),
        advance_(integrator, system_.size()),
        evaluations_(integrator.evaluations) {}

  /// A step that goes over a kink of the forces is made in parts.
  void step() override {
    if constexpr (Kinked<S>) {
      const Time begin = static_cast<Time>(steps_) * dt_, end = begin + dt_, sliver = no_part * dt_;
      Time now = begin;
      system_.start_piece(now + sliver);
      for (Time kink = now; (kink = system_.next_kink(now + sliver)) < end - sliver; now = kink) {
        advance_(system_, now, kink - now, y_.data());
        ++cuts_;
        system_.start_piece(kink + sliver);
      }
      advance_(system_, now, now == begin ? dt_ : end - now, y_.data());
    } else {
      advance_(system_, static_cast<Time>(steps_) * dt_, dt_, y_.data());
    }
    ++steps_;
  }
  /// The same motion as n single steps, to rounding: where a splitting's step ends with the part that the
  /// next begins with, the two are made as one, which rounds once in place of twice.  With joints, and by
  /// Runge-Kutta, the same bits if no force reads the time, which is t + i dt here and (n + i) dt there.
  void advance(std::int64_t n) override {
    if constexpr (Kinked<S>) {
      const Time begin = (static_cast<Time>(steps_) + no_part) * dt_;
      if (system_.next_kink(begin) < static_cast<Time>(steps_ + n) * dt_) return Base::advance(n);
      system_.start_piece(begin);
    }
    advance_.run(system_, static_cast<Time>(steps_) * dt_, dt_, y_.data(), static_cast<std::size_t>(n));
    steps_ += n;
  }
  std::int64_t operations() const override {
    return Base::operations_of(evaluations_ * (steps_ - first_ + cuts_));
  }

 private:
  static constexpr Time no_part = 1e-9;  // of a step: a kink so near to its end is there

  Advance<S> advance_;
  std::int64_t evaluations_, cuts_ = 0;  // of the forces in a step; of steps, at kinks
};

}  // namespace cylon::engine
