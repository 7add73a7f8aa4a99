#include "engine/contact/passage.h"

#include "engine/geometry/core.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace cylon::engine {

namespace {

// Of a pair that grazes along, parts narrower than this one of the span are not searched further.
constexpr Real least_part = Real(1) / 128, least_corner_part = Real(1) / (1 << 20);

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

// d/ds of that, s = h x.
template <class V>
V slope(const V& p0, const V& v0, const V& p1, const V& v1, Real h, Real x) {
  const V d = (p1 - p0) / h;
  return v0 + x * (2 * (3 * d - 2 * v0 - v1) + x * 3 * (v0 + v1 - 2 * d));
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

//   K(x) = (1 - x)(1 - 3x) K_0 + x(3x - 2) K_1 + 6x(1 - x) m (p_1 - p_0)/h:  the derivative of the cubic, in momenta;
// of the turn the same, with the mean of the inertia at both ends.
void Passage::momenta_at(Real s, const std::vector<Body>& bodies, std::vector<Motion>& motion) const {
  if (!(span_ > 0)) return;
  const Real x = s / span_, rest = 1 - x;
  const Real first = rest * (rest - 2 * x), last = x * (x - 2 * rest), mean = 6 * x * rest / span_;
  for (std::size_t i = 0; i < count_; ++i) {
    const Leg& leg = legs_[i];
    const Body& body = bodies[i];
    if (!leg.moves) continue;
    if (!body.pinned)
      motion[i].momentum =
          first * leg.start.momentum + last * leg.end.momentum + mean * body.mass * (leg.p1 - leg.p0);
    if (!body.turns) continue;
    const auto carried = [&](const Motion& end) {
      const Matrix3 r = end.orientation.toRotationMatrix();
      return Vector3(r * (body.inertia * (r.transpose() * leg.turn)));
    };
    motion[i].angular_momentum = first * leg.start.angular_momentum + last * leg.end.angular_momentum +
                                 mean / 2 * (carried(leg.start) + carried(leg.end));
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

Real Passage::spin_bound(std::size_t body) const {
  const Leg& leg = legs_[body];
  return leg.moves ? Real(1.5) * std::max({leg.w0.norm(), leg.w1.norm(), leg.turn.norm() / span_}) : 0;
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

// Bounds on the derivatives along the way of a body: of its place, d[k], and of its rotation matrix, r[k].
struct Passage::Growth {
  std::array<Real, 5> d{}, r{};
};

// The rotation vector theta goes as a cubic, theta' as a quadratic with the values b_0, b_2 at the ends and the
// mean (b_0 + b_1 + b_2)/3; a quadratic is no longer than the longest of its three.  Of R = exp(theta) R_0:
//   |R'| <= a_1,  |R''| <= a_1^2 + a_2,  ...  (Bell's polynomials), a_k the bound on theta's derivatives.
Passage::Growth Passage::growth(const Leg& leg) const {
  const auto bounds = [&](const Vector3& b_0, const Vector3& mean, const Vector3& b_2) {
    const Vector3 b_1 = 3 * mean - b_0 - b_2;
    const Real first = 2 / span_ * (b_1 - b_0).norm(), second = 2 / span_ * (b_2 - b_1).norm();
    return std::array<Real, 3>{std::max({b_0.norm(), b_1.norm(), b_2.norm()}), std::max(first, second),
                               2 / (span_ * span_) * (b_2 - 2 * b_1 + b_0).norm()};
  };
  Growth g;
  g.r[0] = 1;
  if (!leg.moves) return g;
  const auto [v, a, j] = bounds(leg.v0, (leg.p1 - leg.p0) / span_, leg.v1);
  g.d = {0, v, a, j, 0};
  const Vector3 end_rate = leg.turn.isZero(0) ? Vector3(Vector3::Zero()) : inverse_dexp(leg.turn, leg.w1);
  const auto [w, w1, w2] = bounds(leg.turn.isZero(0) ? end_rate : leg.w0, leg.turn / span_, end_rate);
  g.r = {1, w, w * w + w1, w * w * w + 3 * w * w1 + w2,
         w * w * w * w + 6 * w * w * w1 + 3 * w1 * w1 + 4 * w * w2};
  return g;
}

Passage::Place Passage::place(const Leg& leg, Real s) const {
  if (s <= 0 || !leg.moves) return {leg.start.orientation.toRotationMatrix(), leg.p0, leg.v0, leg.w0};
  if (s >= span_) return {leg.end.orientation.toRotationMatrix(), leg.p1, leg.v1, leg.w1};
  const Real x = s / span_;
  Place result;
  result.p = cubic(leg.p0, leg.v0, leg.p1, leg.v1, span_, x);
  result.v = slope(leg.p0, leg.v0, leg.p1, leg.v1, span_, x);
  if (leg.turn.isZero(0)) {
    result.turn = leg.start.orientation.toRotationMatrix();
    return result;
  }
  // w = theta' + (1 - cos a)/a^2 theta x theta' + (a - sin a)/a^3 theta x (theta x theta'),  a = |theta|
  const Vector3 zero = Vector3::Zero(), end_rate = inverse_dexp(leg.turn, leg.w1);
  const Vector3 theta = cubic(zero, leg.w0, leg.turn, end_rate, span_, x);
  const Vector3 theta_rate = slope(zero, leg.w0, leg.turn, end_rate, span_, x);
  const Vector3 across = theta.cross(theta_rate);
  const Real a = theta.norm();
  const bool small = a < Real(1e-3);
  const Real c_1 = small ? Real(0.5) - a * a / 24 : (1 - std::cos(a)) / (a * a);
  const Real c_2 = small ? 1 / Real(6) - a * a / 120 : (a - std::sin(a)) / (a * a * a);
  result.w = theta_rate + c_1 * across + c_2 * theta.cross(across);
  result.turn = (exponential(theta) * leg.start.orientation).toRotationMatrix();
  return result;
}

bool Passage::stays_above(const Leg& carrier, const Shape& shape, const Leg& visitor, const Shape& above,
                          bool held, Real depth, Real begin, Real end) const {
  const Core below(shape), over(above);
  const Real radii = below.radius + over.radius;
  struct End {
    Place carrier, visitor;
  };
  const auto height = [&](const End& e, int face, const Vector3& vertex) {
    const Vector3 x = e.visitor.p + e.visitor.turn * vertex - e.carrier.p;
    return below.normals[face].dot(e.carrier.turn.transpose() * x - below.vertices[below.faces[face][0]]) -
           radii;
  };
  const auto rate = [&](const End& e, int face, const Vector3& vertex) {
    const Vector3 arm = e.visitor.turn * vertex, x = e.visitor.p + arm - e.carrier.p;
    const Vector3 seen = e.visitor.v + e.visitor.w.cross(arm) - e.carrier.v - e.carrier.w.cross(x);
    return (e.carrier.turn * below.normals[face]).dot(seen);
  };
  // f = n.R_c^T (D + R_v x), D the way between the two: products of their derivatives.
  const Growth c = growth(carrier), v = growth(visitor);
  constexpr std::array<Real, 5> binomial = {1, 4, 6, 4, 1};
  std::array<Real, 5> apart;
  apart[0] = (visitor.p0 - carrier.p0).norm() + span_ * (c.d[1] + v.d[1]);
  for (std::size_t k = 1; k < 5; ++k) apart[k] = c.d[k] + v.d[k];
  Real fourth = 0;
  for (std::size_t k = 0; k < 5; ++k)
    fourth += binomial[k] * c.r[k] * (apart[4 - k] + over.size * v.r[4 - k]);
  // So many parts that what is not known of each is half the depth.
  const Real all = end - begin, whole = all * all * all * all / 384 * fourth;
  const Real wanted = std::ceil(std::sqrt(std::sqrt(2 * whole / depth)));
  constexpr int most_parts = 16;  // where more are wanted the bound says nothing, and the search goes on
  if (!(wanted <= most_parts)) return false;
  const int parts = std::max(1, static_cast<int>(wanted));
  const Real n = static_cast<Real>(parts), width = all / n, curved = whole / (n * n * n * n);
  std::array<End, most_parts + 1> ends;
  for (int i = 0; i <= parts; ++i) {
    const Real s = i == parts ? end : begin + static_cast<Real>(i) * width;
    ends[static_cast<std::size_t>(i)] = {place(carrier, s), place(visitor, s)};
  }
  const auto stays = [&](int face) {
    for (int k = 0; k < over.vertex_count; ++k) {
      const Vector3& x = over.vertices[k];
      Real f = height(ends[0], face, x);
      const auto rests = [&](const End& e) {
        return std::max(std::abs(height(e, face, x)), all * std::abs(rate(e, face, x))) < depth;
      };
      if (held && rests(ends[0]) && rests(ends[static_cast<std::size_t>(parts)])) continue;
      for (int i = 0; i < parts; ++i) {
        const End &from = ends[static_cast<std::size_t>(i)], &to = ends[static_cast<std::size_t>(i) + 1];
        const Real g = height(to, face, x);
        if (!(std::min(f, g) - curved > -depth)) return false;
        const Real bent = std::min(f + width / 3 * rate(from, face, x), g - width / 3 * rate(to, face, x));
        if (!(bent - curved > -depth)) return false;
        f = g;
      }
    }
    return true;
  };
  for (int face = 0; face < below.face_count; ++face)
    if (stays(face)) return true;
  return false;
}

bool Passage::stays_on_face(const Candidate& c, const Model& model, bool held, Real depth, Real from,
                            Real to) const {
  if (c.kind != Candidate::Kind::general) return false;
  const std::size_t a = index(c.body), b = index(c.other);
  return stays_above(legs_[b], model.shapes[b], legs_[a], model.shapes[a], held, depth, from, to) ||
         stays_above(legs_[a], model.shapes[a], legs_[b], model.shapes[b], held, depth, from, to);
}

Real Passage::least_height(const Candidate& c, const Plane& plane, Real from, Real to) const {
  const Leg& leg = legs_[index(c.body)];
  const Real w = to - from;
  const auto end = [&](Real s, Real outward) {  // the lower one of f and of where its tangent is at w/3
    const Place place = this->place(leg, s);
    const Vector3 arm = place.turn * c.centre;
    const Real f = plane.normal.dot(place.p + arm) - plane.offset - c.radius;
    return std::min(f, f + outward * w / 3 * plane.normal.dot(place.v + place.w.cross(arm)));
  };
  const Real least = std::min(end(from, 1), end(to, -1));
  return least - w * w * w * w / 384 * c.centre.norm() * growth(leg).r[4];
}

std::optional<Bracket> first_closing(const Candidate& c, const Model& model, const Passage& passage,
                                     Real from, Real start_rate, Real margin, std::vector<Motion>& scratch,
                                     Real& unseen) {
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
  while (!todo.empty()) {
    const Part p = todo.back();
    todo.pop_back();
    const Real w = p.b - p.a;
    const bool apart =
        p.g_a + p.g_b - v * w > 0 || (smooth && std::min(p.g_a, p.g_b) - b * w * w / 8 > -margin);
    if (apart) continue;
    const bool corner = c.kind == Candidate::Kind::corner && std::min(p.g_a, p.g_b) > -margin;
    const Real height = corner ? passage.least_height(c, model.planes[index(c.plane)], p.a, p.b) : 0;
    if (corner && height > -margin) continue;
    const bool narrow = w < span / 16;
    if (narrow && !smooth && std::min(p.g_a, p.g_b) > -margin &&
        passage.stays_on_face(c, model, false, margin, p.a, p.b))
      continue;
    if (narrow && p.g_a >= -margin && p.g_b < -margin) return Bracket{p.a, p.b};
    if (narrow && p.g_a < -margin && p.g_b < -margin) continue;
    // Else it may pass, in a part of this one.  What is no number grazes: it would be parted down to rounding everywhere.
    const bool grazes = !(std::max(p.g_a, p.g_b) >= v * w / 8);
    if ((w <= span * (corner ? least_corner_part : least_part) && grazes) || w < span * 64 * epsilon) {
      const Real by_rate = (v * w - p.g_a - p.g_b) / 2, by_change = b * w * w / 8 - std::min(p.g_a, p.g_b);
      unseen = std::max(unseen, corner ? -height : smooth ? std::min(by_rate, by_change) : by_rate);
      continue;
    }
    const Real middle = p.a + w / 2, g = gap(middle);
    todo.push_back({middle, g, p.b, p.g_b});
    todo.push_back({p.a, p.g_a, middle, g});
  }
  if (g_end < -margin) return Bracket{from, span};
  return std::nullopt;
}

}  // namespace cylon::engine
