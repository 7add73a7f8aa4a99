// What of one polytope lies over a face of another.
#pragma once

#include "engine/geometry/core.h"
#include "engine/geometry/point_name.h"

#include <array>

namespace cylon::engine {

struct Corner {
  Vector3 x;          ///< On the incident core, in a's axes [m].
  Real gap;           ///< Over the face's plane [m].
  PointName feature;  ///< A vertex of the incident core, or what crosses there of both.
};

struct Patch {
  std::array<Corner, 256> corners;  // not initialised
  int count = 0;
  bool thinned = false;  ///< A face had more corners than are looked at.
};

/// The incident core's face that looks at the reference face most (the whole segment or point where it has
/// none), cut by the planes through the reference's edges that stand on its face.  I. Sutherland and
/// G. Hodgman, Reentrant polygon clipping, Comm. ACM 17 (1974) 32.  A corner within rounding of a side is
/// inside: an exact test loses it (errata 34).  on_a: the reference is a's face, else b's.
/// Faces with more than 120 corners are thinned evenly to that.
void clip(const Couple&, bool on_a, int face, Patch&);

}  // namespace cylon::engine
