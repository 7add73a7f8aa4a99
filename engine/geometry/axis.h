// The direction along which two convex polytopes overlap least.
#pragma once

#include "engine/geometry/core.h"

#include <optional>

namespace cylon::engine {

/// A plane between two cores, in a's axes.
struct Axis {
  enum class Kind { none, face_a, face_b, edges };

  Real gap = 0;    ///< min_a n.x - max_b n.x [m].
  Vector3 normal;  ///< n: unit, from b to a.
  Kind kind = Kind::none;
  int a = -1, b = -1;  ///< The face, or the edges, that it belongs to.
  /// Of a face: the middle of what of the other core is deepest over it, or the deepest vertex where rounding leaves
  /// nothing over it: then not `reached`.
  Vector3 deepest;
  bool reached = false;
};

/// The axis of greatest gap among the normals of the faces of the difference a - b: faces of a, faces of b,
/// and edges of a across edges of b where their arcs on the sphere of normals cross.  Where the two overlap
/// that is minus the penetration depth; where they are apart, a lower bound of the distance.  A plane is only
/// found good after all vertices of both were asked (seed eq. 103 asks one, errata 35), so an ill-conditioned
/// edge pair never makes a gap too large.  Faces win ties, to rounding.
/// `reach` [m]: at least the distance where the two may be apart; edges farther than it are left out.
/// D. Gregorius, The Separating Axis Test between Convex Polyhedra, GDC 2013.
Axis widest_axis(const Couple&, Real reach);

/// The same of two that overlap beyond rounding, where that is sure without nearest(): where what is deepest over the best
/// face is inside the other core.
std::optional<Axis> axis_of_overlap(const Couple&);

}  // namespace cylon::engine
