// All the places where two shapes touch, or soon may.
#pragma once

#include "engine/geometry/part_boxes.h"
#include "engine/geometry/point_name.h"
#include "engine/geometry/separation.h"

#include <array>
#include <vector>

namespace cylon::engine {

struct ContactPoint {
  Vector3 position;       ///< Midway between the surfaces, world axes [m].
  Real gap = 0;           ///< Along the manifold's normal [m].
  PointName feature = 0;  ///< The same place keeps its name from step to step.
};

/// How a shape moves in the step to come.  Its turn about an axis of revolution moves no point of its surface out of
/// the surface: of a rim that is not its lowest, only points that the rest of the motion may bring to a plane count.
struct Travel {
  Vector3 move = Vector3::Zero();  ///< Of the origin of the pose [m].
  Vector3 turn = Vector3::Zero();  ///< [rad]
  Real spare = 0;                  ///< Beyond both [m].
};

struct Manifold {
  static constexpr int capacity = 8;

  Vector3 normal;  ///< Unit, world axes, from `other` to `body`.
  int count = 0;
  std::array<ContactPoint, capacity> points;
  bool thinned = false;  ///< There were more points than fit, and the face is wider than those that stay.
  Real unsettled =
      0;  ///< About how far gaps are off at a round body whose place was not found (Facetted) [m].
};

/// The points with gap < margin [m], where faces meet faces the corners of the common area; at least one
/// where separation().gap < margin.  More than the capacity are thinned: the outermost stay, evenly spaced in axes of the
/// shape that has them (of a disc from its lowest point on, as on a plane), and the deepest.
/// An edge that crosses an edge gives one point; where a face is within a tenth of the margin of being the
/// separating plane, it is taken in its place (so boxes that rest on one another do not lose corners to
/// rounding).
/// Of two convex shapes, or of any with a plane.
Manifold manifold(const Shape& body, const Pose&, const Shape& other, const Pose& other_pose, Real margin);
/// With a Travel, of a rim the lowest point, and those that come within its `spare` and a 256th of the rim's radius.
Manifold manifold(const Shape& body, const Pose&, const Plane& other, Real margin,
                  const Travel* travel = nullptr);

/// Of a part of `body` with one of `other`; numbers of parts as in each_part().
struct PartManifold {
  int part = 0, other_part = 0;
  Manifold manifold;
};

/// Of all pairs of convex parts of two shapes that touch.
void manifolds(const Shape& body, const PartBoxes&, const Pose&, const Shape& other,
               const PartBoxes& other_boxes, const Pose& other_pose, Real margin, std::vector<PartManifold>&);

/// Makes one manifold of those with the same normal: faces of several parts in one plane are one face.  More points than
/// fit are thinned in directions fixed to `frame`.
void join_faces(std::vector<PartManifold>&, const Pose& frame);

/// The point of a separation, where its gap < margin.
Manifold one_point(const Separation&, Real margin, PointName feature = 0);

}  // namespace cylon::engine
