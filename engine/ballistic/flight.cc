#include "engine/ballistic/flight.h"

#include "engine/ballistic/scene.h"
#include "engine/free_rotation.h"

#include <limits>

namespace cylon::engine::ballistic {

namespace {

// Angular velocity w + s alpha of a body with a sphere's inertia.
struct Spin {
  Vector3 w, alpha;
};

Spin spin(const Body& body, const Turning& turning, Time t) {
  const Real inverse = body.inverse_moments[1];
  return {inverse * turning.angular_momentum_at(t), inverse * turning.torque};
}

// A stride turns the body by less than 1.5 rad: |w| h + |alpha| h^2 / 2 with h = 1 / (|w| + sqrt |alpha|).
Time stride(const Spin& spin) {
  return Time(1) / static_cast<Time>(spin.w.norm() + std::sqrt(spin.alpha.norm()));
}

// dq/ds = (w + s alpha) q / 2 as a power series in s, which converges for every s:
//   (k + 1) q_{k+1} = (w q_k + alpha q_{k-1}) / 2
// Over a stride the terms fall faster than 0.75^k / k!, which is below rounding for k = 15: the 40 are never made.
Quaternion turned_evenly(const Quaternion& start, const Spin& spin, Real s) {
  const auto pure = [](const Vector3& v) { return Quaternion(0, v.x(), v.y(), v.z()); };
  const Quaternion w = pure(s / 2 * spin.w), alpha = pure(s * s / 2 * spin.alpha);
  Quaternion before(0, 0, 0, 0), term = start;
  auto sum = start.coeffs().eval();
  for (int k = 0; k < 40; ++k) {
    const Quaternion next(((w * term).coeffs() + (alpha * before).coeffs()) / static_cast<Real>(k + 1));
    before = term;
    term = next;
    sum += term.coeffs();
    if (term.norm() + before.norm() < epsilon / 16) break;
  }
  return renormalised(Quaternion(sum));
}

}  // namespace

void follow(const Body& body, Turning& turning, Time t) {
  if (turning.torque.isZero(0)) return;
  for (;;) {
    const Spin now = spin(body, turning, turning.oriented);
    const Time h = stride(now);
    if (!(turning.oriented + h <= t)) return;
    turning.orientation = turned_evenly(turning.orientation, now, static_cast<Real>(h));
    turning.oriented += h;
  }
}

Quaternion orientation_at(const Body& body, const Turning& turning, Time t) {
  if (!turning.turns() || t == turning.oriented) return turning.orientation;
  const Real s = static_cast<Real>(t - turning.oriented);
  if (turning.torque.isZero(0)) {
    if (symmetry(body) == Symmetry::sphere)
      return turned(turning.orientation, s * body.inverse_moments[1] * turning.angular_momentum);
    return free_rotation(body, turning.orientation, turning.angular_momentum, s, Splitting::lie);
  }
  Turning whole = turning;
  follow(body, whole, t);
  return turned_evenly(whole.orientation, spin(body, whole, whole.oriented),
                       static_cast<Real>(t - whole.oriented));
}

void turn_on(const Body& body, Turning& turning, Time t) {
  turning.orientation = orientation_at(body, turning, t);
  turning.angular_momentum = turning.angular_momentum_at(t);
  turning.since = turning.oriented = t;
}

}  // namespace cylon::engine::ballistic
