#include "reference/applied/revolved.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::applied {
namespace {

using core::Vector3;
constexpr double pi = std::numbers::pi;

// Shows nodes x in (low, high) and their weights: tanh-sinh quadrature, which converges whatever root the
// integrand has at its ends.  H. Takahasi, M. Mori, Publ. RIMS 9 (1974) 721.
template <class Use>
void quadrature(double low, double high, const Use& use) {
  constexpr double step = 1.0 / 16;
  constexpr int last = 51;  // the weight there is below 1e-16
  for (int k = -last; k <= last; ++k) {
    const double t = k * step, u = pi / 2 * std::sinh(t);
    const double weight = step * pi / 2 * std::cosh(t) / (std::cosh(u) * std::cosh(u));
    use((low + high) / 2 + (high - low) / 2 * std::tanh(u), (high - low) / 2 * weight);
  }
}

// Where the surface cuts the rims of the circles at s:  (height - s rise)^2 = across^2 radius(s)^2, that is a + 2 b s + c s^2 = 0
//   a = across^2 c0 - height^2,  b = across^2 c1/2 + height rise,  c = across^2 c2 - rise^2
// In b^2 - a c the terms height^2 rise^2 cancel, and rounding would be left of the rest where the axis is nearly upright:
//   b^2 - a c = across^2 (rise^2 c0 + height rise c1 + height^2 c2 + across^2 (c1^2/4 - c0 c2))
std::vector<double> rims(const Revolved& solid, double height, double rise, double across) {
  const double across2 = across * across;
  const double a = solid.c0 * across2 - height * height, b = solid.c1 * across2 / 2 + height * rise,
               c = solid.c2 * across2 - rise * rise;
  const double inside = rise * (rise * solid.c0 + height * solid.c1) + height * height * solid.c2 +
                        across2 * (solid.c1 * solid.c1 / 4 - solid.c0 * solid.c2);
  if (inside < 0) return {};
  const double q = -(b + std::copysign(across * std::sqrt(inside), b));
  std::vector<double> roots;
  if (c != 0) roots.push_back(q / c);
  if (q != 0) roots.push_back(a / q);
  return roots;
}

}  // namespace

std::vector<Revolved> revolved(const core::Capsule& s) {
  const double r = s.radius, h = s.length / 2;
  return {
      {-h - r, -h, r * r - h * h, -2 * h, -1}, {-h, h, r * r, 0, 0}, {h, h + r, r * r - h * h, 2 * h, -1}};
}

std::vector<Revolved> revolved(const core::Cylinder& s) {
  return {{-s.length / 2, s.length / 2, s.radius * s.radius, 0, 0}};
}

// radius = r (tip - s)/length, the tip at 3/4 of the length
std::vector<Revolved> revolved(const core::Cone& s) {
  const double slope = s.radius / s.length, tip = 0.75 * s.length;
  return {{-s.length / 4, tip, slope * slope * tip * tip, -2 * slope * slope * tip, slope * slope}};
}

// The circle at s lies below the plane where  q <= d = (height - s axis.y)/across  along the steepest direction
// in it, which rises by `across`:
//   area = r^2 (pi/2 + asin(d/r)) + d sqrt(r^2 - d^2),   its moment along q = -2/3 (r^2 - d^2)^(3/2)
RevolvedBelow below(const Revolved& solid, const Vector3& axis, double height) {
  const double rise = axis.y(), across = std::hypot(axis.x(), axis.z());
  const Vector3 steepest = across > 0 ? Vector3((Vector3::UnitY() - rise * axis) / across) : Vector3::Zero();
  // Between these the circles are whole, cut or dry throughout.
  std::vector<double> ends = rims(solid, height, rise, across);
  if (rise != 0) ends.push_back(height / rise);
  for (double& end : ends) end = std::clamp(end, solid.low, solid.high);
  ends.insert(ends.end(), {solid.low, solid.high});
  std::ranges::sort(ends);
  RevolvedBelow sum;
  for (std::size_t i = 1; i < ends.size(); ++i) {
    if (!(ends[i] > ends[i - 1])) continue;
    quadrature(ends[i - 1], ends[i], [&](double s, double weight) {
      const double r2 = std::max(0.0, solid.c0 + s * (solid.c1 + s * solid.c2)), r = std::sqrt(r2);
      const double depth = height - s * rise;  // d across
      if (depth <= -r * across) return;
      double area = pi * r2, moment = 0;
      if (depth < r * across) {
        const double d = depth / across, half = std::sqrt(std::max(0.0, r2 - d * d));
        area = r2 * (pi / 2 + std::asin(std::clamp(d / r, -1.0, 1.0))) + d * half;
        moment = -2.0 / 3 * half * half * half;
      }
      sum.volume += weight * area;
      sum.moment += weight * (area * s * axis + moment * steepest);
    });
  }
  return sum;
}

}  // namespace cylon::applied
