// Motion along one free coordinate q of a joint, of inertia M, that no other motion couples to:
//
//     M q'' = G - k (q - z(t)) - c (q' - z'(t)) + F - f sign(q'),   lower <= q <= upper
//
// with z(t) = z0 + A cos(Omega t + phi).  At a stop q' turns round to -e q'.  At rest the coordinate is held where
// |G + F - k (q - z0)| <= f, and at a stop that it is pressed against; as all else is constant then, it stays there.
// Between turns, with a0 the acceleration at the piece's start without the damping, the roots r1, r2 of
// r^2 + c/M r + k/M = 0 and [..] the divided differences of exp(x s):
//
//     q = q0 + v0 [r1, r2] + a0 [r1, r2, 0] + Re p [r1, r2, i Omega],   p = (k + i c Omega) A exp(i phi)/M
//
// which passes through critical damping, resonance and the absence of any of the forces without a seam.
#pragma once

#include "harness/core/scene.h"
#include "reference/exact/exponential.h"

#include <vector>

namespace cylon::exact {

class CoordinateMotion {
 public:
  struct Value {
    Wide place, rate;
  };

  /// The law of a coordinate on which nothing acts is a default one.  `inertia` M > 0 [kg, kg m^2], `pull` G
  /// [N, N m], `rate` q'(0); pieces are found up to the horizon [s].  Throws std::domain_error where a stop is struck
  /// more than 1000 times.
  CoordinateMotion(const core::JointCoordinate& law, Wide inertia, Wide pull, Wide rate, Wide horizon);

  /// When pieces start [s]: the first at 0, the others where it turns, strikes a stop or comes to be held.
  std::vector<Wide> starts() const;

  /// The piece at a time.
  std::size_t piece_at(Wide t) const;

  /// By one piece, a little beyond it as well.
  Value at(std::size_t piece, Wide t) const;

 private:
  struct Piece {
    Wide start, place, rate, acceleration;  // a0
    bool held = false;
  };
  struct Response {
    Wide s, ds, push;  // [r1, r2], its derivative, [r1, r2, 0]
  };

  Response response(Wide s) const;
  Value along(const Piece&, Wide s) const;
  Wide turn_after(const Piece&) const;
  Wide reaches(const Piece&, Wide stop, Wide within) const;
  Piece go_on(Wide t, Wide place, Wide rate) const;
  void follow(Wide horizon);

  core::JointCoordinate law_;
  Wide inertia_, constant_;      // M, G + F + k z0
  Wide half_, below_;            // c/(2 M), k/M - (c/(2 M))^2
  WideComplex slow_, fast_;      // r1, r2
  WideComplex push_ = 0, turn_;  // p, i Omega
  std::vector<Piece> pieces_;
};

}  // namespace cylon::exact
