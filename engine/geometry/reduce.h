// Thins contact points to a manifold's capacity.
#pragma once

#include "engine/geometry/manifold.h"

namespace cylon::engine {

/// Takes contact points one after another and keeps a manifold's worth: the outermost in as many directions about the
/// normal, spaced evenly, and the deepest in place of the nearest of them where none of them is as deep.  Up to the
/// capacity all are kept, in their order.
class Reduction {
 public:
  /// The first direction is `first` across the normal, of which it must have some.  Fixed to the body of the points, the
  /// same points stay while it turns about the normal.
  Reduction(const Vector3& normal, const Vector3& first);

  void add(const ContactPoint&);

  /// The normal of the points, and those that stay, in the order in which they came.  Thinned where those that do not
  /// stay make the face wider by more than `spare` [m], in a direction of twice as many.
  Manifold result(Real spare = 0) const;

 private:
  static constexpr int slots = Manifold::capacity;
  static constexpr int looks = 2 * slots;  // directions in which the width is known

  struct Held {
    ContactPoint point;
    int order = -1;
    Real rank = 0;
  };

  Vector3 first_;
  Manifold all_;  // while they fit
  int seen_ = 0;
  std::array<Vector3, looks> directions_;  // the even ones are those of slots
  std::array<Real, looks> reach_{};        // of all points, from the first
  std::array<Held, slots> best_;
  Held deepest_;
};

/// The first direction of a Reduction of points of a polytope, fixed to it (own axes): skew to edges and diagonals, as
/// corners between which rounding chooses would change from step to step.
Vector3 skew_direction(const Vector3& normal);

/// The tilt against the normal [rad] below which a disc is level to rounding.
constexpr Real level_disc = 64 * epsilon;

/// Where the points of a shape's disc begin, and the first direction of a Reduction of its points (own axes), with the
/// normal in own axes: towards the lowest of the disc.  A disc that is level to rounding has no lowest point: x.
Vector3 down_on_disc(const Vector3& normal);

}  // namespace cylon::engine
