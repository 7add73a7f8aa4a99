// The nutation of a heavy symmetric top: u = cos(theta), its half-angle functions, and the two integrals that
// precession and spin need.  Knows neither bodies nor quaternions; the equations stand in heavy_top.cc.
#pragma once

#include "reference/exact/elliptic.h"
#include "reference/exact/wide.h"

#include <optional>

namespace cylon::exact {

/// The axis at t = 0 and the top's two numbers.
struct AxisStart {
  WideVector direction;  ///< d, unit, from the pivot to the centre of mass.
  WideVector rate;       ///< d' [1/s].
  WideVector up;         ///< Unit.
  Wide a = 0;            ///< I3 w3/J [1/s].
  Wide beta = 0;         ///< 2 m g l/J [1/s^2], > 0.
};

/// S = sin(theta/2) and C = cos(theta/2) with the signs that keep them smooth; theta'; phi' sin(theta); P-
/// and P+.
struct AxisState {
  Wide sine, cosine, tilt_rate, azimuth_rate, minus, plus;
};

class HeavyTopAxis {
 public:
  HeavyTopAxis() = default;
  explicit HeavyTopAxis(const AxisStart&);

  /// False on the separatrix, where the axis comes to rest upright; at() may then not be called.
  bool periodic() const { return at_rest_ || elliptic_.has_value(); }

  /// lam [1/s].
  Wide rate() const { return rate_; }

  AxisState at(Wide t) const;

 private:
  // 1 - u or 1 + u at the two turning points, and the sum (b - a or b + a) that belongs to it; zero where
  // the axis passes through this pole.
  struct Pole {
    Wide at_first = 0, at_second = 0, sum = 0;
  };

  void find_turning_points(const AxisStart&, Wide tilt_product, Wide turn_product, Wide w0, Wide y0);
  Wide integral(const Pole&, const Amplitude& am) const;

  bool at_rest_ = false;  // vertical, and stays so
  Wide a_ = 0, rate_ = 0, start_ = 0;
  Pole above_, below_;
  Wide start_minus_ = 0, start_plus_ = 0;
  std::optional<Elliptic> elliptic_;
};

}  // namespace cylon::exact
