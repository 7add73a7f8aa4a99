#include "engine/round_below.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace cylon::engine {
namespace {

// The axis of a shape, and the direction across it that rises the most:  y-axis = rise axis + across steepest.
struct Inclined {
  Vector3 axis, steepest;
  Real rise, across;

  explicit Inclined(const Vector3& u) : axis(u), rise(u.y()), across(std::hypot(u.x(), u.z())) {
    steepest = across > 0 ? Vector3(-rise * u.x() / across, across, -rise * u.z() / across)
                          : Vector3(Vector3::UnitX());
  }
};

// Nodes and weights in (-1, 1) by tanh-sinh quadrature, which converges whatever root the integrand has at an end, and
// however near to one it has a pole.  H. Takahasi, M. Mori, Publ. RIMS 9 (1974) 721.
//   x = tanh(pi/2 sinh t),  w = dt pi/2 cosh t/cosh^2(pi/2 sinh t)
constexpr int nodes_aside = 38;
using Rule = std::array<std::array<Real, 2>, std::size_t{2} * nodes_aside + 1>;

const Rule& rule() {
  static const Rule made = [] {
    constexpr double dt = 1. / 12;
    Rule r;
    for (int k = -nodes_aside; k <= nodes_aside; ++k) {
      const double t = k * dt, s = M_PI / 2 * std::sinh(t), c = std::cosh(s);
      r[static_cast<std::size_t>(k + nodes_aside)] = {
          static_cast<Real>(std::tanh(s)), static_cast<Real>(dt * M_PI / 2 * std::cosh(t) / (c * c))};
    }
    return r;
  }();
  return made;
}

// Over each of the parts between the ends, in ascending order.
template <std::size_t n, class Use>
void integrate(std::array<Real, n> ends, const Use& use) {
  std::sort(ends.begin(), ends.end());
  for (std::size_t i = 0; i + 1 < n; ++i) {
    const Real middle = (ends[i] + ends[i + 1]) / 2, half = (ends[i + 1] - ends[i]) / 2;
    if (!(half > 0)) continue;
    for (const auto& [x, w] : rule()) use(middle + half * x, half * w);
  }
}

// Of a disc of radius r what has q <= d, along a direction in it from its centre, with `most` = d across and the
// direction rising by `across`:  area = r^2 (pi/2 + asin(d/r)) + d sqrt(r^2 - d^2),  moment along q = -2/3 (r^2 - d^2)^(3/2)
struct Segment {
  Real area = 0, moment = 0;

  Segment(Real r, Real most, Real across) {
    if (most >= r * across) area = pi * r * r;
    if (most >= r * across || most <= -r * across) return;
    const Real d = most / across, half = std::sqrt(std::max(Real(0), (r - d) * (r + d)));
    area = r * r * (pi / 2 + std::asin(std::clamp(d / r, Real(-1), Real(1)))) + d * half;
    moment = Real(-2) / 3 * half * half * half;
  }
};

// Gauss's theorem from the point P of the plane above the origin, for which the face that the plane opens adds nothing:
//   V = 1/3 sum int (x - P).N,   int x = P V + 1/4 sum int (x - P) (x - P).N
// over what lies below of the discs and of the side, which is made of straight lines, s in [0, 1] at each angle phi:
//   x = (low + s L) u + r(s) e(phi),  r = r_1 + s D,  N = r (L e - D u),  and with c = e.steepest = cos phi
//   (x - P).N = r(s) (L r_1 - D (low - H rise) - L H across c)
// Of each line the part below ends where its height, linear in s, is H.
class FrustumBelow {
 public:
  FrustumBelow(const Frustum& shape, const Vector3& axis, Real height)
      : f_(shape), at_(axis), height_(height) {
    add_disc(f_.low, f_.low_radius, -1);
    add_disc(f_.high, f_.high_radius, 1);
    // Between the angles at which a rim goes under, lines are whole, dry or cut on one side throughout.
    const auto angle = [&](Real y, Real r) {
      const Real most = height_ - y * at_.rise;
      return std::abs(most) < r * at_.across ? std::acos(most / (r * at_.across)) : Real(0);
    };
    integrate(std::array<Real, 4>{0, angle(f_.low, f_.low_radius), angle(f_.high, f_.high_radius), pi},
              [&](Real phi, Real weight) { add_line(std::cos(phi), 2 * weight); });
  }

  RoundBelow result() const {
    const Vector3 seen = along_ * at_.axis + aside_ * at_.steepest;
    return {volume_, Vector3(seen + volume_ * height_ * Vector3::UnitY())};
  }

 private:
  Real p_along() const { return height_ * at_.rise; }
  Real p_aside() const { return height_ * at_.across; }

  void add_disc(Real y, Real radius, Real side) {
    const Segment part(radius, height_ - y * at_.rise, at_.across);
    const Real reach = y - p_along(), flux = side * reach;
    volume_ += flux * part.area / 3;
    along_ += flux * reach * part.area / 4;
    aside_ += flux * (part.moment - p_aside() * part.area) / 4;
  }

  // int r ds, int r s ds, int r^2 ds over the part of length w about m.
  void add_line(Real c, Real weight) {
    const Real d = f_.high_radius - f_.low_radius, length = f_.high - f_.low;
    const Real low = f_.low * at_.rise + f_.low_radius * at_.across * c - height_;
    const Real high = f_.high * at_.rise + f_.high_radius * at_.across * c - height_;
    Real from = 0, to = 1;
    if (low > 0 && high > 0) return;
    if (low > 0) from = low / (low - high);
    if (high > 0) to = low / (low - high);
    const Real w = to - from, m = (from + to) / 2, r = f_.low_radius + m * d;
    const Real of_r = w * r, of_rs = w * (r * m + d * w * w / 12), of_rr = w * (r * r + d * d * w * w / 12);
    const Real flux = weight * (length * f_.low_radius - d * (f_.low - p_along()) - length * p_aside() * c);
    volume_ += flux * of_r / 3;
    along_ += flux * ((f_.low - p_along()) * of_r + length * of_rs) / 4;
    aside_ += flux * (c * of_rr - p_aside() * of_r) / 4;
  }

  const Frustum& f_;
  Inclined at_;
  Real height_, volume_ = 0, along_ = 0, aside_ = 0;  // moments from P
};

// Half a ball about `centre`, the half along `side` of the axis, in level slices: each is a disc of radius rho cut by the
// plane across the axis, which rises along q by side across where the slice's height above the centre is y:
//   side (rise y + across q) >= 0
RoundBelow half_ball_below(Real r, const Inclined& at, Real side, const Vector3& centre, Real height) {
  const Real rise = side * at.rise, top = std::clamp(height - centre.y(), -r, r);
  const Vector3 out = at.across > 0 ? Vector3(side * Vector3(at.axis.x(), 0, at.axis.z()) / at.across)
                                    : Vector3(Vector3::UnitX());
  const Real edge = r * at.across;  // beyond it slices are whole or none
  RoundBelow sum;
  integrate(std::array<Real, 4>{-r, std::clamp(-edge, -r, top), std::clamp(edge, -r, top), top},
            [&](Real y, Real weight) {
              const Segment part(std::sqrt(std::max(Real(0), (r - y) * (r + y))), rise * y, at.across);
              sum.volume += weight * part.area;
              sum.moment += weight * (part.area * y * Vector3::UnitY() - part.moment * out);
            });
  sum.moment += sum.volume * centre;
  return sum;
}

}  // namespace

//  V = pi L (r_1^2 + r_1 r_2 + r_2^2)/3,  pi r^2 (2 h) + 4/3 pi r^3
Real whole_volume(const Frustum& f) {
  const Real a = f.low_radius, b = f.high_radius;
  return pi * (f.high - f.low) * (a * a + a * b + b * b) / 3;
}
Real whole_volume(const Capsule& s) {
  return pi * s.radius * s.radius * (2 * s.half_length + Real(4) / 3 * s.radius);
}

// All of it:  the moment along the axis is int pi r^2 y = V low + pi L^2 (r_1^2 + 2 r_1 r_2 + 3 r_2^2)/12.
RoundBelow round_below(const Frustum& f, const Vector3& axis, Real height) {
  const Inclined at(axis);
  const Real low = f.low * at.rise, high = f.high * at.rise;
  if (height <= std::min(low - f.low_radius * at.across, high - f.high_radius * at.across)) return {};
  if (height >= std::max(low + f.low_radius * at.across, high + f.high_radius * at.across)) {
    const Real a = f.low_radius, b = f.high_radius, length = f.high - f.low, volume = whole_volume(f);
    const Real along = volume * f.low + pi * length * length * (a * a + 2 * a * b + 3 * b * b) / 12;
    return {volume, Vector3(along * axis)};
  }
  return FrustumBelow(f, axis, height).result();
}

RoundBelow round_below(const Capsule& s, const Vector3& axis, Real height) {
  const Real reach = std::abs(axis.y()) * s.half_length + s.radius;
  if (height <= -reach) return {};
  if (height >= reach) return {whole_volume(s), Vector3::Zero()};
  const Inclined at(axis);
  RoundBelow sum;
  const auto add = [&](const RoundBelow& part) { sum.volume += part.volume, sum.moment += part.moment; };
  if (s.half_length > 0)
    add(round_below(Frustum{s.radius, s.radius, -s.half_length, s.half_length}, axis, height));
  for (const Real side : {Real(-1), Real(1)})
    add(half_ball_below(s.radius, at, side, side * s.half_length * axis, height));
  return sum;
}

}  // namespace cylon::engine
