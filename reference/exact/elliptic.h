// Jacobi's elliptic functions and Legendre's integrals with the complementary parameter given, so that
// nothing is lost near the separatrix, where 1 - m would cancel.
#pragma once

#include "reference/exact/wide.h"

#include <array>

namespace cylon::exact {

/// am u and its circular functions: sn = sin am, cn = cos am, dn = sqrt(cn^2 + m1 sn^2).  cn and dn keep their digits
/// where am is next to a quarter turn, and am itself cannot: integrals from there feel it.
struct Amplitude {
  Wide am, half_turns, sn, cn, dn;  ///< am within a quarter turn of half_turns pi.
};

/// Functions of one parameter m = k^2 in [0, 1), m1 = 1 - m in (0, 1].  Relative errors of a few 1e-19
/// times the number of half periods; am is continuous in u.
class Elliptic {
 public:
  Elliptic(Wide m, Wide m1);

  /// Inverse of F: arithmetic-geometric mean, Abramowitz & Stegun 16.4.
  Amplitude at(Wide u) const;

  /// The amplitude in (-pi, pi] whose sine and cosine are as y : x, not both 0.
  Amplitude towards(Wide y, Wide x) const;

  /// F(phi|m) = int_0^phi dx / sqrt(1 - m sin^2 x); any phi [rad].  DLMF 19.25.5.
  Wide first(Wide phi) const;
  Wide first(const Amplitude&) const;

  /// Pi(n; phi|m) = int_0^phi dx / ((1 - n sin^2 x) sqrt(1 - m sin^2 x)) with n1 = 1 - n > 0 given; any phi.
  /// DLMF 19.25.14 and 19.7.9.
  Wide third(Wide n1, const Amplitude& phi) const;

  /// K(m), a quarter period.
  Wide quarter() const { return quarter_; }

 private:
  static constexpr int most = 32;  // the mean doubles its digits: m1 = 1e-4900 needs 20
  struct Circular {
    Wide s, c;
  };
  Circular near_zero(Wide u) const;
  // Pi at an amplitude within a quarter turn, by its sine and cosine; and from there to the quarter turn.
  Wide third_folded(Wide n1, Wide s, Wide c) const;
  Wide third_left(Wide n1, Wide s, Wide c) const;

  Wide m1_, quarter_;
  int levels_ = 0;
  std::array<Wide, most + 1> a_{}, b_{}, c_{};
};

}  // namespace cylon::exact
