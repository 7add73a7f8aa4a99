// The first instant at which a polynomial of time falls to zero: when two surfaces meet.
#pragma once

#include "engine/vector.h"

#include <array>
#include <cmath>
#include <limits>

namespace cylon::engine::ballistic {

inline constexpr Real never = std::numeric_limits<Real>::infinity();

/// The first t >= 0 at which gap + rate t + acceleration t^2/2 falls to zero or through it.
///   t = 2 gap / (-rate + sqrt(rate^2 - 2 acceleration gap)), rate <= 0;  (rate + sqrt(..)) / -acceleration,
///   else
/// Of the two forms of the root the one without a difference of like numbers.  A gap <= 0 counts as touching.
inline Real first_contact(Real gap, Real rate, Real acceleration) {
  if (gap <= 0) {
    if (rate < 0) return 0;
    if (acceleration >= 0) return never;
    return -2 * rate / acceleration;
  }
  if (rate >= 0 && acceleration >= 0) return never;
  const Real discriminant = rate * rate - 2 * acceleration * gap;
  if (discriminant < 0) return never;
  const Real root = std::sqrt(discriminant);
  return rate <= 0 ? 2 * gap / (root - rate) : (rate + root) / -acceleration;
}

/// c[0] + c[1] t + ... + c[degree] t^degree.
template <std::size_t degree>
Real value(const std::array<Real, degree + 1>& c, Real t) {
  Real sum = c[degree];
  for (std::size_t k = degree; k-- > 0;) sum = sum * t + c[k];
  return sum;
}

template <std::size_t degree>
std::array<Real, degree> derivative(const std::array<Real, degree + 1>& c) {
  std::array<Real, degree> d;
  for (std::size_t k = 0; k < degree; ++k) d[k] = static_cast<Real>(k + 1) * c[k + 1];
  return d;
}

/// A bound of the roots: twice the largest |c_k / c_degree|^(1/(degree - k)), rounded up to a power of two so
/// that a change of units by powers of two changes it exactly.  M. Fujiwara, Tohoku Math. J. 10 (1916) 167.
template <std::size_t degree>
Real root_bound(const std::array<Real, degree + 1>& c) {
  int largest = std::numeric_limits<int>::min();
  for (std::size_t k = 0; k < degree; ++k) {
    if (c[k] == 0) continue;
    const int order = static_cast<int>(degree - k), exponent = std::ilogb(c[k] / c[degree]) + 1;
    const int part = exponent >= 0 ? (exponent + order - 1) / order : -(-exponent / order);
    if (part > largest) largest = part;
  }
  return largest == std::numeric_limits<int>::min() ? Real(0) : std::ldexp(Real(1), largest + 1);
}

/// The root of a polynomial that is monotonic between low and high and of different sign there.
/// Newton's method, by halves where it would leave the bracket or does not halve its step.
template <std::size_t degree>
Real root_between(const std::array<Real, degree + 1>& c, Real low, Real high) {
  const bool rises = value<degree>(c, high) > 0;
  const auto slope = derivative<degree>(c);
  Real t = low + (high - low) / 2, last = high - low;
  for (int i = 0; i < 2200; ++i) {  // 2^-1074: halving alone ends
    const Real f = value<degree>(c, t);
    if (f == 0) return t;
    ((f > 0) == rises ? high : low) = t;
    Real next = t - f / value<degree - 1>(slope, t);
    if (!(next > low && next < high) || std::abs(next - t) > last / 2) next = low + (high - low) / 2;
    if (next == t || next <= low || next >= high) return next;
    last = std::abs(next - t);
    t = next;
  }
  return t;
}

template <std::size_t degree>
struct Roots {
  std::array<Real, degree> at;
  std::size_t count = 0;
};

/// All t > 0 at which the polynomial changes sign, in order.  Between the roots of its derivative it is
/// monotonic: brackets from the degree below, down to the straight line.
template <std::size_t degree>
Roots<degree> sign_changes(const std::array<Real, degree + 1>& c) {
  Roots<degree> roots;
  if constexpr (degree == 1) {
    if (c[1] != 0 && -c[0] / c[1] > 0) roots.at[roots.count++] = -c[0] / c[1];
  } else {
    if (c[degree] == 0) {
      std::array<Real, degree> lower;
      for (std::size_t k = 0; k < degree; ++k) lower[k] = c[k];
      const auto found = sign_changes<degree - 1>(lower);
      for (std::size_t k = 0; k < found.count; ++k) roots.at[roots.count++] = found.at[k];
      return roots;
    }
    const auto extremes = sign_changes<degree - 1>(derivative<degree>(c));
    const Real end = root_bound<degree>(c);
    Real low = 0, f_low = c[0];
    for (std::size_t k = 0; k <= extremes.count; ++k) {
      const Real high = k < extremes.count ? extremes.at[k] : end;
      if (!(high > low)) continue;
      const Real f_high = value<degree>(c, high);
      if ((f_low < 0 && f_high >= 0) || (f_low > 0 && f_high <= 0))
        roots.at[roots.count++] = root_between<degree>(c, low, high);
      low = high;
      f_low = f_high;
    }
  }
  return roots;
}

/// The first t > 0 at which a polynomial that starts positive falls through zero.
template <std::size_t degree>
Real first_fall(const std::array<Real, degree + 1>& c) {
  const auto roots = sign_changes<degree>(c);
  return roots.count > 0 ? roots.at[0] : never;
}

}  // namespace cylon::engine::ballistic
