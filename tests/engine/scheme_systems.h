// Systems on which integrators are tried: small, general, with known forces; they share nothing with the
// engine's.
#pragma once

#include "engine/free_rotation.h"
#include "engine/rotation.h"
#include "engine/system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace cylon::engine {

/// A point on a spring with rest length and a cubic term, driven: no axis separates, and time enters.
///   m p'' = -k (1 - l/|p - c|) (p - c) - b |p|^2 p + f cos(w t) - drag p'
struct SpringPoint {
  static constexpr std::size_t fixed_size = 6;
  Real mass = Real(1.3), stiffness = 11, rest = Real(0.6), cubic = Real(0.8), frequency = Real(1.7), drag = 0;
  Vector3 centre{Real(0.1), Real(-0.3), Real(0.2)}, drive{Real(0.9), Real(0.4), Real(-1.1)};
  long kicks = 0, evaluations = 0;

  std::size_t size() const { return fixed_size; }

  Vector3 force(Time t, const Vector3& p) const {
    const Vector3 d = p - centre;
    return -stiffness * (1 - rest / d.norm()) * d - cubic * p.squaredNorm() * p +
           static_cast<Real>(std::cos(frequency * t)) * drive;
  }
  void rates(Time t, const Real* from, Real* rate) {
    ++evaluations;
    const Vector3 p(from), k(from + 3);
    Vector3::Map(rate) = k / mass;
    Vector3::Map(rate + 3) = force(t, p) - drag / mass * k;
  }
  /// K' = F - drag/m K with F constant, solved exactly.
  void kick(Time t, Real h, Real* y) {
    ++kicks;
    const Real x = -drag / mass * h, gain = x == 0 ? 1 : std::expm1(x) / x;
    Vector3::Map(y + 3) = std::exp(x) * Vector3(y + 3) + gain * h * force(t, Vector3(y));
  }
  void drift(Real h, Real* y) { Vector3::Map(y) += h / mass * Vector3(y + 3); }
  void project(Real*) {}

  /// Without drive and drag it is constant [J].
  Real energy(const Real* y) const {
    const Vector3 p(y), k(y + 3);
    const Real stretch = (p - centre).norm() - rest, pp = p.squaredNorm();
    return k.squaredNorm() / (2 * mass) + stiffness / 2 * stretch * stretch + cubic / 4 * pp * pp;
  }
  static std::vector<Real> start() {
    return {Real(0.9), Real(0.2), Real(-0.5), Real(0.3), Real(1.1), Real(0.4)};
  }
};

/// A rigid body without symmetry that turns about a fixed point, an anchor on it tied to a point that moves.
///   torque = (R a) x k (b + s cos(w t) - R a) - drag L
struct TiedBody {
  static constexpr std::size_t fixed_size = 7;
  Body body;
  Vector3 anchor{Real(0.4), Real(-0.2), Real(0.5)}, pin{Real(0.3), Real(0.9), Real(-0.4)},
      swing{Real(0.2), Real(-0.1), Real(0.3)};
  Real stiffness = 6, frequency = Real(1.3), drag = 0;

  TiedBody() {
    const Matrix3 r = exponential({Real(0.3), Real(-0.7), Real(0.4)}).toRotationMatrix();
    const Matrix3 inertia = r * Vector3(Real(0.5), Real(0.7), Real(1.0)).asDiagonal() * r.transpose();
    body = make_body(1, (inertia + inertia.transpose()) / 2);
  }
  std::size_t size() const { return fixed_size; }

  static Quaternion orientation(const Real* y) { return {y[0], y[1], y[2], y[3]}; }
  static void store(const Quaternion& q, Real* y) { y[0] = q.w(), y[1] = q.x(), y[2] = q.y(), y[3] = q.z(); }

  Vector3 torque(Time t, const Real* y) const {
    const Vector3 arm = orientation(y).toRotationMatrix() * anchor;
    return arm.cross(stiffness * (pin + static_cast<Real>(std::cos(frequency * t)) * swing));
  }
  void rates(Time t, const Real* from, Real* rate) {
    const Vector3 l(from + 4), w = inverse_inertia_times(body, orientation(from), l);
    const Quaternion turn = Quaternion(0, w.x(), w.y(), w.z()) * orientation(from);
    store(Quaternion(turn.coeffs() / 2), rate);
    Vector3::Map(rate + 4) = torque(t, from) - drag * l;
  }
  void kick(Time t, Real h, Real* y) {
    const Real x = -drag * h, gain = x == 0 ? 1 : std::expm1(x) / x;
    Vector3::Map(y + 4) = std::exp(x) * Vector3(y + 4) + gain * h * torque(t, y);
  }
  void drift(Real h, Real* y) { store(free_flow(body, orientation(y), Vector3(y + 4), h), y); }
  void project(Real* y) { store(renormalised(orientation(y)), y); }

  /// Without swing and drag it is constant [J].
  Real energy(const Real* y) const {
    const Vector3 l(y + 4);
    return l.dot(inverse_inertia_times(body, orientation(y), l)) / 2 -
           stiffness * pin.dot(orientation(y) * anchor);
  }
  static std::vector<Real> start() {
    std::vector<Real> y(7);
    store(exponential({Real(0.5), Real(1.1), Real(-0.6)}), y.data());
    y[4] = Real(0.9), y[5] = Real(-0.5), y[6] = Real(0.8);
    return y;
  }
};

/// A body that falls round a fixed centre:  p'' = -p/|p|^3,  an ellipse with eccentricity 0.4.
struct Orbit {
  static constexpr std::size_t fixed_size = 6;
  std::size_t size() const { return fixed_size; }
  static Vector3 force(const Vector3& p) { return -p / (p.norm() * p.squaredNorm()); }
  void rates(Time, const Real* from, Real* rate) {
    Vector3::Map(rate) = Vector3(from + 3);
    Vector3::Map(rate + 3) = force(Vector3(from));
  }
  void kick(Time, Real h, Real* y) { Vector3::Map(y + 3) += h * force(Vector3(y)); }
  void drift(Real h, Real* y) { Vector3::Map(y) += h * Vector3(y + 3); }
  void project(Real*) {}
  static std::vector<Real> start() {
    return {Real(0.6), Real(0.3), Real(-0.2), Real(-0.5), Real(1.0), Real(0.4)};
  }
};

/// A point on a rod, |p| = length, driven: kept by SHAKE, where rates() has the rod's force in it.
struct Pendulum {
  static constexpr std::size_t fixed_size = 6;
  Real mass = Real(1.3), length = Real(0.9), frequency = Real(1.7);
  Vector3 weight{Real(0.3), Real(-9.81), Real(0.7)}, drive{Real(0.9), Real(0.4), Real(-1.1)};

  std::size_t size() const { return fixed_size; }
  bool constrained() const { return true; }
  Vector3 force(Time t) const { return mass * weight + static_cast<Real>(std::cos(frequency * t)) * drive; }
  void rates(Time t, const Real* from, Real* rate) {
    const Vector3 p(from), k(from + 3), f = force(t);
    Vector3::Map(rate) = k / mass;
    Vector3::Map(rate + 3) = f - (f.dot(p) + k.squaredNorm() / mass) / p.squaredNorm() * p;
  }
  void kick(Time t, Real h, Real* y) { Vector3::Map(y + 3) += h * force(t); }
  void drift(Real h, Real* y) {  // |a p + h/m K| = length, the nearer root
    const Vector3 p(y), step = h / mass * Vector3(y + 3);
    const Real b = p.dot(step) / p.squaredNorm();
    const Real c = (length * length - step.squaredNorm()) / p.squaredNorm();
    const Real a = std::sqrt(b * b + c) - b;
    Vector3::Map(y) = a * p + step;
    Vector3::Map(y + 3) += (a - 1) * mass / h * p;
  }
  void project(Real* y) {
    const Vector3 p(y), k(y + 3);
    Vector3::Map(y + 3) -= k.dot(p) / p.squaredNorm() * p;
  }
  static std::vector<Real> start() {
    const Vector3 p = Real(0.9) * Vector3(Real(0.6), Real(-0.5), Real(0.4)).normalized(),
                  k = p.cross(Vector3(Real(1.1), Real(0.3), Real(-0.8)));
    return {p.x(), p.y(), p.z(), k.x(), k.y(), k.z()};
  }
};

inline Real distance(const std::vector<Real>& a, const std::vector<Real>& b) {
  Real sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum);
}

}  // namespace cylon::engine
