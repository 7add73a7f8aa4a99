// Arithmetic of Taylor coefficients in balls of two doubles.
#pragma once

#include "reference/certified/bounds.h"

#include <cmath>
#include <limits>

namespace cylon::certified {

/// A sum of products of balls and its rounding: of n terms at most n + 2 roundings touch each.
class Sum {
 public:
  /// + sign sum_j a_j b_(k-j) for j = first … last.
  void add(double sign, const double* am, const double* ar, const double* bm, const double* br, int k,
           int first, int last) {
    double middle = 0, blur = 0, size = 0;
    for (int j = first; j <= last; ++j) {
      const double p = am[j] * bm[k - j];
      middle += p;
      size += std::abs(p);
      blur += std::abs(am[j]) * br[k - j] + ar[j] * (std::abs(bm[k - j]) + br[k - j]);
    }
    if (last < first) return;
    terms_ += last - first + 1;
    middle_ += sign * middle, size_ += size, blur_ += blur;
  }
  void add(double sign, double middle, double radius) {
    ++terms_;
    middle_ += sign * middle, size_ += std::abs(middle), blur_ += radius;
  }
  Near result() const { return {middle_, above(blur_ + size_ * 0x1p-52 * (terms_ + 2))}; }

 private:
  double middle_ = 0, blur_ = 0, size_ = 0;
  int terms_ = 0;
};

/// n/d: |n/d - n_m/d_m| <= (n_r + |n_m/d_m| d_r)/(|d_m| - d_r); all numbers where d may vanish.
inline Near quotient(const Near& n, const Near& d) {
  const double least = below(std::abs(d.middle) - d.radius), middle = n.middle / d.middle;
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  return {middle, above((n.radius + std::abs(middle) * d.radius) / least + std::abs(middle) * 0x1p-52)};
}

/// sqrt of a ball: |sqrt x - sqrt m| <= r/(sqrt m + sqrt(m - r)).
inline Near root(const Near& x) {
  const double least = below(x.middle - x.radius), middle = std::sqrt(x.middle);
  if (!(least > 0)) return {0, std::numeric_limits<double>::infinity()};
  return {middle, above(x.radius / below(middle + std::sqrt(least)) + middle * 0x1p-52)};
}

}  // namespace cylon::certified
