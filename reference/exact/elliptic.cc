#include "reference/exact/elliptic.h"

#include <boost/math/special_functions/ellint_rf.hpp>
#include <boost/math/special_functions/ellint_rj.hpp>

#include <cassert>
#include <limits>
#include <numbers>

namespace cylon::exact {
namespace {

constexpr Wide pi = std::numbers::pi_v<Wide>;

// phi = half_turns pi + rest, |rest| <= pi/2.
struct Folded {
  Wide half_turns, s, c;
};

Folded fold(const Amplitude& phi) {
  const Wide sign = std::fmod(phi.half_turns, Wide(2)) == 0 ? 1 : -1;
  return {phi.half_turns, sign * phi.sn, sign * phi.cn};
}

}  // namespace

Elliptic::Elliptic(Wide m, Wide m1) : m1_(m1) {
  assert(m >= 0 && m1 > 0);
  // a' = (a + b)/2, b' = sqrt(a b), c' = (a - b)/2, from 1, sqrt(m1), sqrt(m).
  a_[0] = 1, b_[0] = std::sqrt(m1), c_[0] = std::sqrt(m);
  while (c_[static_cast<std::size_t>(levels_)] > std::numeric_limits<Wide>::epsilon() / 4 && levels_ < most) {
    const auto i = static_cast<std::size_t>(levels_++);
    a_[i + 1] = (a_[i] + b_[i]) / 2;
    b_[i + 1] = std::sqrt(a_[i] * b_[i]);
    c_[i + 1] = (a_[i] - b_[i]) / 2;
  }
  quarter_ = pi / (2 * a_[static_cast<std::size_t>(levels_)]);
}

// phi_N = 2^N a_N u;  sin(2 phi_{n-1} - phi_n) = (c_n/a_n) sin phi_n, with a^2 - c^2 = b^2 under the root.
Elliptic::Circular Elliptic::near_zero(Wide u) const {
  Wide phi = std::ldexp(a_[static_cast<std::size_t>(levels_)] * u, levels_);
  for (int n = levels_; n > 0; --n) {
    const auto i = static_cast<std::size_t>(n);
    phi = (phi + std::atan2(c_[i] * std::sin(phi), std::hypot(b_[i], c_[i] * std::cos(phi)))) / 2;
  }
  return {std::sin(phi), std::cos(phi)};
}

// Beyond half a quarter period from the end of the quarter, v = K - u:  sn u = cn v/dn v,  cn u = sqrt(m1) sn v/dn v.
Amplitude Elliptic::at(Wide u) const {
  const Wide half_turns = std::round(u / (2 * quarter_)), rest = u - 2 * half_turns * quarter_;
  Circular f = near_zero(rest);
  if (std::abs(rest) > quarter_ / 2) {
    const Circular v = near_zero(quarter_ - std::abs(rest));
    const Wide dn = std::sqrt(v.c * v.c + m1_ * v.s * v.s);
    f = {std::copysign(v.c / dn, rest), b_[0] * v.s / dn};
  }
  const Wide sign = std::fmod(half_turns, Wide(2)) == 0 ? 1 : -1;
  return {half_turns * pi + std::atan2(f.s, f.c), half_turns, sign * f.s, sign * f.c,
          std::sqrt(f.c * f.c + m1_ * f.s * f.s)};
}

Amplitude Elliptic::towards(Wide y, Wide x) const {
  const Wide length = std::hypot(y, x), sn = y / length, cn = x / length;
  const Wide half_turns = x >= 0 ? 0 : y >= 0 ? 1 : -1;
  return {std::atan2(y, x), half_turns, sn, cn, std::sqrt(cn * cn + m1_ * sn * sn)};
}

Wide Elliptic::first(Wide phi) const {
  if (!std::isfinite(phi)) return std::numeric_limits<Wide>::quiet_NaN();  // Boost's series would not end
  const Wide half_turns = std::round(phi / pi), rest = phi - half_turns * pi;
  const Wide s = std::sin(rest), c = std::cos(rest);
  return 2 * half_turns * quarter_ + s * boost::math::ellint_rf(c * c, c * c + m1_ * s * s, Wide(1));
}

Wide Elliptic::first(const Amplitude& phi) const {
  if (!std::isfinite(phi.sn)) return std::numeric_limits<Wide>::quiet_NaN();
  const auto [half_turns, s, c] = fold(phi);
  return 2 * half_turns * quarter_ + s * boost::math::ellint_rf(c * c, c * c + m1_ * s * s, Wide(1));
}

// With n1 large the integrand is steep at 0: from a quarter turn on back to phi no two terms cancel.
Wide Elliptic::third(Wide n1, const Amplitude& phi) const {
  if (!std::isfinite(phi.sn)) return std::numeric_limits<Wide>::quiet_NaN();
  const auto [half_turns, s, c] = fold(phi);
  const bool from_quarter = n1 > 2 && std::abs(s) > c;
  const Wide quarters = 2 * half_turns + (from_quarter ? std::copysign(Wide(1), s) : 0);
  const Wide whole = quarters == 0 ? 0 : quarters * third_folded(n1, 1, 0);
  return whole + (from_quarter ? -std::copysign(third_left(n1, std::abs(s), c), s) : third_folded(n1, s, c));
}

// With psi = pi/2 - phi:  1 - n sin^2 phi = n1 (1 - n' sin^2 psi), n' = (n1 - 1)/n1;  1 - m sin^2 phi = m1 (cos^2 psi +
// sin^2 psi/m1).
Wide Elliptic::third_left(Wide n1, Wide s, Wide c) const {
  const Wide x = s * s, y = x + c * c / m1_, p = x + c * c / n1;
  const Wide f = c * boost::math::ellint_rf(x, y, Wide(1));
  return (f + (n1 - 1) / (3 * n1) * c * c * c * boost::math::ellint_rj(x, y, Wide(1), p)) /
         (n1 * std::sqrt(m1_));
}

Wide Elliptic::third_folded(Wide n1, Wide s, Wide c) const {
  const Wide x = c * c, y = x + m1_ * s * s, f = s * boost::math::ellint_rf(x, y, Wide(1));
  if (n1 <= 2) {
    return f + (1 - n1) / 3 * s * s * s * boost::math::ellint_rj(x, y, Wide(1), x + n1 * s * s);
  }
  // n < -1, where the two terms above would cancel; with 1 - N = m1/n1 all terms have one sign (DLMF 19.7.9):
  // Pi(n) = m1 n/((n - 1)(m - n)) Pi(N) + m/(m - n) F
  //         + sqrt(n/((n - 1)(m - n))) atan(sqrt(-n N) sin(phi) cos(phi)/sqrt(1 - m sin^2 phi))
  const Wide m_less_n = n1 - m1_, share = (n1 - 1) / (n1 * m_less_n);
  const Wide p = std::sqrt((n1 - 1) * m_less_n / n1);
  return m1_ * share * third_folded(m1_ / n1, s, c) + (1 - m1_) / m_less_n * f +
         std::sqrt(share) * std::atan(p * s * c / std::sqrt(y));
}

}  // namespace cylon::exact
