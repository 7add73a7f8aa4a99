// Elliptic integrals and functions, in double whatever Real is: they serve motions over any time.
#pragma once

#include <array>

namespace cylon::engine {

/// R_F = 1/2 int_0^inf dt / sqrt((t + x)(t + y)(t + z)).  x, y, z >= 0, at most one of them 0; relative error
/// a few ulps.  B. C. Carlson, Numer. Algorithms 10 (1995) 13, section 2; DLMF 19.36.
double carlson_rf(double x, double y, double z);

/// R_J = 3/2 int_0^inf dt / ((t + p) sqrt((t + x)(t + y)(t + z))).  x, y, z >= 0, at most one of them 0, and
/// p >= max(x, y, z); relative error some ulps.  As above, section 4.
double carlson_rj(double x, double y, double z, double p);

struct JacobiValues {
  double sn, cn, dn;
};

/// The functions of one modulus.
class Jacobi {
 public:
  /// By the complementary parameter 1 - k^2 in [0, 1]; below 1e-40, where k is 1 to every digit, it counts as
  /// 1e-40 (K = 47).
  explicit Jacobi(double complement = 1);

  double complement() const { return complement_; }
  double quarter_period() const { return quarter_period_; }  ///< K

  /// sn u, cn u, dn u for |u| <= K.  Arithmetic-geometric mean and Gauss' transformation:
  /// R. Bulirsch, Numer. Math. 7 (1965) 78, section 1.
  JacobiValues operator()(double u) const;

 private:
  static constexpr int most = 16;
  double complement_ = 1, quarter_period_ = 0, limit_ = 1;
  std::array<double, most> a_{}, b_{};
  int length_ = 0;
};

}  // namespace cylon::engine
