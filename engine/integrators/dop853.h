// Error-controlled motion of a System: DOPRI 8(5,3) with dense output.
#pragma once

#include "engine/integrators/advance.h"
#include "engine/integrators/combination.h"
#include "engine/integrators/tableaus.h"
#include "engine/system.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

namespace cylon::engine {

/// How an error-controlled run stands.
enum class Ending : unsigned char {
  done,
  step_too_small,  ///< The tolerance cannot be kept: no step above rounding of the time meets it.
  non_finite       ///< The rates are not finite, however short the step.
};

/// A System that tells of the joints, at its last rates or projection, how near their conditions are to saying the same: sin^2
/// of an angle between the motions that they forbid, 1 where there is nothing of the kind; and the same at a state, for bodies
/// of equal masses.
template <class S>
concept Dependent = requires(S& s, const S& c, const Real* y) {
  { c.weakest() } -> std::convertible_to<Real>;
  { s.weakest_alike(y) } -> std::convertible_to<Real>;
};

/// E. Hairer, S. P. Norsett, G. Wanner, Solving Ordinary Differential Equations I (2nd ed. 1993), II.5-II.6,
/// and its program dop853.f: order 8, error estimates of orders 5 and 3, dense output of order 7.
///
/// A step h is taken when the error norm is at most 1,
///   error = |h| E5 / sqrt(E5 + 0.01 E3) / sqrt(n),  E = sum_i (estimate_i / (tolerance scale_i))^2
/// and the next is h times 0.9 error^(-1/8 + 0.2 beta) previous^beta within [1/3, 6], beta = 0.04 (PI
/// control, section IV.2 of volume II).  scale_i comes from the System's `void scales(const Real* y, Real*
/// scale)` where it has one, else from |y_i|, at least 1e-3 of the largest |y|.
///
/// The state is summed with compensation: what rounding takes from it is carried on to the next step, so that
/// many steps round as one.
///
/// Rounding of ill-conditioned rates (joints of light bodies between heavy ones) makes an error in proportion to h,
/// which shorter steps hardly make smaller: steps would shrink until it is below the tolerance.  From
/// take_rounding() on it is measured, for each number of the state,
///   rounding_i = |f_i(t, y +- epsilon scale) - f_i(t, y)|,  the largest of late,
/// and where these are more than `ill_conditioned` epsilon |f|, `weight` h rounding_i is no part of estimate_i of E5.
///
/// Where conditions of joints say the same for an instant (the bars of a parallelogram in line), the motion is smooth and
/// its rates are rounding over the distance from there: steps that shorten until they meet the tolerance end at that point.
/// The nodes of the method leave (1/3, 3/5) of a step free.  So a step that shortening helps in no way in which it helps a
/// smooth motion, with conditions that nearly say the same (the System's weakest()), is made one that goes over the place:
/// steps from the longest of late on, each four fifths of the one before, bring it into that gap.  Their errors are those
/// of the settled motion: what a stage near the place makes of rounding, closing the joints takes away.  Nor does a step end
/// so near to the place that closing the joints there would divide their rounding by next to nothing.
template <System S>
class Dop853 {
 public:
  /// tolerance: relative to the scales, per step; at least epsilon/2, less counts as that; the compensated
  /// sums make that worth asking for.
  Dop853(std::size_t size, Real tolerance)
      : n_(size), tolerance_(std::max(tolerance, epsilon / 2)), memory_((stages + 9 + 8) * size) {
    Real* at = memory_.data();
    const auto take = [&](std::size_t vectors) { return std::exchange(at, at + vectors * n_); };
    k_ = take(stages);
    y_ = take(1), next_ = take(1), stage_ = take(1), carry_ = take(1), scale_ = take(1), change_ = take(1);
    rounding_ = take(1), settled_ = take(1), weak_ = take(1);
    dense_ = take(8);
  }

  Dop853(const Dop853&) = delete;  // its parts point into its memory
  Dop853& operator=(const Dop853&) = delete;
  Dop853(Dop853&&) noexcept = default;
  Dop853& operator=(Dop853&&) noexcept = default;
  ~Dop853() = default;

  /// Starts anew at t, after an impact or from another state, with a first step h [s], such as next_step();
  /// 0: chosen from the rates.
  void start(S& s, Time t, const Real* y, Time h = 0) {
    begin_ = end_ = t;
    std::copy_n(y, n_, y_);
    std::fill_n(carry_, n_, Real(0));
    s.rates(t, y_, k_);
    ++evaluations_;
    h_ = h;
    previous_error_ = 1e-4;
    dense_ready_ = false;
  }

  /// One accepted step forward, at most to `limit`, which it meets exactly.  Requires start(), limit > end().
  Ending step(S& s, Time limit) {
    assert(limit > end_);
    if (h_ == 0) h_ = first_step(s, limit - end_);
    bool rejected = false, measured = false;
    Time longer = 0;    // the step tried before, which
    double worse = 0;   // had this error
    Crossing crossing;  // of a change point
    while (true) {
      const bool last = end_ + 1.01 * h_ >= limit;            // no sliver of a step is left over
      const Time t = last ? limit : end_ + h_, h = t - end_;  // the step that the time will show
      if (h <= smallest(limit)) {
        // An interval as short as rounding is crossed all the same; a step that had to become so is not.
        if (rejected) return finite_ ? Ending::step_too_small : Ending::non_finite;
      }
      take_stages(s, h);
      double error = crossing.step > 0 ? settled_error_norm(s, h) : error_norm(s, h);
      finite_ = std::isfinite(error);
      const bool within = error <= 1;
      if (takes_rounding_ && finite_ && crossing.step == 0) {
        if (!measured) measure_rounding(s);
        measured = true;
        error = std::max(error_norm(s, h, weight), std::min(error, 0.01));  // a step grows at most by half
      }
      if (error <= crossing.most) {
        near_change_ = near_change(s);
        if (near_change_ && !last && ends_ill(s)) error = 2 * crossing.most;
      }
      // error^(1/8 - 0.2 beta) / previous^beta / 0.9
      const double raw = finite_ ? std::pow(error, 0.125 - 0.2 * beta) : 10;
      if (finite_ && error <= crossing.most) {
        const double factor = raw / std::pow(previous_error_, beta) / 0.9;
        const Time wish = h / std::clamp(factor, 1.0 / 6, 3.0);
        // a step cut short by the limit says nothing against the longer one that was planned
        h_ = rejected ? std::min(wish, h) : last ? std::max(wish, std::min(h_, 6 * h)) : wish;
        previous_error_ = std::clamp(error, 1e-4, 1.0);
        rounded_ = !within;
        accept(s, h, t);
        return Ending::done;
      }
      ++rejected_;
      h_ = h / std::clamp(raw / 0.9, 1.1, finite_ ? 3.0 : 10.0);
      if (crossing.step > 0) {
        h_ = crossing.next(error);
      } else if (crossing.least == 0) {
        const double smooth = rejected ? worse * std::pow(h / longer, 4) : no_smooth_error;
        if ((!(error < smooth) || much_shorter * h < usual_) && near_change(s)) {
          crossing.step = usual_, crossing.least = h_;
          std::swap(h_, usual_);
        }
      }
      rejected = true, longer = h, worse = error;
    }
  }

  /// From t0 to t1 > t0 exactly, in as many steps as it takes.  Goes on where the last call ended if t0 and y
  /// are what it left, else starts anew with the step that it had.
  Ending advance(S& s, Time t0, Time t1, Real* y) {
    if (t1 == t0) return Ending::done;
    if (!(accepted_ > 0 && t0 == end_ && std::equal(y, y + n_, y_))) start(s, t0, y, h_);
    while (end_ < t1) {
      if (const Ending outcome = step(s, t1); outcome != Ending::done) {
        std::copy_n(y_, n_, y);
        return outcome;
      }
    }
    std::copy_n(y_, n_, y);
    return Ending::done;
  }

  Time begin() const { return begin_; }     ///< Of the last accepted step [s].
  Time end() const { return end_; }         ///< Of the last accepted step: where state() is [s].
  const Real* state() const { return y_; }  ///< At end().
  const Real* rates() const { return k_; }  ///< At end().

  /// The state at any time of the last accepted step, begin() <= t <= end(); settled.  Costs three evaluations the first
  /// time in a step.  Where settling would divide the rounding of closed joints by next to nothing, from states around:
  ///   y(t) = (15 (y(t - d) + y(t + d)) - 6 (y(t - 2d) + y(t + 2d)) + y(t - 3d) + y(t + 3d))/20 + O(d^6)
  void at(S& s, Time t, Real* y) {
    if (t == end_ || begin_ == end_) {
      std::copy_n(y_, n_, y);
      return;
    }
    if (!dense_ready_) prepare_dense(s);
    settled_at(s, t, y);
    if constexpr (Dependent<S>) {
      const Time d = step_ / 25;  // 3 d is as far as the nodes are from the middle of what they leave free
      if (!near_change_ || s.weakest() > ill_settled || t - 3 * d < begin_ || t + 3 * d > end_) return;
      std::fill_n(y, n_, Real(0));
      for (const int k : {-3, -2, -1, 1, 2, 3}) {
        const Real part = std::abs(k) == 1 ? Real(0.75) : std::abs(k) == 2 ? Real(-0.3) : Real(0.05);
        settled_at(s, t + k * d, settled_);
        for (std::size_t i = 0; i < n_; ++i) y[i] += part * settled_[i];
      }
    }
  }

  /// From now on errors that rounding of the rates makes are taken.
  void take_rounding() { takes_rounding_ = true; }
  bool takes_rounding() const { return takes_rounding_; }

  Time next_step() const { return h_; }  ///< The step that will be tried next [s].
  long evaluations() const { return evaluations_; }
  long accepted() const { return accepted_; }
  long rejected() const { return rejected_; }
  /// Whether the last step was taken with an error over the tolerance, because rounding makes it.
  bool rounded() const { return rounded_; }
  /// Whether the last step went near a change point.
  bool near_change() const { return near_change_; }

 private:
  static constexpr std::size_t stages = 16;
  static constexpr double beta = 0.04;
  // The weights of E5 on rates with errors of their own add up to 2.2, and a few rates tell little of those errors.
  static constexpr double weight = 6;
  static constexpr double ill_conditioned = 100;
  static constexpr Real kept = Real(0.98);  // of what was measured, from one measurement to the next
  // Rows of joints that are so near to saying the same: sin^2 of an angle.
  static constexpr Real least_share = Real(1) / 64;
  // Settling errs by rounding over this: cbrt(epsilon).
  static constexpr Real ill_settled = Real(5e-6);
  // Of a step that the controller asks for: in a smooth motion it is less than 1.8 times too long.
  static constexpr double no_smooth_error = 100;
  // Steps that have become so many times shorter than those of late, each with an error that fell as it should.
  static constexpr double much_shorter = 30;

  // Steps over a change point that are tried, the longest first.  Where none meets the tolerance the best of them is taken,
  // with an error of up to 10^6 tolerances (1e-7 of the scales at the tolerances of `auto`), and told (rounded()): what comes
  // nearer to the place is worse, or ends there.
  struct Crossing {
    Time step = 0, least = 0;  // that is tried, 0: none; and where the trials end
    double most = 1;           // the error that is taken
    Time best = 0;
    double best_error = 1e6;

    // After a step with this error.
    Time next(double error) {
      if (error < best_error) best = step, best_error = error;
      const bool ends = step <= 1.25 * least;
      const bool taken = ends && best > 0 && most == 1;
      if (taken) most = 10 * best_error;  // it may round in another way
      step = taken ? best : ends ? 0 : step / 1.25;
      return step > 0 ? step : least;
    }
  };

  template <std::size_t I>
  struct Row {
    static constexpr Coefficient at(std::size_t j) { return dop853::matrix[I * (I - 1) / 2 + j]; }
  };

  // The shortest step that moves the time by more than its rounding.
  Time smallest(Time limit) const {
    return 10 * std::numeric_limits<Time>::epsilon() * std::max(std::abs(end_), std::abs(limit));
  }

  Real* k(std::size_t i) { return k_ + i * n_; }

  template <class C, std::size_t I>
  void evaluate(S& s, const Real* from, Time t, Time h, Real* rate) {
    const Real dt = static_cast<Real>(h);
    for (std::size_t i = 0; i < n_; ++i) stage_[i] = from[i] + dt * combination<C, I>(k_, n_, i);
    s.rates(t, stage_, rate);
    ++evaluations_;
    if constexpr (Dependent<S>)
      if (const Real now = s.weakest(); now < weakest_) weakest_ = now, std::copy_n(stage_, n_, weak_);
  }

  void take_stages(S& s, Time h) {
    weakest_ = 1;
    [&]<std::size_t... I>(std::index_sequence<I...>) {
      (evaluate<Row<I + 1>, I + 1>(s, y_, end_ + dop853::nodes[I + 1] * h, h, k(I + 1)), ...);
    }
    (std::make_index_sequence<11>{});
    const Real dt = static_cast<Real>(h);
    for (std::size_t i = 0; i < n_; ++i) {
      change_[i] = dt * combination<Entries<dop853::weights>, 12>(k_, n_, i);
      next_[i] = y_[i] + change_[i];
    }
  }

  void set_scales(S& s, const Real* y) {
    if constexpr (requires { s.scales(y, scale_, tolerance_); }) {
      s.scales(y, scale_, tolerance_);
    } else if constexpr (requires { s.scales(y, scale_); }) {
      s.scales(y, scale_);
    } else {
      Real largest = 0;
      for (std::size_t i = 0; i < n_; ++i) largest = std::max(largest, std::abs(y[i]));
      if (largest == 0) largest = 1;
      for (std::size_t i = 0; i < n_; ++i) scale_[i] = std::max(std::abs(y[i]), largest / 1000);
    }
  }

  // Without so many times the rounding.
  double error_norm(S& s, Time h, double roundings = 0) {
    set_scales(s, y_);
    double e5 = 0, e3 = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double unit = static_cast<double>(tolerance_) * static_cast<double>(scale_[i]);
      const double estimate = std::abs(combination<Entries<dop853::error5>, 12>(k_, n_, i));
      const double five = std::max(estimate - roundings * static_cast<double>(rounding_[i]), 0.0) / unit;
      const double three = combination<Entries<dop853::error3>, 12>(k_, n_, i) / unit;
      e5 += five * five, e3 += three * three;
    }
    const double sum = e5 + 0.01 * e3;
    return sum == 0 ? 0 : h * e5 / std::sqrt(sum * static_cast<double>(n_));
  }

  // Whether a stage of the step was near a change point.  Not asked in single precision, in which a step that goes over the
  // place errs by more than one that comes near it.
  bool near_change(S& s) {
    if constexpr (Dependent<S> && epsilon < Real(1e-10))
      return weakest_ < least_share && s.weakest_alike(weak_) < least_share;
    return false;
  }

  // Whether a step that ends at next_ could not be settled there.
  bool ends_ill(S& s) {
    if constexpr (Dependent<S>) {
      std::copy_n(next_, n_, settled_);
      s.project(settled_);
      return s.weakest() < ill_settled;
    }
    return false;
  }

  // The same of what is left of the errors once the step is settled; settling leaves their square.
  double settled_error_norm(S& s, Time h) {
    const double plain = error_norm(s, h);
    if (!std::isfinite(plain)) return plain;
    std::copy_n(next_, n_, settled_);
    s.project(settled_);
    const auto left = [&](auto estimate) {
      const Real dt = static_cast<Real>(h);
      for (std::size_t i = 0; i < n_; ++i) stage_[i] = next_[i] - dt * estimate(i);
      s.project(stage_);
      double sum = 0;
      for (std::size_t i = 0; i < n_; ++i) {
        const double unit = h * static_cast<double>(tolerance_) * static_cast<double>(scale_[i]);
        sum += std::pow((stage_[i] - settled_[i]) / unit, 2);
      }
      return sum;
    };
    const double e5 =
        left([&](std::size_t i) { return combination<Entries<dop853::error5>, 12>(k_, n_, i); });
    const double e3 =
        left([&](std::size_t i) { return combination<Entries<dop853::error3>, 12>(k_, n_, i); });
    const double sum = e5 + 0.01 * e3,
                 first = sum == 0 ? 0 : h * e5 / std::sqrt(sum * static_cast<double>(n_));
    return std::max(first, plain * plain * static_cast<double>(tolerance_));
  }

  // How much the rates move with the last digits of the state; no more than has been, where they move as those of a
  // well-conditioned system do.
  void measure_rounding(S& s) {
    std::uint32_t signs = 1 + static_cast<std::uint32_t>(accepted_);  // others each time
    for (std::size_t i = 0; i < n_; ++i) {
      signs = signs * 1664525 + 1013904223;
      const Real size = scale_[i] < uncontrolled ? scale_[i] : std::abs(y_[i]);
      stage_[i] = y_[i] + (signs >> 31 == 0 ? epsilon : -epsilon) * size;
    }
    s.rates(end_, stage_, next_);
    ++evaluations_;
    double change = 0, all = 0;
    for (std::size_t i = 0; i < n_; ++i) {
      const double scale = static_cast<double>(scale_[i]);
      const double x = static_cast<double>(next_[i] - k_[i]) / scale,
                   rate = static_cast<double>(k_[i]) / scale;
      change += x * x, all += rate * rate;
    }
    const bool ill = change > std::pow(ill_conditioned * static_cast<double>(epsilon), 2) * all;
    for (std::size_t i = 0; i < n_; ++i) {
      const Real now = ill && std::isfinite(change) ? std::abs(next_[i] - k_[i]) : Real(0);
      rounding_[i] = std::max(now, kept * rounding_[i]);
    }
  }

  // Section II.4: a step of Euler's method shows the second derivative; h^8 max(|y'|, |y''|) = 0.01.
  Time first_step(S& s, Time longest) {
    set_scales(s, y_);
    const auto norm = [&](auto&& component) {
      double sum = 0;
      for (std::size_t i = 0; i < n_; ++i) {
        const double x = component(i) / (static_cast<double>(tolerance_) * static_cast<double>(scale_[i]));
        sum += x * x;
      }
      return std::sqrt(sum);
    };
    const double rate = norm([&](std::size_t i) { return static_cast<double>(k_[i]); });
    const double size = norm([&](std::size_t i) { return static_cast<double>(scale_[i]); });
    if (!(rate > 0) || !std::isfinite(rate)) return longest;
    const Time h = std::min(longest, 0.01 * size / rate);
    for (std::size_t i = 0; i < n_; ++i) stage_[i] = y_[i] + static_cast<Real>(h) * k_[i];
    s.rates(end_ + h, stage_, k(1));
    ++evaluations_;
    const double bend = norm([&](std::size_t i) { return static_cast<double>(k(1)[i] - k_[i]); }) / h;
    const double most = std::max(rate, bend);
    return std::isfinite(most) ? std::min({longest, 100 * h, std::pow(0.01 / most, 0.125)}) : h;
  }

  // y' = y + change, and what the sum lost; settled, and the rates there, which the next step begins with.
  void accept(S& s, Time h, Time t) {
    std::copy_n(y_, n_, dense_);
    std::copy_n(k_, n_, dense_ + 2 * n_);
    for (std::size_t i = 0; i < n_; ++i) {
      const Real change = change_[i] + carry_[i], sum = y_[i] + change, taken = sum - y_[i];
      next_[i] = sum;
      carry_[i] = (y_[i] - (sum - taken)) + (change - taken);  // D. Knuth's two-sum
    }
    // A settling of the size of rounding would only add to it.
    std::copy_n(next_, n_, stage_);
    s.project(stage_);
    Real moved = 0;
    for (std::size_t i = 0; i < n_; ++i) moved = std::max(moved, std::abs(stage_[i] - next_[i]) / scale_[i]);
    if (moved > 8 * epsilon) std::copy_n(stage_, n_, next_);
    std::swap(y_, next_);
    s.rates(t, y_, k(12));
    ++evaluations_, ++accepted_;
    step_ = h, usual_ = std::max(h, 0.9 * usual_);
    begin_ = end_;
    end_ = t;
    dense_ready_ = false;
    std::copy_n(k(12), n_, k_);  // first of the next step; the dense output keeps its own
  }

  // contd8 of dop853.f:
  //   y = y_0 + s (c_1 + (1 - s)(c_2 + s (c_3 + (1 - s)(c_4 + s (c_5 + (1 - s)(c_6 + s c_7))))))
  void settled_at(S& s, Time t, Real* y) {
    const Real x = static_cast<Real>((t - begin_) / (end_ - begin_)), r = 1 - x;
    const Real* const c = dense_;
    for (std::size_t i = 0; i < n_; ++i) {
      Real sum = c[7 * n_ + i];
      sum = c[6 * n_ + i] + x * sum;
      sum = c[5 * n_ + i] + r * sum;
      sum = c[4 * n_ + i] + x * sum;
      sum = c[3 * n_ + i] + r * sum;
      sum = c[2 * n_ + i] + x * sum;
      sum = c[1 * n_ + i] + r * sum;
      y[i] = c[i] + x * sum;
    }
    s.project(y);
  }

  // Stages 13 to 15 and the polynomial's coefficients.
  void prepare_dense(S& s) {
    Real* const c = dense_;
    std::copy_n(c + 2 * n_, n_, k_);  // k_0 of the step that was taken
    evaluate<Entries<dop853::dense_matrix13>, 13>(s, c, begin_ + dop853::dense_nodes[0] * step_, step_,
                                                  k(13));
    evaluate<Entries<dop853::dense_matrix14>, 14>(s, c, begin_ + dop853::dense_nodes[1] * step_, step_,
                                                  k(14));
    evaluate<Entries<dop853::dense_matrix15>, 15>(s, c, begin_ + dop853::dense_nodes[2] * step_, step_,
                                                  k(15));
    const Real h = static_cast<Real>(step_);
    for (std::size_t i = 0; i < n_; ++i) {
      const Real difference = y_[i] - c[i], bend = h * k_[i] - difference;
      c[n_ + i] = difference;
      c[3 * n_ + i] = difference - h * k(12)[i] - bend;
      c[4 * n_ + i] = h * combination<Entries<dop853::dense4>, 16>(k_, n_, i);
      c[5 * n_ + i] = h * combination<Entries<dop853::dense5>, 16>(k_, n_, i);
      c[6 * n_ + i] = h * combination<Entries<dop853::dense6>, 16>(k_, n_, i);
      c[7 * n_ + i] = h * combination<Entries<dop853::dense7>, 16>(k_, n_, i);
      c[2 * n_ + i] = bend;
    }
    std::copy_n(k(12), n_, k_);
    dense_ready_ = true;
  }

  std::size_t n_;
  Real tolerance_;
  std::vector<Real> memory_;
  Real *k_ = nullptr, *y_ = nullptr, *next_ = nullptr, *stage_ = nullptr, *carry_ = nullptr;
  Real *scale_ = nullptr, *change_ = nullptr, *dense_ = nullptr, *rounding_ = nullptr, *settled_ = nullptr,
       *weak_ = nullptr;
  Time begin_ = 0, end_ = 0, h_ = 0, step_ = 0;
  Time usual_ = 0;  // the longest step of late
  double previous_error_ = 1e-4;
  bool dense_ready_ = false, finite_ = true;
  bool takes_rounding_ = false, rounded_ = false, near_change_ = false;
  Real weakest_ = 1;  // of the joints, at the stages of a step
  long evaluations_ = 0, accepted_ = 0, rejected_ = 0;
};

}  // namespace cylon::engine
