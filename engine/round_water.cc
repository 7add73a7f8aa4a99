#include "engine/round_water.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace cylon::engine {

namespace {

constexpr Real pi = std::numbers::pi_v<Real>;
constexpr std::size_t nodes = 24;

struct Rule {
  std::array<Real, nodes> x, weight;  // on [-1, 1]
};

// The roots of Legendre's polynomial by Newton's method.  Abramowitz and Stegun, 25.4.29.
Rule gauss_legendre() {
  Rule rule;
  for (std::size_t i = 0; i < nodes; ++i) {
    double x = std::cos(std::numbers::pi * (static_cast<double>(i) + 0.75) / (nodes + 0.5)), slope = 1;
    for (int sweep = 0; sweep < 8; ++sweep) {
      double p = 1, before = 0;
      for (std::size_t n = 1; n <= nodes; ++n) {
        const auto k = static_cast<double>(n);
        const double next = ((2 * k - 1) * x * p - (k - 1) * before) / k;
        before = p, p = next;
      }
      slope = static_cast<double>(nodes) * (x * p - before) / (x * x - 1);
      x -= p / slope;
    }
    rule.x[i] = static_cast<Real>(x);
    rule.weight[i] = static_cast<Real>(2 / ((1 - x * x) * slope * slope));
  }
  return rule;
}

Real squared_radius(const RoundPiece& piece, Real y) {
  return std::max(Real(0), piece.a + y * (piece.b + y * piece.c));
}

// Where the surface cuts the axis and the rims:  q^2 = r^2 with q = (depth - y up)/across.  In the discriminant
// depth^2 up^2 drops out, which would leave rounding where the axis is nearly upright:
//   (depth up + s^2 b/2)^2 - (up^2 - s^2 c)(depth^2 - s^2 a) = s^2 (up^2 a + depth up b + depth^2 c + s^2 (b^2/4 - a c))
std::array<Real, 2> rims(const RoundPiece& p, Real depth, Real up, Real across) {
  const Real s2 = across * across;
  const Real a = up * up - s2 * p.c, half_b = -depth * up - s2 * p.b / 2, c = depth * depth - s2 * p.a;
  const Real inside = up * up * p.a + depth * (up * p.b + depth * p.c) + s2 * (p.b * p.b / 4 - p.a * p.c);
  const Real root = across * std::sqrt(std::max(Real(0), inside));
  const Real q = -(half_b + std::copysign(root, half_b));
  return {q / a, c / q};
}

}  // namespace

Submerged submerged(std::initializer_list<RoundPiece> pieces, const Vector3& position,
                    const Matrix3& rotation, Real height) {
  static const Rule rule = gauss_legendre();
  const Vector3 axis = rotation.col(1);
  const Real up = axis.y(), across = std::hypot(axis.x(), axis.z()), depth = height - position.y();
  const Vector3 climb =
      across > 0 ? Vector3((Vector3::UnitY() - up * axis) / across) : Vector3(Vector3::Zero());
  Submerged result{0, 0, position};
  Real along = 0, aside = 0;  // first moments
  for (const RoundPiece& piece : pieces) {
    const auto whole = [&](Real y) { return y * (piece.a + y * (piece.b / 2 + y * piece.c / 3)); };
    result.whole += pi * (whole(piece.to) - whole(piece.from));
    std::array<Real, 4> ends = {piece.from, piece.from, piece.to, piece.to};
    const std::array<Real, 2> cuts = rims(piece, depth, up, across);
    for (std::size_t k = 0; k < 2; ++k)
      if (cuts[k] > piece.from && cuts[k] < piece.to) ends[k + 1] = cuts[k];
    std::sort(ends.begin(), ends.end());
    for (std::size_t part = 0; part < 3; ++part) {
      const Real half = (ends[part + 1] - ends[part]) / 2, middle = ends[part] + half;
      if (!(half > 0)) continue;
      for (std::size_t i = 0; i < nodes; ++i) {
        const Real f = pi / 2 * (1 + rule.x[i]), y = middle - half * std::cos(f);
        const Real dy = rule.weight[i] * pi / 2 * half * std::sin(f);
        const Real r2 = squared_radius(piece, y), r = std::sqrt(r2), under = depth - y * up;
        if (under <= -across * r) continue;
        const bool wet = under >= across * r;
        const Real q = wet ? r : under / across, w2 = wet ? Real(0) : std::max(Real(0), r2 - q * q),
                   w = std::sqrt(w2);
        const Real area = wet ? pi * r2 : r2 * (pi - std::acos(std::clamp(q / r, Real(-1), Real(1)))) + q * w;
        result.volume += dy * area;
        along += dy * area * y;
        aside -= dy * 2 / 3 * w2 * w;
      }
    }
  }
  if (result.volume > 0) result.centroid += (along * axis + aside * climb) / result.volume;
  return result;
}

}  // namespace cylon::engine
