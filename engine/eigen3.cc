#include "engine/eigen3.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>
#include <utility>

namespace cylon::engine {

namespace {

using Numbers = std::array<Real, 3>;
using Columns = std::array<Numbers, 3>;  // [column][row]

constexpr Real epsilon = std::numeric_limits<Real>::epsilon();
constexpr Real same = 8 * epsilon;          // relative: the rounding of R D R^T
constexpr Real tie = Real(0.000244140625);  // 2^-12: components nearer than this are equally great
constexpr int most_sweeps = 16;             // quadratic convergence: five are enough for any 3 x 3

// The upper triangle of A; a(p, q) with p < q is the only copy of both.
struct Symmetric {
  Numbers diagonal;
  Numbers off;  // off[r]: the entry between the two indices other than r

  Real& between(int p, int q) { return off[static_cast<std::size_t>(3 - p - q)]; }
};

// What lies between p and q is rounding.  |a_pq| <= eps sqrt(|a_pp a_qq|), which keeps the digits of small
// moments beside great ones: J. Demmel, K. Veselic, Jacobi's method is more accurate than QR, SIAM J. Matrix
// Anal. 13 (1992) 1204, section 3.  A moment that is none is known to rounding of the greatest only.
bool negligible(Real between, Real p, Real q, Real scale) {
  const Real x = std::abs(between);
  return x <= epsilon * std::sqrt(std::abs(p)) * std::sqrt(std::abs(q)) || x <= epsilon * epsilon * scale;
}

//   theta = (a_qq - a_pp)/2a_pq,  t = sgn(theta)/(|theta| + sqrt(theta^2 + 1)),  c = 1/sqrt(t^2 + 1),  s = t
//   c a_pp -= t a_pq,  a_qq += t a_pq,  a_pq = 0;  the third row and V are turned by (c, s).
// Golub & Van Loan, eq. (8.5.1), (8.5.2), written as corrections so that small turns lose no digits.
void rotate(Symmetric& a, Columns& axes, int p, int q) {
  const auto at = [](int i) { return static_cast<std::size_t>(i); };
  const Real x = a.between(p, q);
  const Real theta = (a.diagonal[at(q)] - a.diagonal[at(p)]) / (2 * x);
  // beyond 1/eps theta^2 + 1 is theta^2, which would overflow
  const Real size = std::abs(theta);
  const Real root = size > 1 / epsilon ? size : std::sqrt(theta * theta + 1);
  const Real t = (theta < 0 ? Real(-1) : Real(1)) / (size + root);
  const Real c = 1 / std::sqrt(t * t + 1), s = t * c, tau = s / (1 + c);
  a.diagonal[at(p)] -= t * x;
  a.diagonal[at(q)] += t * x;
  a.between(p, q) = 0;
  const int r = 3 - p - q;
  const Real f = a.between(p, r), g = a.between(q, r);
  a.between(p, r) = f - s * (g + tau * f);
  a.between(q, r) = g + s * (f - tau * g);
  for (std::size_t i = 0; i < 3; ++i) {
    const Real u = axes[at(p)][i], v = axes[at(q)][i];
    axes[at(p)][i] = u - s * (v + tau * u);
    axes[at(q)][i] = v + s * (u - tau * v);
  }
}

void diagonalise(Symmetric& a, Columns& axes, Real scale) {
  constexpr std::pair<int, int> pairs[] = {{0, 1}, {0, 2}, {1, 2}};
  for (int sweep = 0; sweep < most_sweeps; ++sweep) {
    bool done = true;
    for (const auto& [p, q] : pairs) {
      const Real x = a.between(p, q);
      if (negligible(x, a.diagonal[static_cast<std::size_t>(p)], a.diagonal[static_cast<std::size_t>(q)],
                     scale))
        continue;
      rotate(a, axes, p, q);
      done = false;
    }
    if (done) return;
  }
}

// The index of the greatest component, the first of those that are as great.
std::size_t greatest(const Numbers& v) {
  Real most = 0;
  for (const Real x : v) most = std::max(most, std::abs(x));
  std::size_t k = 0;
  while (std::abs(v[k]) < most * (1 - tie)) ++k;
  return k;
}

void point_forward(Numbers& axis) {
  if (axis[greatest(axis)] > 0) return;
  for (Real& x : axis) x = x == 0 ? Real(0) : -x;
}

Numbers normalised(const Numbers& v) {
  const Real length = std::sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
  return {v[0] / length, v[1] / length, v[2] / length};
}

// The frame's axes other than k, turned as e_k is into n:  e_i - n_i/(1 + n_k) (e_k + n),  n_k > 0.
std::pair<Numbers, Numbers> carried(const Numbers& n) {
  const std::size_t k = greatest(n);
  const auto image = [&](std::size_t i) {
    const Real factor = n[i] / (1 + n[k]);
    Numbers e{};
    e[i] = 1;
    for (std::size_t j = 0; j < 3; ++j) e[j] -= factor * (n[j] + (j == k ? Real(1) : Real(0)));
    return e;
  };
  const std::size_t first = k == 0 ? 1 : 0, second = k == 2 ? 1 : 2;
  return {image(first), image(second)};
}

Real determinant(const Columns& v) {
  return v[0][0] * (v[1][1] * v[2][2] - v[1][2] * v[2][1]) -
         v[0][1] * (v[1][0] * v[2][2] - v[1][2] * v[2][0]) +
         v[0][2] * (v[1][0] * v[2][1] - v[1][1] * v[2][0]);
}

bool equal(Real lesser, Real greater) { return greater - lesser <= same * std::abs(greater); }

// Makes one of what only rounding tells apart, and gives the axes that convention asks for.
void settle(Numbers& moments, Columns& axes) {
  for (Numbers& axis : axes) {
    axis = normalised(axis);
    point_forward(axis);
  }
  const bool low = equal(moments[0], moments[1]), high = equal(moments[1], moments[2]);
  if (low && high) {
    moments.fill(moments[0] + ((moments[1] - moments[0]) + (moments[2] - moments[0])) / 3);
    axes = Columns{Numbers{1, 0, 0}, Numbers{0, 1, 0}, Numbers{0, 0, 1}};
  } else if (low) {
    moments[0] = moments[1] = moments[0] + (moments[1] - moments[0]) / 2;
    std::tie(axes[0], axes[1]) = carried(axes[2]);
    if (determinant(axes) < 0) std::swap(axes[0], axes[1]);
  } else if (high) {
    moments[1] = moments[2] = moments[1] + (moments[2] - moments[1]) / 2;
    std::tie(axes[1], axes[2]) = carried(axes[0]);
    if (determinant(axes) < 0) std::swap(axes[1], axes[2]);
  } else if (determinant(axes) < 0) {
    for (Real& x : axes[2]) x = x == 0 ? Real(0) : -x;
  }
}

}  // namespace

Principal principal(const Matrix3& symmetric) {
  Symmetric a{{symmetric(0, 0), symmetric(1, 1), symmetric(2, 2)},
              {symmetric(1, 2), symmetric(0, 2), symmetric(0, 1)}};
  // A power of two takes the size out without rounding, so that no square leaves the range.
  Real greatest_entry = 0;
  for (std::size_t i = 0; i < 3; ++i)
    greatest_entry = std::max({greatest_entry, std::abs(a.diagonal[i]), std::abs(a.off[i])});
  if (!(greatest_entry > 0)) return {};
  int exponent = 0;
  std::frexp(greatest_entry, &exponent);
  for (Numbers* part : {&a.diagonal, &a.off})
    for (Real& x : *part) x = std::ldexp(x, -exponent);

  Columns axes{Numbers{1, 0, 0}, Numbers{0, 1, 0}, Numbers{0, 0, 1}};
  diagonalise(a, axes, 1);

  std::array<std::size_t, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t i, std::size_t j) { return a.diagonal[i] < a.diagonal[j]; });
  Numbers moments = {a.diagonal[order[0]], a.diagonal[order[1]], a.diagonal[order[2]]};
  Columns sorted = {axes[order[0]], axes[order[1]], axes[order[2]]};
  settle(moments, sorted);

  Principal result;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.moments[i] = std::ldexp(moments[k], exponent);
    result.axes.col(i) = Vector3(sorted[k][0], sorted[k][1], sorted[k][2]);
  }
  return result;
}

}  // namespace cylon::engine
