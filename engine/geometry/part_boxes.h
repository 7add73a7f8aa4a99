// Which of the parts of a shape are near a box: for surfaces of many triangles.
#pragma once

#include "engine/geometry/pose.h"

#include <vector>

namespace cylon::engine {

/// The boxes of the convex parts of a shape, in its own axes, in order along the axis on which they spread most.
class PartBoxes {
 public:
  explicit PartBoxes(const Shape&);

  /// Of all parts.
  const Bounds& all() const { return all_; }
  const Bounds& of(int part) const { return boxes_[static_cast<std::size_t>(part)]; }

  /// The parts whose boxes meet the given one, ascending.
  void near(const Bounds&, std::vector<int>& parts) const;

 private:
  std::vector<Bounds> boxes_;
  Bounds all_;
  int axis_ = 0;
  std::vector<int> order_;  // by the lower end along the axis
  Real widest_ = 0;         // along the axis [m]
};

/// A box that holds a box of `from`, in the axes of `to`, with `margin` all around.
Bounds seen_from(const Pose& to, const Pose& from, const Bounds&, Real margin);

}  // namespace cylon::engine
