// The system of equations of one symmetric top that turns about a fixed point on its axis under gravity
// alone: a spherical pendulum is one.
#pragma once

#include "engine/methods.h"
#include "engine/reduce.h"
#include "engine/system.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace cylon::engine {

/// The kick's torque is across the axis e and the drift turns e about L, so that l_e = L.e is constant and
/// with it the spin (x_e - x) l_e about e that comes on top of the turn x L of a top without it: it needs no
/// stage,
///   R = q exp(spin t e_e),  q' = (x L) q/2,  L' = c e x m g
/// y = q, L and the angle of the spin.  Kick: L + h c e x m g.  Drift: exp(h x L) q, exact.
class Top {
 public:
  static constexpr std::size_t fixed_size = 8;

  /// Whether a reduced model is one.
  static bool applies(const Model& model) {
    if (model.bodies.size() != 1 || !missing(Method::top, model).empty()) return false;
    const Body& body = model.bodies[0];
    if (!body.pinned) return false;
    const int s = symmetry_axis(body);
    if (s < 0) return false;
    const Vector3 axis = body.principal_axes * Vector3::Unit(s);
    return body.centre.cross(axis).norm() <= 8 * epsilon * body.centre.norm();
  }

  /// Requires applies(model).
  explicit Top(const Model& model) : body_(model.bodies[0]), start_(model.motions[0]) {
    const int s = symmetry_axis(body_);
    // principal axes with the top's own as the third
    frame_ = body_.principal_axes;
    if (s == 0) frame_ = frame_ * Quaternion(Real(0.5), Real(0.5), Real(0.5), Real(0.5));
    const Vector3 axis = frame_ * Vector3::UnitZ();
    inverse_ = body_.inverse_moments[1];
    spin_ = (body_.inverse_moments[s] - inverse_) * (start_.orientation * axis).dot(start_.angular_momentum);
    pull_ = body_.centre.dot(axis) * body_.mass * model.gravity_of(0);
  }

  std::size_t size() const { return fixed_size; }

  std::vector<Real> initial() const {
    const Quaternion q = start_.orientation * frame_;
    const Vector3& l = start_.angular_momentum;
    return {q.w(), q.x(), q.y(), q.z(), l.x(), l.y(), l.z(), 0};
  }

  void rates(Time, const Real* y, Real* rate) {
    const Real half = inverse_ / 2, x = half * y[4], yy = half * y[5], z = half * y[6];
    rate[0] = -x * y[1] - yy * y[2] - z * y[3];
    rate[1] = x * y[0] + yy * y[3] - z * y[2];
    rate[2] = yy * y[0] + z * y[1] - x * y[3];
    rate[3] = z * y[0] + x * y[2] - yy * y[1];
    rate[4] = rate[5] = rate[6] = 0;
    push(1, y, rate + 4);
    rate[7] = spin_;
  }

  void kick(Time, Real h, Real* y) { push(h, y, y + 4); }

  void drift(Real h, Real* y) {
    const Real half = h * inverse_ / 2, x = half * y[4], yy = half * y[5], z = half * y[6];
    const Real xx = x * x + yy * yy + z * z;
    Real cosine = 1, sinc = 1;
    if (xx < Real(0.01)) {  // first terms left out: 3e-17
      const Real x4 = xx * xx;
      cosine = (1 - xx / 2) + x4 * ((Real(1) / 24 - xx * (Real(1) / 720)) + x4 * (Real(1) / 40320));
      sinc =
          (1 - xx * (Real(1) / 6)) + x4 * ((Real(1) / 120 - xx * (Real(1) / 5040)) + x4 * (Real(1) / 362880));
    } else {
      const Real angle = std::sqrt(xx);
      cosine = std::cos(angle), sinc = std::sin(angle) / angle;
    }
    const Real a = sinc * x, b = sinc * yy, c = sinc * z;
    const Real q0 = y[0], q1 = y[1], q2 = y[2], q3 = y[3];
    y[0] = (cosine * q0 - a * q1) - (b * q2 + c * q3);
    y[1] = (cosine * q1 + a * q0) + (b * q3 - c * q2);
    y[2] = (cosine * q2 + b * q0) + (c * q1 - a * q3);
    y[3] = (cosine * q3 + c * q0) + (a * q2 - b * q1);
    y[7] += h * spin_;
  }

  /// The unit quaternion next to q.
  void project(Real* y) {
    const Real factor = (3 - (y[0] * y[0] + y[1] * y[1] + y[2] * y[2] + y[3] * y[3])) / 2;
    for (int i = 0; i < 4; ++i) y[i] *= factor;
  }

  /// For error control: turns against 1, L against the largest |L| so far.
  void scales(const Real* y, Real* scale) {
    size_ = std::max(size_, std::sqrt(y[4] * y[4] + y[5] * y[5] + y[6] * y[6]));
    std::fill(scale, scale + fixed_size, Real(1));
    std::fill(scale + 4, scale + 7, size_ > 0 ? size_ : Real(1));
  }

  /// The motion about the pivot.
  Motion motion(const Real* y) const {
    Motion m = start_;
    const Real half = std::remainder(y[7], 4 * std::numbers::pi_v<Real>) / 2;
    const Quaternion spun(std::cos(half), 0, 0, std::sin(half));
    m.orientation = (Quaternion(y[0], y[1], y[2], y[3]) * spun * frame_.conjugate()).normalized();
    m.angular_momentum = {y[4], y[5], y[6]};
    return m;
  }

  const Body& body() const { return body_; }

 private:
  // Index of the principal axis about which two moments are the same; -1: none.
  static int symmetry_axis(const Body& body) {
    const Vector3& x = body.inverse_moments;
    const auto same = [](Real a, Real b) { return std::abs(a - b) <= 8 * epsilon * std::abs(b); };
    return same(x[0], x[1]) ? 2 : same(x[2], x[1]) ? 0 : -1;
  }

  // L += h e x (c m g), e the third column of R(q)
  void push(Real h, const Real* y, Real* l) const {
    const Real ex = 2 * (y[1] * y[3] + y[0] * y[2]), ey = 2 * (y[2] * y[3] - y[0] * y[1]),
               ez = 1 - 2 * (y[1] * y[1] + y[2] * y[2]);
    const Real fx = h * pull_[0], fy = h * pull_[1], fz = h * pull_[2];
    l[0] += ey * fz - ez * fy;
    l[1] += ez * fx - ex * fz;
    l[2] += ex * fy - ey * fx;
  }

  Body body_;
  Motion start_;
  Quaternion frame_;
  Real inverse_ = 0, spin_ = 0, size_ = 0;
  Vector3 pull_;
};

static_assert(Split<Top>);

}  // namespace cylon::engine
