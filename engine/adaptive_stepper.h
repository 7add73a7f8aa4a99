// Smooth motion by error-controlled steps, sampled between them by dense output.
#pragma once

#include "engine/integrators/dop853.h"
#include "engine/operations.h"
#include "engine/root.h"
#include "engine/system_stepper.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <utility>

namespace cylon::engine {

/// Whether forces of a System switch on and off; each switch is an end of smooth motion and is located in
/// time.
template <class S>
concept Switching = requires(S& s, const S& c, Time t, const Real* y) {
  { c.switch_count() } -> std::convertible_to<std::size_t>;
  { c.switch_value(std::size_t(), t, y) } -> std::convertible_to<Real>;
  s.flip(std::size_t());
  s.watch(t, y);
  s.unwatch();
};

/// Where no step meets the tolerance any more (a collision of attracting points) the motion ends: all later
/// states are not a number, and a diagnostic says when.  Where it takes more than step_evaluations in a step and the
/// reserve is used up, steps are not shortened for what rounding makes, and a diagnostic says so.
template <System S, class Read>
class AdaptiveStepper final : public SystemStepper<S, Read> {
  using Base = SystemStepper<S, Read>;
  using Base::dt_, Base::steps_, Base::system_, Base::y_;

 public:
  /// Operations that the runs of one motion may spend beside those of each step.
  static constexpr std::int64_t first_operations = 2'000'000;

  /// `reserve`: what is left of first_operations.
  AdaptiveStepper(S system, std::vector<Real> initial, Real tolerance, Time dt, Read read, std::int64_t first,
                  std::shared_ptr<std::int64_t> reserve)
      : Base(std::move(system), std::move(initial), dt, std::move(read), first),
        integrator_(system_.size(), tolerance),
        allowance_(std::move(reserve)) {
    const Time start = static_cast<Time>(first) * dt;
    if constexpr (Switching<S>) {
      watching_ = system_.switch_count() > 0;
      if (watching_) system_.watch(start, y_.data());
    }
    start_piece(start);
    integrator_.start(system_, start, y_.data());
  }

  void step() override {
    const Time now = static_cast<Time>(++steps_) * dt_;
    flips_ = 0;
    allowance_.add(Base::operations_of(step_evaluations));
    while (going_ && reached() < now) {
      if (turn_) {
        take_turn();
      } else {
        if (integrator_.end() >= kink_) cross_kink();
        if (allowance_.is_spent(operations())) integrator_.take_rounding();
        ending_ = integrator_.step(system_, std::min(integrator_.end() + farthest() * dt_, kink_));
        if (integrator_.rounded()) log_.note(DiagnosticKind::rounding_exceeds, integrator_.begin());
        going_ = ending_ == Ending::done;
        if (going_ && watching_) turn_ = first_turn();
      }
    }
    if (going_)
      integrator_.at(system_, now, y_.data());
    else
      std::fill_n(y_.begin(), system_.size(), std::numeric_limits<Real>::quiet_NaN());
  }

  /// Near a change point a sample is not as good as those before and after.
  bool struck() const override { return integrator_.near_change(); }
  std::int64_t operations() const override { return Base::operations_of(integrator_.evaluations()); }

  std::vector<Diagnostic> diagnostics() const override {
    DiagnosticLog log = log_;
    if (ending_ != Ending::done)
      log.note(DiagnosticKind::integration_ended, integrator_.end(), {}, {},
               ending_ == Ending::non_finite ? "a rate is not a number"
                                             : "no step is small enough for the tolerance");
    if (slides_at_ > 0) log.note(DiagnosticKind::switches_not_located, slides_at_, most_flips);
    std::vector<Diagnostic> all = log.all();
    for (Diagnostic& d : Base::diagnostics()) all.push_back(std::move(d));
    return all;
  }

 private:
  static constexpr std::int64_t step_evaluations = 100;
  // Steps of dt that one step of the integrator may span.  What rests until something reaches it, a wave or a force that
  // somebody wrote, is looked at now and then: no error tells of a force that is zero wherever it was asked for.
  Time farthest() const {
    if constexpr (requires(const S& s) { s.may_be_reached(); })
      return system_.may_be_reached() ? 16 : 1e6;
    else
      return 1e6;
  }
  // Places within a step of the integrator at which a change of sign is looked for.  A switch that goes and comes back
  // between two of them is none.
  static constexpr int looks = 8;
  // In a step of dt; more is a force that pushes its switch back at once.
  static constexpr int most_flips = 200;

  struct Turn {
    Time time;
    std::size_t which;
    Real side;  // the least number of the sign that its value has after
  };

  void start_piece(Time t) {
    if constexpr (Kinked<S>) {
      kink_ = system_.next_kink(t);
      system_.start_piece(t);
    }
  }

  // Samples of the last step, its end included, have been given out.
  void cross_kink() {
    std::copy_n(integrator_.state(), system_.size(), y_.begin());
    system_.project(y_.data());
    start_piece(integrator_.end());
    integrator_.start(system_, integrator_.end(), y_.data(), integrator_.next_step());
  }

  Time reached() const { return turn_ ? turn_->time : integrator_.end(); }

  // The first switch in the last step of the integrator.
  std::optional<Turn> first_turn() {
    std::optional<Turn> first;
    if constexpr (Switching<S>) {
      const Time begin = integrator_.begin(), span = integrator_.end() - begin;
      const auto value = [&](std::size_t k, Real part) {
        const Time t = part < 1 ? begin + static_cast<Time>(part) * span : integrator_.end();
        integrator_.at(system_, t, y_.data());
        return system_.switch_value(k, t, y_.data());
      };
      for (std::size_t k = 0; k < system_.switch_count(); ++k) {
        Real low = 0, low_value = value(k, 0);
        if (last_turn_ && k == last_turn_->which && begin == last_turn_->time)
          low_value = last_turn_->side;  // it has just been at zero, and went there
        for (int i = 1; i <= looks; ++i) {
          const Real high = static_cast<Real>(i) / looks, high_value = value(k, high);
          if ((low_value < 0 && high_value > 0) || (low_value > 0 && high_value < 0)) {
            const Real part = root([&](Real x) { return value(k, x); }, low, low_value, high, high_value);
            const Time t = begin + static_cast<Time>(part) * span;
            const Real side = std::copysign(std::numeric_limits<Real>::min(), high_value);
            if (!first || t < first->time) first = Turn{t, k, side};
            break;
          }
          low = high, low_value = high_value;
        }
      }
    }
    return first;
  }

  void take_turn() {
    if constexpr (Switching<S>) {
      const Turn turn = *std::exchange(turn_, std::nullopt);
      integrator_.at(system_, turn.time, y_.data());
      if (++flips_ > most_flips) {
        system_.unwatch();
        watching_ = false;
        slides_at_ = turn.time;
      } else {
        system_.flip(turn.which);
      }
      last_turn_ = turn;
      integrator_.start(system_, turn.time, y_.data(), integrator_.next_step());
    }
  }

  Dop853<S> integrator_;
  Ending ending_ = Ending::done;
  bool going_ = true, watching_ = false;
  Time kink_ = std::numeric_limits<Time>::infinity();  // the next
  std::optional<Turn> turn_;                           // the next, within the last step of the integrator
  int flips_ = 0;
  std::optional<Turn> last_turn_;
  Time slides_at_ = 0;
  Allowance allowance_;
  DiagnosticLog log_;
};

}  // namespace cylon::engine
