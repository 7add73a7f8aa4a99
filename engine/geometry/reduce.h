// Thins contact points to a manifold's capacity.
#pragma once

#include "engine/geometry/manifold.h"

namespace cylon::engine {

/// Takes contact points one after another and keeps a manifold's worth: the deepest, and the outermost in
/// seven directions about the normal, spaced evenly.  Up to the capacity all are kept, in their order.
class Reduction {
 public:
  explicit Reduction(const Vector3& normal);

  void add(const ContactPoint&);

  /// The normal of the points, and those that stay, in the order in which they came.
  Manifold result() const;

 private:
  static constexpr int slots = Manifold::capacity;

  struct Held {
    ContactPoint point;
    int order = -1;
    Real rank = 0;
  };

  Manifold all_;  // while they fit
  int seen_ = 0;
  std::array<Vector3, slots - 1> directions_;
  std::array<Held, slots> best_;  // the last: the deepest
};

}  // namespace cylon::engine
