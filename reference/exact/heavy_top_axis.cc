#include "reference/exact/heavy_top_axis.h"

#include "reference/exact/turning.h"

#include <algorithm>
#include <array>

namespace cylon::exact {
namespace {

// Distance x of a turning point from a pole that the axis passes closely: the small root of
// (2 - x) x (V + beta x) = (c + a x)^2, with V at the pole and c the sum of the pole.  A difference of
// cosines has lost its digits there.  c = 0: the axis passes through the pole itself.
Wide polish(Wide x, Wide v, Wide beta, Wide c, Wide a) {
  if (c == 0) return 0;
  for (int i = 0; i < 20; ++i) {
    const Wide f = (2 - x) * x * (v + beta * x) - (c + a * x) * (c + a * x);
    const Wide slope = (2 - 2 * x) * (v + beta * x) + (2 - x) * x * beta - 2 * a * (c + a * x);
    const Wide next = std::max(x - f / slope, x / 16);
    if (!std::isfinite(next) || next == x) break;
    x = next;
  }
  return x;
}

}  // namespace

HeavyTopAxis::HeavyTopAxis(const AxisStart& s) : a_(s.a) {
  // With e = d - up or d + up, whichever is short: u0' = up.d' and up.(d x d') without the digits that
  // cancel.
  const Wide side = s.up.dot(s.direction) > 0 ? -1 : 1;
  WideVector e = side * s.direction + s.up;
  // 1 -+ u0, from halves of squares.  Next to a pole e is as short as what both vectors lack of length one, which would
  // belong to no motion: there it is what is across the axis,  1 - |cos| = |e|^2/(1 + |cos|).
  Wide near = e.squaredNorm() / 2, far = (s.up - side * s.direction).squaredNorm() / 2;
  if (near < Wide(0.01)) {
    e -= e.dot(s.direction) * s.direction;
    near = e.squaredNorm() / (1 + std::sqrt(1 - e.squaredNorm()));
    far = 2 - near;
  }
  find_turning_points(s, e.dot(s.rate), e.dot(s.direction.cross(s.rate)), side < 0 ? near : far,
                      side < 0 ? far : near);
}

// tilt = u0', turn = sin^2(theta0) phi0' = b - a u0,  w0 and y0 = 1 -+ u0.
void HeavyTopAxis::find_turning_points(const AxisStart& s, Wide tilt, Wide turn, Wide w0, Wide y0) {
  const Wide u0 = s.up.dot(s.direction), v0 = s.rate.squaredNorm(), beta = s.beta;
  // Through a pole, or past it by an angle c/sqrt(V) below 1e-16, V and c at the pole.  (With b = a and V(1) < 0 it is
  // u3 that is 1.)
  const Wide v_above = v0 - beta * w0, v_below = v0 + beta * y0;
  const bool through_above = v_above > 0 && std::abs(turn - a_ * w0) <= 1e-16L * std::sqrt(v_above);
  const bool through_below = std::abs(turn + a_ * y0) <= 1e-16L * std::sqrt(v_below);
  const bool vertical = std::min(w0, y0) <= 1e-33L && v0 <= 1e-33L * beta;

  // f about u0.
  const std::array<Wide, 4> f = {tilt * tilt, -beta * w0 * y0 - 2 * u0 * v0 + 2 * a_ * turn,
                                 2 * beta * u0 - v0 - a_ * a_, beta};
  auto [down, up] = turning_points(f, -y0, w0);
  // u3 - u0 from the sum of the roots, or from the sum of their products, where less cancels: next to a sleeping top
  // u2 and u3 are both next to u0.
  const Wide terms = beta * w0 * y0 + 2 * std::abs(u0) * v0 + 2 * std::abs(a_ * turn), both = down + up;
  const bool by_sum =
      (terms / beta + std::abs(down * up)) >= std::abs(both) * (std::abs(f[2] / beta) + std::abs(both));
  const Wide top = by_sum ? -f[2] / beta - both : (f[1] / beta - down * up) / both;
  above_ = {.at_first = w0 - down, .at_second = w0 - up, .sum = turn - a_ * w0};
  below_ = {.at_first = y0 + down, .at_second = y0 + up, .sum = turn + a_ * y0};
  if (vertical) {
    at_rest_ = true;
    down = up = 0;
    above_ = {w0, w0, 0}, below_ = {y0, y0, 0};
    return;
  }
  if (through_above) above_.sum = 0;
  if (through_below) below_.sum = 0;
  // Only where the difference did cancel: elsewhere it is exact enough, and next to a double root (steady
  // precession near a pole) Newton's method would be worse.
  if (through_above || (up != 0 && above_.at_second < std::min(1e-6L, w0 / 8))) {
    above_.at_second = polish(above_.at_second, v_above, beta, above_.sum, a_);
  }
  if (through_below || (down != 0 && below_.at_first < std::min(1e-6L, y0 / 8))) {
    below_.at_first = polish(below_.at_first, v_below, -beta, below_.sum, -a_);
  }

  const Wide width = up - down, m1 = (top - up) / (top - down);
  // A near-double root far from the start (by `up`) keeps 1e-19 (up/m1)^2 of its separation: refused where
  // that would outgrow the rounding of the scene's own numbers.
  if (!(m1 > std::max(1e-24L, 1e-4L * up))) return;
  elliptic_.emplace(width / (top - down), m1);
  rate_ = std::sqrt(beta * (top - down)) / 2;
  // sn^2 : cn^2 = u0 - u1 : u2 - u0, and u' has the sign of sn cn.
  const Wide sine = width == 0 ? 0 : std::copysign(std::sqrt(-down), tilt),
             cosine = width == 0 ? 1 : std::sqrt(up);
  start_ = elliptic_->first(elliptic_->towards(sine, cosine));
  const Amplitude am0 = elliptic_->at(start_);  // to the last bit: next to a pole the integrals feel it
  start_minus_ = integral(above_, am0);
  start_plus_ = integral(below_, am0);
}

// sum/2 int dt/(first cn^2 + second sn^2) = sum/(2 lam first) Pi(n; am), 1 - n = second/first.
Wide HeavyTopAxis::integral(const Pole& pole, const Amplitude& am) const {
  return pole.sum == 0
             ? 0
             : pole.sum / (2 * rate_ * pole.at_first) * elliptic_->third(pole.at_second / pole.at_first, am);
}

AxisState HeavyTopAxis::at(Wide t) const {
  AxisState s = {};
  if (at_rest_) {
    s.sine = std::sqrt(above_.at_first / 2), s.cosine = std::sqrt(below_.at_first / 2);
    (s.cosine > s.sine ? s.plus : s.minus) = (s.cosine > s.sine ? a_ : -a_) * t / 2;
    return s;
  }
  const Amplitude am = elliptic_->at(rate_ * t + start_);
  const Wide sn = am.sn, cn = am.cn, dn = am.dn;
  const Wide width = above_.at_first - above_.at_second;
  const Wide tilt = 2 * width * rate_ * sn * cn * dn;  // u'

  // S^2 = (1 - u)/2, C^2 = (1 + u)/2, and S', C' from them.
  Wide sine_rate = 0, cosine_rate = 0;
  if (above_.sum == 0 && above_.at_second == 0) {
    const Wide first = std::sqrt(above_.at_first / 2);
    s.sine = first * cn, sine_rate = -first * rate_ * sn * dn;
  } else {
    s.sine = std::sqrt((above_.at_first * cn * cn + above_.at_second * sn * sn) / 2),
    sine_rate = -tilt / (4 * s.sine);
  }
  if (below_.sum == 0 && below_.at_first == 0) {
    const Wide second = std::sqrt(below_.at_second / 2);
    s.cosine = second * sn, cosine_rate = second * rate_ * cn * dn;
  } else {
    s.cosine = std::sqrt((below_.at_first * cn * cn + below_.at_second * sn * sn) / 2);
    cosine_rate = tilt / (4 * s.cosine);
  }

  // theta' = 2 S'/C = -2 C'/S;  phi' sin(theta) = (b - a u)/(2 S C), b - a u = b - a + 2 a S^2 = b + a - 2 a
  // C^2.
  if (std::abs(s.cosine) > std::abs(s.sine)) {
    s.tilt_rate = 2 * sine_rate / s.cosine;
    s.azimuth_rate = (above_.sum == 0 ? 0 : above_.sum / (2 * s.sine * s.cosine)) + a_ * s.sine / s.cosine;
  } else {
    s.tilt_rate = -2 * cosine_rate / s.sine;
    s.azimuth_rate = (below_.sum == 0 ? 0 : below_.sum / (2 * s.sine * s.cosine)) - a_ * s.cosine / s.sine;
  }
  s.minus = integral(above_, am) - start_minus_;
  s.plus = integral(below_, am) - start_plus_;
  return s;
}

}  // namespace cylon::exact
