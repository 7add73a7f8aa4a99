#include "engine/elliptic.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::engine {

namespace {

// R_C(1, 1 + e) = atan(sqrt e)/sqrt e, e >= 0; where atan gives its argument back, 1 - e/3 + e^2/5 - ...
double carlson_rc1(double e) {
  if (e < 1e-3) return 1 - e * (1.0 / 3 - e * (1.0 / 5 - e * (1.0 / 7 - e * (1.0 / 9 - e / 11))));
  const double root = std::sqrt(e);
  return std::atan(root) / root;
}

}  // namespace

double carlson_rf(double x, double y, double z) {
  // The duplication brings x, y, z together by 4 a round; the series' first term left out is of order 6,
  // below 3e-16 from here on.
  constexpr double close = 2.7e-3;
  double a = (x + y + z) / 3;
  while (std::max({std::abs(a - x), std::abs(a - y), std::abs(a - z)}) > close * a) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z);
    const double lambda = rx * (ry + rz) + ry * rz;
    x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4, a = (a + lambda) / 4;
  }
  const double dx = 1 - x / a, dy = 1 - y / a, dz = -dx - dy;
  const double e2 = dx * dy - dz * dz, e3 = dx * dy * dz;
  return (1 - e2 / 10 + e3 / 14 + e2 * e2 / 24 - 3 * e2 * e3 / 44) / std::sqrt(a);
}

double carlson_rj(double x, double y, double z, double p) {
  constexpr double close = 1.5e-3;  // as above; the series' coefficients are larger
  double a = (x + y + z + 2 * p) / 5;
  double delta = (p - x) * (p - y) * (p - z), scale = 1, sum = 0;
  while (std::max({std::abs(a - x), std::abs(a - y), std::abs(a - z), std::abs(a - p)}) > close * a) {
    const double rx = std::sqrt(x), ry = std::sqrt(y), rz = std::sqrt(z), rp = std::sqrt(p);
    const double lambda = rx * (ry + rz) + ry * rz;
    const double d = (rp + rx) * (rp + ry) * (rp + rz);
    sum += scale / d * carlson_rc1(delta / (d * d));
    x = (x + lambda) / 4, y = (y + lambda) / 4, z = (z + lambda) / 4, p = (p + lambda) / 4;
    a = (a + lambda) / 4;
    scale /= 4, delta /= 64;
  }
  const double dx = 1 - x / a, dy = 1 - y / a, dz = 1 - z / a, dp = -(dx + dy + dz) / 2;
  const double xyz = dx * dy * dz, e2 = dx * dy + dx * dz + dy * dz - 3 * dp * dp;
  const double e3 = xyz + 2 * e2 * dp + 4 * dp * dp * dp;
  const double e4 = (2 * xyz + e2 * dp + 3 * dp * dp * dp) * dp, e5 = xyz * dp * dp;
  const double series =
      1 - 3 * e2 / 14 + e3 / 6 + 9 * e2 * e2 / 88 - 3 * e4 / 22 - 9 * e2 * e3 / 52 + 3 * e5 / 26;
  return scale * series / (a * std::sqrt(a)) + 6 * sum;
}

// The mean of 1 and 1e-20, the least that there is, takes 9 rounds: the first log2(ln 1e20) bring the two together, from
// there each squares the difference.  `most` is 16.
Jacobi::Jacobi(double complement) : complement_(std::clamp(complement, 1e-40, 1.0)) {
  double a = 1, b = std::sqrt(complement_);
  while (true) {
    a_[static_cast<std::size_t>(length_)] = a;
    b_[static_cast<std::size_t>(length_)] = b;
    ++length_;
    limit_ = (a + b) / 2;
    if (std::abs(a - b) <= 1e-8 * a || length_ == most) break;  // the next difference is its square
    b = std::sqrt(a * b);
    a = limit_;
  }
  quarter_period_ = std::numbers::pi / (2 * limit_);
}

JacobiValues Jacobi::operator()(double u) const {
  const double sine = std::sin(limit_ * u), cosine = std::cos(limit_ * u);
  if (sine == 0) return {sine, 1, 1};
  double c = limit_ * cosine / sine, a = cosine / sine, dn = 1;
  for (int i = length_; i-- > 0;) {
    const double mean = a_[static_cast<std::size_t>(i)];
    a *= c;
    c *= dn;
    dn = (b_[static_cast<std::size_t>(i)] + a) / (mean + a);
    a = c / mean;
  }
  const double sn = std::copysign(1 / std::sqrt(c * c + 1), sine);
  return {sn, c * sn, dn};
}

}  // namespace cylon::engine
