// A frustum as a polytope that is exact where it touches another shape.
#pragma once

#include "engine/geometry/pose.h"
#include "engine/geometry/touch.h"

#include <array>
#include <limits>
#include <optional>

namespace cylon::engine {

/// A polytope between a frustum and the one inscribed with 16 corners: where the other shape is nearest, or deepest
/// inside, it has a facet tangent to the side of the frustum, 2e-7 of the radius wide (float: 2e-3).  There the normal
/// is exact, and the depth to 5e-15 of the radius (float: 5e-7).  The facets are found by asking touch() until the gap
/// is the frustum's: that of the polytope is an upper bound, and what the plane with the touch's normal has between the
/// two shapes a lower one, as  max n.x  of a frustum has a formula.
/// Any other convex shape is itself.
class Facetted {
 public:
  /// Keeps its shapes in storage of the thread: lives for one query, one at a time.  Two that are farther apart than
  /// `far` [m] stay as they are found.
  Facetted(const Shape& body, const Pose&, const Shape& other, const Pose& other_pose,
           Real far = std::numeric_limits<Real>::infinity());

  /// Where the two are as they were left; none for convex shapes that are themselves.
  const std::optional<Touch>& touch() const { return touch_; }

  /// A plane between the two leaves more than `far`, before any facet: the shapes are then as they were given.
  bool is_far() const { return is_far_; }

  const Shape& body() const { return *shapes_[0]; }
  const Shape& other() const { return *shapes_[1]; }
  /// Points nearer to each other than this are one [m].
  Real same() const { return same_; }

  static constexpr int most_rounds = 12;
  /// By how much the gap may be too large after the last of most_rounds [m]; 0: it is as exact as above.
  Real unsettled() const { return unsettled_; }

 private:
  std::array<const Shape*, 2> shapes_;
  std::optional<Touch> touch_;
  Real same_ = 0, unsettled_ = 0;
  bool is_far_ = false;
};

}  // namespace cylon::engine
