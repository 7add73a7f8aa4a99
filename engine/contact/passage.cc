#include "engine/contact/passage.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine {

namespace {

// Of a pair in one part of a step; more means that it grazes along, and the end of the step decides.
constexpr int most_looks = 400;

Vector3 logarithm(const Quaternion& q) {
  const Quaternion p = q.w() < 0 ? Quaternion(-q.coeffs()) : q;
  const Vector3 v = p.vec();
  const Real s = v.norm();
  if (!(s > 0)) return Vector3::Zero();
  return 2 * std::atan2(s, p.w()) / s * v;
}

Vector3 spin(const Body& body, const Motion& m) {
  return rotates(body) ? angular_velocity(body, m) : Vector3(Vector3::Zero());
}

// Cubic with values and slopes at both ends.
template <class V>
V cubic(const V& p0, const V& v0, const V& p1, const V& v1, Real h, Real x) {
  const V d = p1 - p0;
  return p0 + x * (h * v0 + x * (3 * d - h * (2 * v0 + v1) + x * (h * (v0 + v1) - 2 * d)));
}

}  // namespace

void Passage::set(const std::vector<Body>& bodies, std::size_t count, const Motion* start, const Motion* end,
                  Real span) {
  span_ = span;
  count_ = count;
  const std::size_t changed = legs_.size() == bodies.size() ? count : bodies.size();
  legs_.resize(bodies.size());
  for (std::size_t i = 0; i < changed; ++i) {
    Leg& leg = legs_[i];
    leg.start = start[i];
    leg.end = end[i];
    leg.moves = !bodies[i].locked;
    leg.p0 = start[i].position;
    leg.p1 = end[i].position;
    leg.v0 = velocity(bodies[i], start[i]);
    leg.v1 = velocity(bodies[i], end[i]);
    leg.w0 = spin(bodies[i], start[i]);
    leg.w1 = spin(bodies[i], end[i]);
    leg.turn = logarithm(end[i].orientation * start[i].orientation.conjugate());
    // A turn of more than half a revolution: the branch nearest to what the spins say.
    const Vector3 expected = span / 2 * (leg.w0 + leg.w1);
    const Real angle = leg.turn.norm();
    if (expected.norm() > 3 && angle > 0) {
      const Vector3 axis = leg.turn / angle;
      const Real whole = Real(2 * 3.14159265358979323846);
      leg.turn = (angle + whole * std::round((expected.dot(axis) - angle) / whole)) * axis;
    }
  }
}

void Passage::at(Real s, std::vector<Motion>& motion) const {
  ++looks_;
  const std::size_t changed = motion.size() == legs_.size() ? count_ : legs_.size();
  motion.resize(legs_.size());
  const Real x = span_ > 0 ? s / span_ : 0;
  for (std::size_t i = 0; i < changed; ++i) {
    const Leg& leg = legs_[i];
    motion[i] = x < Real(0.5) ? leg.start : leg.end;
    if (!leg.moves) continue;
    motion[i].position = cubic(leg.p0, leg.v0, leg.p1, leg.v1, span_, x);
    if (leg.turn.isZero(0)) continue;
    const Vector3 end_rate = inverse_dexp(leg.turn, leg.w1);
    const Vector3 zero = Vector3::Zero();
    motion[i].orientation =
        renormalised(exponential(cubic(zero, leg.w0, leg.turn, end_rate, span_, x)) * leg.start.orientation);
  }
}

Real Passage::speed_bound(const Candidate& c) const {
  const Leg& a = legs_[index(c.body)];
  Vector3 v0 = a.v0, v1 = a.v1, chord = a.p1 - a.p0;
  Real turning = std::max(a.w0.norm(), a.w1.norm()) * c.reach;
  if (c.other != fixed_world) {
    const Leg& b = legs_[index(c.other)];
    v0 -= b.v0, v1 -= b.v1, chord -= b.p1 - b.p0;
    turning += std::max(b.w0.norm(), b.w1.norm()) * c.other_reach;
  }
  return Real(1.5) * (std::max({v0.norm(), v1.norm(), chord.norm() / span_}) + turning);
}

// A cubic is never faster than twice the largest of both end speeds and the mean speed.
Real Passage::farthest(std::size_t body, const Vector3& place) const {
  const Leg& leg = legs_[body];
  const Real way = 2 * std::max({span_ * leg.v0.norm(), span_ * leg.v1.norm(), (leg.p1 - leg.p0).norm()});
  return way + std::min((leg.p0 - place).norm(), (leg.p1 - place).norm());
}

bool Passage::stays_apart(const Candidate& c) const {
  if (c.other == fixed_world) return false;
  const Leg &a = legs_[index(c.body)], &b = legs_[index(c.other)];
  const Real reach = Real(1.001) * (c.reach + c.other_reach);
  const Real start = (a.p0 - b.p0).norm() - reach, end = (a.p1 - b.p1).norm() - reach;
  return start > 0 && end > 0 && start + end > speed_bound(c) * span_;
}

Real Passage::change_bound(const Candidate& c) const {
  const auto part = [&](const Leg& leg, Real reach) {
    const Real w = std::max(leg.w0.norm(), leg.w1.norm());
    return (leg.v1 - leg.v0).norm() / span_ + reach * (w * w + (leg.w1 - leg.w0).norm() / span_);
  };
  Real sum = part(legs_[index(c.body)], c.centre.norm() + c.radius);
  if (c.centre.isZero(0) && c.kind == Candidate::Kind::corner) sum = part(legs_[index(c.body)], 0);
  if (c.other != fixed_world) {
    sum += part(legs_[index(c.other)], c.other_reach);
    const Real v = speed_bound(c);
    sum += v * v / std::max(c.radius, std::numeric_limits<Real>::min());
  }
  return 2 * sum;
}

std::optional<Bracket> first_closing(const Candidate& c, const Model& model, const Passage& passage,
                                     Real from, Real start_rate, Real margin, std::vector<Motion>& scratch) {
  const Real span = passage.span();
  const auto gap = [&](Real s) {
    passage.at(s, scratch);
    return gap_of(c, model, scratch.data());
  };
  const Real v = passage.speed_bound(c);
  const bool smooth = c.kind != Candidate::Kind::general;
  const Real b = smooth ? passage.change_bound(c) : 0;
  Real g_from = gap(from);
  const Real g_end = gap(span);
  if (g_from + g_end - v * (span - from) > 0) return std::nullopt;
  if (from == 0 && smooth && g_from <= 2 * margin && start_rate > 0) {  // just parted: not back before this
    from = b > 0 ? std::min(span, Real(1.9) * start_rate / b) : span;
    if (from >= span) return g_end < -margin ? std::optional(Bracket{span, span}) : std::nullopt;
    g_from = std::max(gap(from), Real(0));
  }

  struct Part {
    Real a, g_a, b, g_b;
  };
  std::vector<Part> todo = {{from, g_from, span, g_end}};
  for (int looks = 0; !todo.empty() && looks < most_looks; ++looks) {
    const Part p = todo.back();
    todo.pop_back();
    const Real w = p.b - p.a;
    const bool apart =
        p.g_a + p.g_b - v * w > 0 || (smooth && std::min(p.g_a, p.g_b) - b * w * w / 8 > -margin);
    if (apart) continue;
    const bool narrow = w < span / 16 || looks > most_looks / 2;
    if (narrow && p.g_a >= -margin && p.g_b < -margin) return Bracket{p.a, p.b};
    if (narrow && p.g_a < -margin && p.g_b < -margin) continue;
    if (w < span * 64 * std::numeric_limits<Real>::epsilon()) continue;
    const Real middle = p.a + w / 2, g = gap(middle);
    todo.push_back({middle, g, p.b, p.g_b});
    todo.push_back({p.a, p.g_a, middle, g});
  }
  if (g_end < -margin) return Bracket{from, span};
  return std::nullopt;
}

}  // namespace cylon::engine
