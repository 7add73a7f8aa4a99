#include "engine/contact/coulomb_point.h"

#include "engine/root.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace cylon::engine {

namespace {

// Directions tried before a root is refined.  d x u_t is a trigonometric polynomial of degree two over a
// positive denominator: four roots at most, which this many sectors tell apart unless two nearly coincide.
constexpr int sectors = 48;

struct Sliding {
  const Matrix3& a;
  const Vector3& q;
  Real mu;

  Real normal(const Vector2& d) const {
    const Real stiff = a(0, 0) - mu * (a(0, 1) * d.x() + a(0, 2) * d.y());
    return stiff > epsilon * a(0, 0) ? -q[0] / stiff : Real(-1);
  }
  Vector3 force(const Vector2& d) const { return normal(d) * Vector3(1, -mu * d.x(), -mu * d.y()); }
  Vector2 slip(const Vector2& d) const { return (a * force(d) + q).tail<2>(); }
};

Vector2 turned_by(const Vector2& d, Real angle) {
  const Real c = std::cos(angle), s = std::sin(angle);
  return {c * d.x() - s * d.y(), s * d.x() + c * d.y()};
}

Real cross(const Vector2& a, const Vector2& b) { return a.x() * b.y() - a.y() * b.x(); }

}  // namespace

PointForce solve_point(const Matrix3& a, const Vector3& q, Real mu, const Hold& hold) {
  PointForce result;
  result.hold = hold;
  result.hold.grip = Grip::parts;
  if (!(q[0] < 0) || !(a(0, 0) > 0)) return result;

  const Vector3 frictionless(-q[0] / a(0, 0), 0, 0);
  if (mu == 0) {
    result.force = frictionless;
    result.hold.grip = Grip::slides;
    return result;
  }
  const Sliding sliding{a, q, mu};
  if (hold.given) {
    result.found = sliding.normal(hold.slip) >= 0;
    result.force = result.found ? sliding.force(hold.slip) : frictionless;
    result.hold.grip = Grip::slides;
    return result;
  }

  const VectorX wanted = -q;  // dynamic: gcc 12 misreads the bounds of fixed sizes here
  const Vector3 stick = LeastNorm(a).solve(wanted);
  const bool stops = (a * stick + q).norm() <= 64 * epsilon * q.norm();
  if (stops && stick[0] >= 0 && stick.tail<2>().norm() <= mu * stick[0]) {
    result.force = stick;
    result.hold.grip = Grip::sticks;
    result.hold.slip.setZero();
    return result;
  }

  result.hold.grip = Grip::slides;
  // The first direction is one that the data turn with, so that no axis is preferred.
  Vector2 first = stops ? Vector2(-stick.tail<2>()) : Vector2(q.tail<2>());
  if (!(first.norm() > 0)) first = q.tail<2>();
  first = first.norm() > 0 ? Vector2(first.normalized()) : Vector2(1, 0);
  const auto miss = [&](Real angle) {
    const Vector2 d = turned_by(first, angle);
    return cross(d, sliding.slip(d));
  };
  // What the edge of a sector shows; no normal force goes with some directions.
  struct Edge {
    Real angle = 0, miss = 0;
    bool possible = false;
  };
  const auto edge = [&](Real angle) {
    const Vector2 d = turned_by(first, angle);
    return Edge{angle, cross(d, sliding.slip(d)), sliding.normal(d) >= 0};
  };

  bool any = false;
  Real best = 0;
  const auto offer = [&](Real angle) {
    const Vector2 d = turned_by(first, angle);
    const Vector3 f = sliding.force(d);
    if (f[0] < 0 || sliding.slip(d).dot(d) < 0) return;
    const Real energy = f.dot(q + a * f / 2);
    if (any && !(energy < best)) return;
    any = true;
    best = energy;
    result.force = f;
    result.hold.slip = d;
  };
  const Real sector = 2 * std::numbers::pi_v<Real> / sectors;
  Edge low = edge(-sector / 2);
  for (int i = 0; i < sectors; ++i) {
    const Edge high = edge((static_cast<Real>(i) + Real(0.5)) * sector);
    const Edge begin = std::exchange(low, high);
    if (!begin.possible || !high.possible) continue;
    const Edge middle = i == 0 ? edge(0) : Edge{};  // in the direction of the first guess
    if (i == 0 && middle.miss == 0) offer(0);
    if (begin.miss * high.miss <= 0) offer(root(miss, begin.angle, begin.miss, high.angle, high.miss));
    if (i > 0 || !middle.possible) continue;
    if (begin.miss * middle.miss < 0 && middle.miss * high.miss < 0) {  // two more roots in this sector
      offer(root(miss, begin.angle, begin.miss, Real(0), middle.miss));
      offer(root(miss, Real(0), middle.miss, high.angle, high.miss));
    }
  }
  if (!any) {
    result.found = false;
    result.force = frictionless;
    result.hold.slip = first;
  }
  return result;
}

PointForce solve_dry(Real response, Real offset, Real bound, const Hold& hold) {
  PointForce result;
  result.hold = hold;
  const Real wanted = response > 0 ? -offset / response : Real(0);
  if (!hold.given) {
    result.hold.grip = std::abs(wanted) <= bound ? Grip::sticks : Grip::slides;
    result.hold.slip = Vector2(wanted > 0 ? -1 : 1, 0);
  }
  result.force = Vector3(0, result.hold.grip == Grip::sticks ? wanted : -bound * result.hold.slip.x(), 0);
  return result;
}

}  // namespace cylon::engine
