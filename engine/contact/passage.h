// Motion between two known states, and when two surfaces first meet on the way.
#pragma once

#include "engine/contact/candidate.h"

#include <cstdint>
#include <optional>
#include <span>

namespace cylon::engine {

/// Cubic in time through two states and their velocities; orientations by the rotation between the two.
/// O(h^4).  Serves to find out where to look; what is found is then computed by the integrator itself.
class Passage {
 public:
  /// Over a span [s] from `start` to `end`.  The bodies after the first `count` are locked, and always the same.
  void set(const std::vector<Body>&, std::size_t count, const Motion* start, const Motion* end, Real span);

  /// Positions, momenta and orientations after s, 0 <= s <= span; angular momenta are those of the nearer
  /// end.  Resizes; what has the size already has the motions of the locked bodies too.
  void at(Real s, std::vector<Motion>&) const;
  /// Sets the momenta of what moves, which at() leaves as they are at the nearer end: so that p' = K/m.
  void momenta_at(Real s, const std::vector<Body>&, std::vector<Motion>&) const;

  Real span() const { return span_; }
  /// How often at() was asked.
  std::int64_t looks() const { return looks_; }
  /// Whether the balls that hold two bodies tell that their surfaces stay apart all the way: with d the least
  /// gap that they leave and v speed_bound(),  d(0) + d(span) > v span.  False for planes.
  bool stays_apart(const Candidate&) const;
  /// A bound on how far a body is from a place at any time of the span [m].
  Real farthest(std::size_t body, const Vector3& place) const;
  /// Bounds on the speed of approach of any points of the two bodies [m/s], and on its change [m/s^2].
  Real speed_bound(const Candidate&) const;
  Real change_bound(const Candidate&) const;
  /// A bound on how fast a body turns [rad/s].
  Real spin_bound(std::size_t body) const;
  /// Whether one of two polytopes stays above one face of the other, by more than -depth [m], from one time to another: what
  /// rests or slides on a face does, at gap 0.  With f the height of a vertex of one over the face and w the time,
  ///   f >= min(f_0, f_0 + w f_0'/3, f_w - w f_w'/3, f_w) - w^4/384 max |f^(4)|,
  /// in up to 16 parts.  Of a pair that is `held`, vertices on the face at both ends are held there.
  bool stays_on_face(const Candidate&, const Model&, bool held, Real depth, Real from, Real to) const;
  /// A bound on the gap of a corner over its plane between two times of the span [m], f its height as above.
  Real least_height(const Candidate&, const Plane&, Real from, Real to) const;

 private:
  struct Leg {
    Vector3 p0, p1, v0, v1, turn, w0, w1;
    Motion start, end;
    bool moves = false;
  };
  struct Place {
    Matrix3 turn = Matrix3::Identity();
    Vector3 p = Vector3::Zero(), v = Vector3::Zero(), w = Vector3::Zero();
  };
  struct Growth;
  Place place(const Leg&, Real s) const;
  Growth growth(const Leg&) const;
  bool stays_above(const Leg& carrier, const Shape&, const Leg& visitor, const Shape& above, bool held,
                   Real depth, Real begin, Real end) const;

  std::vector<Leg> legs_;
  std::size_t count_ = 0;
  Real span_ = 0;
  mutable std::int64_t looks_ = 0;
};

struct Bracket {
  Real open = 0, closed = 0;  ///< g > 0 at the one, g < 0 at the other.
};

/// The first time from `from` on at which a candidate's gap falls below -margin, bracketed, or nothing. Parts
/// of the span are left out only where the gap cannot close: in them it lies above
///   (g_a + g_b - V w)/2   and, for one smooth point,   min(g_a, g_b) - B w^2/8,
/// V and B the bounds on the gap's rate and its change, w the width, or, of a corner, above least_height(); and where it
/// is closed at both ends of a short part.  `start_rate`: the gap's rate at 0 [m/s].  Parts of 1/128 of the span, of
/// corners of 1e-6 of it, are not searched further; `unseen` is raised to how deep the surfaces may be in each other in
/// one of them [m].
std::optional<Bracket> first_closing(const Candidate&, const Model&, const Passage&, Real from,
                                     Real start_rate, Real margin, std::vector<Motion>& scratch,
                                     Real& unseen);

}  // namespace cylon::engine
