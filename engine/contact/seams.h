// Surfaces made of several locked shapes: where they meet, the edges and faces inside are no surface.
#pragma once

#include "engine/model.h"

#include <vector>

namespace cylon::engine {

class Seams {
 public:
  /// O(n^2) in the locked bodies that touch something, of which few meet.
  explicit Seams(const Model&);

  /// Whether a contact on the surface of `other`, at x with the unit normal n out of it, is inside the surface
  /// that it makes with another locked shape T.  It is where T reaches beyond the plane through x across n,
  /// and holds x, or the point of `other` a little nearer to `centre`, a point of the body that touches:
  /// beside a wall a floor is free towards the body, and the wall is; a face that another covers is not.
  bool covers(int other, const Vector3& x, const Vector3& n, const Vector3& centre) const;

 private:
  const Shape& shape(int body) const { return shapes_[static_cast<std::size_t>(body)]; }

  std::vector<Shape> shapes_;
  std::vector<Motion> motions_;
  std::vector<std::vector<int>> beside_;  // per body: the locked ones that a locked one touches
  Real size_ = 0;                         // of the shapes [m]
};

}  // namespace cylon::engine
