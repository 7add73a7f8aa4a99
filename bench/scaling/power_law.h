// The exponent p of cost ~ N^p with its standard error, by least squares of the logarithms.
#pragma once

#include <cmath>
#include <limits>
#include <span>
#include <utility>

namespace cylon::bench::scaling {

struct PowerLaw {
  double exponent = std::numeric_limits<double>::quiet_NaN();
  double standard_error = std::numeric_limits<double>::quiet_NaN();  ///< Of three points and more.
};

/// Points (N, cost), all > 0.  p = Sxy/Sxx, its error sqrt(SSE/(n - 2)/Sxx): how far the points are from any
/// power law, not how well each was measured.  NaN below two points.
inline PowerLaw fit(std::span<const std::pair<double, double>> points) {
  const auto n = static_cast<double>(points.size());
  if (points.size() < 2) return {};
  double x = 0, y = 0;
  for (const auto& [size, cost] : points) x += std::log(size) / n, y += std::log(cost) / n;
  double xx = 0, xy = 0, yy = 0;
  for (const auto& [size, cost] : points) {
    const double u = std::log(size) - x, v = std::log(cost) - y;
    xx += u * u, xy += u * v, yy += v * v;
  }
  PowerLaw law{xy / xx};
  if (points.size() > 2) law.standard_error = std::sqrt(std::max(0.0, yy - xy * xy / xx) / (n - 2) / xx);
  return law;
}

}  // namespace cylon::bench::scaling
