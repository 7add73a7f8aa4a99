#include "engine/geometry/orient.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

namespace cylon::engine {
namespace {

// A number as an unevaluated sum of doubles that do not overlap, in ascending order; its sign is the last's.
struct Expansion {
  std::array<double, 200> part;  // 192 are needed
  std::size_t count = 0;

  // Shewchuk, Grow-Expansion (theorem 10), zeros left out.
  void add(double x) {
    std::size_t kept = 0;
    for (std::size_t k = 0; k < count; ++k) {
      const double sum = x + part[k], virtual_part = sum - x;
      const double rest = (x - (sum - virtual_part)) + (part[k] - virtual_part);
      x = sum;
      if (rest != 0) part[kept++] = rest;
    }
    if (x != 0) part[kept++] = x;
    count = kept;
  }
  void add_product(double x, double y) {
    const double product = x * y;
    add(std::fma(x, y, -product));
    add(product);
  }
  void add_product(const Expansion& e, const Expansion& f, double sign) {
    for (std::size_t i = 0; i < e.count; ++i)
      for (std::size_t k = 0; k < f.count; ++k) add_product(sign * e.part[i], f.part[k]);
  }
  int sign() const { return count == 0 ? 0 : (part[count - 1] > 0 ? 1 : -1); }
};

Expansion difference(double x, double y) {
  Expansion e;
  e.add(x);
  e.add(-y);
  return e;
}

int exact_side(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
               const Eigen::Vector3d& d) {
  std::array<std::array<Expansion, 3>, 3> m;
  for (int k = 0; k < 3; ++k) {
    const auto i = static_cast<std::size_t>(k);
    m[0][i] = difference(b[k], a[k]), m[1][i] = difference(c[k], a[k]), m[2][i] = difference(d[k], a[k]);
  }
  Expansion determinant;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t x = (k + 1) % 3, y = (k + 2) % 3;
    Expansion minor;
    minor.add_product(m[0][x], m[1][y], 1);
    minor.add_product(m[0][y], m[1][x], -1);
    determinant.add_product(minor, m[2][k], 1);
  }
  return determinant.sign();
}

}  // namespace

int side_of_plane(const Eigen::Vector3d& a, const Eigen::Vector3d& b, const Eigen::Vector3d& c,
                  const Eigen::Vector3d& d) {
  const Eigen::Vector3d u = b - a, v = c - a, w = d - a;
  const double determinant = u.cross(v).dot(w);
  const double xy = std::abs(u.y() * v.z()) + std::abs(u.z() * v.y());
  const double yz = std::abs(u.z() * v.x()) + std::abs(u.x() * v.z());
  const double zx = std::abs(u.x() * v.y()) + std::abs(u.y() * v.x());
  const double permanent = xy * std::abs(w.x()) + yz * std::abs(w.y()) + zx * std::abs(w.z());
  const double bound = 8 * (std::numeric_limits<double>::epsilon() / 2) * permanent;  // (7 + 56 eps) eps
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  return exact_side(a, b, c, d);
}

}  // namespace cylon::engine
