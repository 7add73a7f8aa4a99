#include "reference/exact/exponential.h"

#include <utility>

namespace cylon::exact {
namespace {

// exp(z) - 1 = expm1(x) cos y - 2 sin^2(y/2) + i exp(x) sin y.
WideComplex expm1(WideComplex z) {
  const Wide half = std::sin(z.imag() / 2);
  return {std::expm1(z.real()) * std::cos(z.imag()) - 2 * half * half,
          std::exp(z.real()) * std::sin(z.imag())};
}

// exp(m t) sum_n t^(n+2)/(n+2)! h_n(a - m, b - m, c - m), h_n the complete homogeneous polynomials, for
// points that lie together: |x t| <= 2 for all three of x = a - m, …
WideComplex together_difference(WideComplex a, WideComplex b, WideComplex c, Wide t) {
  const WideComplex m = (a + b + c) / Wide(3), x = (a - m) * t, y = (b - m) * t, z = (c - m) * t;
  WideComplex h1 = 1, h2 = 1, h3 = 1, sum = 0.5L;  // h_n of (x), (x, y), (x, y, z)
  Wide factorial = 2;
  for (int n = 1; n <= 40; ++n) {
    h1 *= x, h2 = h1 + y * h2, h3 = h2 + z * h3;
    factorial *= static_cast<Wide>(n + 2);
    sum += h3 / factorial;
  }
  return t * t * std::exp(m * t) * sum;
}

}  // namespace

WideComplex exponential_difference(WideComplex a, WideComplex b, Wide t) {
  if (a == b) return t * std::exp(a * t);
  if (a.real() < b.real()) std::swap(a, b);
  return -std::exp(a * t) * expm1((b - a) * t) / (a - b);
}

WideComplex exponential_difference(WideComplex a, WideComplex b, WideComplex c, Wide t) {
  // a and c the farthest two: the difference of the two-point ones then loses next to nothing.
  if (std::abs(a - b) > std::abs(a - c)) std::swap(b, c);
  if (std::abs(b - c) > std::abs(a - c)) std::swap(a, b);
  if (std::abs(a - c) * t <= 2) return together_difference(a, b, c, t);
  return (exponential_difference(a, b, t) - exponential_difference(b, c, t)) / (a - c);
}

}  // namespace cylon::exact
