// The system of equations of points that nothing turns: positions and momenta, each component in an array of
// its own.
#pragma once

#include "engine/balanced.h"
#include "engine/model.h"
#include "engine/system.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace cylon::engine {

/// What keeps a model from being one of points under forces that do not turn them; empty where nothing does.
std::string not_points(const Model&);

/// What tells the integrators that the length of the state is a constant, where it is one.
template <std::size_t N>
struct PointsSize {
  static constexpr std::size_t fixed_size = 6 * N;
};
template <>
struct PointsSize<0> {};

/// y = x, y, z of all positions, then of all momenta: 6 N Reals.  N = 0: as many as the model has; N = 1 lets
/// the compiler unroll everything.
template <std::size_t N>
class Points : public PointsSize<N> {
 public:
  /// Requires not_points(model) to be empty, and N bodies where N > 0.
  explicit Points(const Model& model) : gravity_(model.forces.gravity), balanced_(model) {
    own_ = model.has_own_gravity();
    for (std::size_t i = 0; own_ && i < model.bodies.size(); ++i) own_gravity_.push_back(model.gravity_of(i));
    const auto pin = [&](int body) { return body == fixed_world || model.bodies[index(body)].locked; };
    const auto place = [&](int body, const Vector3& anchor) {
      return body == fixed_world ? anchor : model.motions[index(body)].position;
    };
    for (const Body& body : model.bodies) {
      mass_.push_back(body.locked ? 0 : body.mass);
      inverse_mass_.push_back(body.inverse_mass);
    }
    for (const Spring& s : model.forces.springs) {
      if (pin(s.body) && pin(s.to)) continue;
      if (pin(s.to))
        pins_.push_back({index(s.body), place(s.to, s.to_anchor), s.stiffness, s.rest_length});
      else if (pin(s.body))
        pins_.push_back({index(s.to), place(s.body, s.anchor), s.stiffness, s.rest_length});
      else
        links_.push_back({index(s.body), index(s.to), s.stiffness, s.rest_length});
    }
    for (const Drive& d : model.forces.drives) {
      if (!pin(d.body)) drives_.push_back(d);
    }
    for (const Attraction& a : model.forces.attractions) {
      const Real product = model.bodies[index(a.body)].mass * model.bodies[index(a.to)].mass;
      pulls_.push_back({index(a.body), index(a.to), a.strength * product});
    }
    weight_ = !gravity_.isZero(0);
  }

  std::size_t size() const { return 6 * count(); }
  std::size_t count() const { return N > 0 ? N : mass_.size(); }

  void rates(Time t, const Real* y, Real* rate) {
    const std::size_t n = count();
    for (std::size_t c = 0; c < 3; ++c) {
      const Real* k = y + (3 + c) * n;
      Real* v = rate + c * n;
      for (std::size_t i = 0; i < n; ++i) v[i] = inverse_mass_[i] * k[i];
    }
    std::fill(rate + 3 * n, rate + 6 * n, Real(0));
    push(t, 1, y, rate + 3 * n);
  }

  void kick(Time t, Real h, Real* y) { push(t, h, y, y + 3 * count()); }

  void drift(Real h, Real* y) {
    const std::size_t n = count();
    for (std::size_t c = 0; c < 3; ++c) {
      Real* __restrict p = y + c * n;
      const Real* __restrict k = y + (3 + c) * n;
      for (std::size_t i = 0; i < n; ++i) p[i] += (h * inverse_mass_[i]) * k[i];
    }
  }

  void project(Real*) {}

  /// For error control: positions against the largest distance from the origin so far, momenta against the
  /// mass times the largest speed so far; what has been zero always, against 1; what springs balance: Balanced.
  void scales(const Real* y, Real* scale, Real tolerance) {
    const std::size_t n = count();
    for (std::size_t i = 0; i < n; ++i) {
      length_ = std::max(length_, point(y, n, i).norm());
      speed_ = std::max(speed_, inverse_mass_[i] * point(y + 3 * n, n, i).norm());
    }
    const auto or_one = [](Real x) { return x > 0 ? x : Real(1); };
    const Real speed = balanced_.speed(speed_, tolerance);
    std::fill(scale, scale + 3 * n, or_one(balanced_.length(length_, tolerance)));
    for (std::size_t i = 0; i < 3 * n; ++i) scale[3 * n + i] = or_one(mass_[i % n] * speed);
  }

  std::vector<Real> initial(const std::vector<Motion>& motions) const {
    const std::size_t n = count();
    std::vector<Real> y(size());
    for (std::size_t i = 0; i < n; ++i) {
      for (int c = 0; c < 3; ++c) {
        y[static_cast<std::size_t>(c) * n + i] = motions[i].position[c];
        y[static_cast<std::size_t>(3 + c) * n + i] = motions[i].momentum[c];
      }
    }
    return y;
  }

  /// Overwrites positions and momenta.
  void read(const Real* y, std::vector<Motion>& motions) const {
    const std::size_t n = count();
    for (std::size_t i = 0; i < n; ++i) {
      motions[i].position = point(y, n, i);
      motions[i].momentum = point(y + 3 * n, n, i);
    }
  }

 private:
  struct Pin {
    std::size_t body;
    Vector3 place;
    Real stiffness, rest_length;
  };
  struct Link {
    std::size_t body, to;
    Real stiffness, rest_length;
  };
  struct Pull {
    std::size_t body, to;
    Real strength;  // G m_a m_b
  };

  static Vector3 point(const Real* p, std::size_t n, std::size_t i) { return {p[i], p[n + i], p[2 * n + i]}; }
  static void add(const Vector3& f, Real* k, std::size_t n, std::size_t i) {
    k[i] += f.x(), k[n + i] += f.y(), k[2 * n + i] += f.z();
  }

  //  F = k (|d| - L) d/|d| = k (1 - L/|d|) d
  static Vector3 pull(const Vector3& d, Real stiffness, Real rest_length) {
    if (rest_length == 0) return stiffness * d;
    const Real length = std::sqrt(d.x() * d.x() + d.y() * d.y() + d.z() * d.z());
    return length > 0 ? Vector3((stiffness - stiffness * rest_length / length) * d)
                      : Vector3(Vector3::Zero());
  }

  // k += h F(t, p)
  void push(Time t, Real h, const Real* y, Real* k) {
    const std::size_t n = count();
    if (own_) {
      for (std::size_t i = 0; i < n; ++i) add(h * mass_[i] * own_gravity_[i], k, n, i);
    } else if (weight_) {
      for (int c = 0; c < 3; ++c) {
        const Real g = h * gravity_[c];
        for (std::size_t i = 0; i < n; ++i) k[static_cast<std::size_t>(c) * n + i] += g * mass_[i];
      }
    }
    for (const Pin& s : pins_) {
      add(pull(s.place - point(y, n, s.body), h * s.stiffness, s.rest_length), k, n, s.body);
    }
    for (const Link& s : links_) {
      const Vector3 f = pull(point(y, n, s.to) - point(y, n, s.body), h * s.stiffness, s.rest_length);
      add(f, k, n, s.body);
      add(-f, k, n, s.to);
    }
    for (const Pull& s : pulls_) {
      const Vector3 d = point(y, n, s.to) - point(y, n, s.body);
      const Real square = d.squaredNorm();
      if (square == 0) continue;
      const Vector3 f = h * s.strength / (square * std::sqrt(square)) * d;
      if (mass_[s.body] != 0) add(f, k, n, s.body);  // locked bodies have none here
      if (mass_[s.to] != 0) add(-f, k, n, s.to);
    }
    for (const Drive& d : drives_) {
      add(h * static_cast<Real>(std::cos(static_cast<double>(d.frequency) * t)) * d.force, k, n,
          index(d.body));
    }
  }

  Vector3 gravity_;
  bool weight_ = false, own_ = false;
  std::vector<Vector3> own_gravity_;  // one per body, where one has its own
  Real length_ = 0, speed_ = 0;       // the largest that scales() has seen
  Balanced balanced_;
  std::vector<Real> mass_, inverse_mass_;
  std::vector<Pin> pins_;
  std::vector<Link> links_;
  std::vector<Pull> pulls_;
  std::vector<Drive> drives_;
};

static_assert(Split<Points<0>> && Split<Points<1>>);

}  // namespace cylon::engine
