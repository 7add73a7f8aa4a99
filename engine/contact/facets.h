// Which facets of two convex shapes touch at a point, and how that point goes on while both move.
#pragma once

#include "engine/contact/touch.h"
#include "engine/geometry/pose.h"

namespace cylon::engine {

/// A vertex, an edge or a face of a shape's core (engine/geometry/core.h), body axes.
struct Facet {
  enum class Kind { vertex, edge, face };
  Kind kind = Kind::vertex;
  Vector3 at = Vector3::Zero();      ///< The vertex, the middle of the edge, a point of the face [m].
  Vector3 along = Vector3::UnitX();  ///< Unit, of an edge.
  Real half = 0;                     ///< Of an edge's length [m].
  int face = -1;  ///< The face, or one beside the vertex or edge across the normal; -1: none.
};

/// A facet of `body` and one of `other`, and the law of the normal n between them.  The law is the same if the
/// two change places.
struct FacetPair {
  enum class Law {
    face_of_other,  ///< n is normal to a face of `other`, above which a point of `body` is.
    face_of_body,   ///< The other way round.
    edges,          ///< n is normal to both edges: e_a x e_b.
    round,          ///< n is along the shortest way between two points or edges with radii.
    flush           ///< Vertices that meet, or edges that are parallel: n turns with the mean of the two.
  };
  Law law = Law::face_of_other;
  Facet body, other;
  Vector3 normal = Vector3::UnitY(), other_normal = Vector3::UnitY();  ///< n in the axes of either.
};

/// The facets that touch at x with the normal n and the gap g, world axes.
FacetPair facets_at(const Shape& body, const Pose&, const Shape& other, const Pose& other_pose,
                    const Vector3& x, const Vector3& n, Real gap);

/// The touch now.  With c_a, c_b the nearest points of the cores, s = n.(c_a - c_b), v and W of what is there:
///   g = s - r_a - r_b,   g'' = n.(c_a'' - c_b'') + 2 n'.(v_a - v_b) - s |n'|^2  (of the velocities alone),
///   n' = W x n for a face;  edges: the part across n of (e_a x e_b)'/|e_a x e_b|;
///   round: W x n + (the part of v_a - v_b - W x (c_a - c_b) across n and the edge)/s, W of the edge.
/// Fills normal, gap, position, path, turning and curvature.
void place_touch(const FacetPair&, const Body&, const Motion&, Real radius, const Body& other,
                 const Motion& other_motion, Real other_radius, TouchPoint&);

/// Bounds over a span of time on how fast both bodies turn [rad/s], and on the relative speed of their surfaces
/// [m/s].
struct Turning {
  Real body = 0, other = 0, speed = 0;
};

/// Whether nothing but the facets can touch within a span [s], if these do all the time.  The cores lie on the two
/// sides of the planes across n through the facets as long as  f_i = n.(x_i - x) > 0  for all vertices x_i beside
/// the facet at x, and
///   2 f_i >= f_i(0) + f_i(span) - |x_i - x| (|W| + |n'|) span.
bool only_facets_touch(const FacetPair&, const Shape& body, const Shape& other, const Motion& start,
                       const Motion& end, const Motion& other_start, const Motion& other_end,
                       const Turning& bounds, Real span);

/// How far the touch is from leaving its facets [m], with some slack: at less than zero other facets touch.
Real room_on(const FacetPair&, const Shape& body, const Pose&, const Shape& other, const Pose& other_pose);

}  // namespace cylon::engine
