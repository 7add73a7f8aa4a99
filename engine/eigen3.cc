#include "engine/eigen3.h"

#include "engine/jacobi.h"

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

constexpr Real same_eigenvalue = 8 * epsilon;  // relative: the rounding of R D R^T
constexpr Real tie = Real(0.000244140625);     // 2^-12: components nearer than this are equally great

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

bool equal(Real lesser, Real greater) { return greater - lesser <= same_eigenvalue * std::abs(greater); }

// Makes one of what only rounding tells apart, and gives the axes that convention asks for.
void canonicalise(Numbers& moments, Columns& axes) {
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
  Matrix3 a = Matrix3::Zero();
  Real greatest_entry = 0;
  for (int q = 0; q < 3; ++q) {
    for (int p = 0; p <= q; ++p)
      greatest_entry = std::max(greatest_entry, std::abs(a(p, q) = symmetric(p, q)));
  }
  if (!(greatest_entry > 0)) return {};
  // A power of two takes the size out without rounding, so that no square leaves the range.
  int exponent = 0;
  std::frexp(greatest_entry, &exponent);
  for (int q = 0; q < 3; ++q) {
    for (int p = 0; p <= q; ++p) a(p, q) = std::ldexp(a(p, q), -exponent);
  }
  Matrix3 axes;
  diagonalise(a, axes);

  std::array<int, 3> order = {0, 1, 2};
  std::stable_sort(order.begin(), order.end(), [&](int i, int j) { return a(i, i) < a(j, j); });
  Numbers moments{};
  Columns sorted{};
  for (std::size_t k = 0; k < 3; ++k) {
    moments[k] = a(order[k], order[k]);
    for (int i = 0; i < 3; ++i) sorted[k][static_cast<std::size_t>(i)] = axes(i, order[k]);
  }
  canonicalise(moments, sorted);

  Principal result;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    result.moments[i] = std::ldexp(moments[k], exponent);
    result.axes.col(i) = Vector3(sorted[k][0], sorted[k][1], sorted[k][2]);
  }
  return result;
}

}  // namespace cylon::engine
