// A rigid body on a hinge to the world in gravity.  theta from the lowest position about the axis n, J the moment
// about the axis, l the distance of the centre of mass from it, g the part of gravity across it:
//
//     theta'' = -w0^2 sin theta,  w0^2 = m g l/J,  k^2 = sin^2(theta0/2) + (theta0'/(2 w0))^2
//     k < 1, swings:   sin(theta/2) = k sn(u|k^2),  cos(theta/2) = dn,   theta' = 2 w0 k cn,   u = w0 t + u0
//     k > 1, whirls:   sin(theta/2) = +-sn(u|1/k^2), cos(theta/2) = cn,  theta' = +-2 w0 k dn, u = w0 k t + u0
//
// The half angles are the quaternion's components, so that nothing is inverted; 1 - k^2 is formed as a
// product of a sum and a difference.
#pragma once

#include "harness/core/scene.h"
#include "reference/exact/elliptic.h"
#include "reference/exact/wide.h"

#include <optional>
#include <string_view>

namespace cylon::exact {

/// theta of a pendulum, by the sine and cosine of its half.
class PendulumMotion {
 public:
  struct Value {
    Wide sine, cosine, rate;
  };

  /// From a half angle in (-pi/2, pi/2] and theta' at t = 0; w0 > 0.
  PendulumMotion(Wide frequency, const Value& start);

  /// Whether it comes to rest upright, or so near it (1e-14) that the starting values decide nothing.
  bool on_separatrix() const { return !elliptic_; }

  Value at(Wide t) const;

  /// When it first comes to a stop that it goes towards, not having started there; infinite: never.  `lower` and
  /// `upper` are angles theta, lower <= theta0 <= upper, within one turn.
  struct Arrival {
    Wide time;
    bool upper;
  };
  Arrival arrives(Wide lower, Wide upper) const;

 private:
  Wide phase_of(Wide theta) const;

  Wide frequency_;
  Value start_;
  Wide modulus_ = 0, phase_ = 0, sense_ = 1;  // k, u0, the way that it whirls
  bool whirls_ = false;
  std::optional<Elliptic> elliptic_;
};

/// The geometry of a body on its one hinge.
struct HingedBody {
  HingedBody(const core::Scene&, std::size_t body);

  /// Of a half angle and a rate.
  WideState state(const PendulumMotion::Value&) const;
  /// Without gravity across the axis.
  WideState turned(Wide angle) const;

  WideVector axis, pivot, arm;
  WideQuaternion start;
  Wide frequency = 0;                         ///< w0
  PendulumMotion::Value initial = {0, 1, 0};  ///< theta0 and theta0'

 private:
  WideState moved(const WideQuaternion& turn, Wide rate) const;
};

/// The scene's body has exactly one joint, a hinge to the world, and moves as that lets it.
void check_hinge(std::string_view solution, const core::Scene&, int body);

/// That hinge.
const core::Joint& hinge_of(const core::Scene&, std::size_t body);

}  // namespace cylon::exact
