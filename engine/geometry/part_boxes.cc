#include "engine/geometry/part_boxes.h"

#include <algorithm>

namespace cylon::engine {

PartBoxes::PartBoxes(const Shape& shape) : all_(bounds(Shape(), Pose())) {
  each_part(shape, Pose(), [&](int, const Shape& part, const Pose& at) {
    boxes_.push_back(bounds(part, at));
    all_.low = all_.low.cwiseMin(boxes_.back().low), all_.high = all_.high.cwiseMax(boxes_.back().high);
  });
  (all_.high - all_.low).maxCoeff(&axis_);
  for (std::size_t i = 0; i < boxes_.size(); ++i) {
    order_.push_back(static_cast<int>(i));
    widest_ = std::max(widest_, boxes_[i].high[axis_] - boxes_[i].low[axis_]);
  }
  std::sort(order_.begin(), order_.end(), [&](int i, int k) {
    return of(i).low[axis_] != of(k).low[axis_] ? of(i).low[axis_] < of(k).low[axis_] : i < k;
  });
}

void PartBoxes::near(const Bounds& box, std::vector<int>& parts) const {
  parts.clear();
  const auto below = [&](int i, Real x) { return of(i).low[axis_] < x; };
  for (auto i = std::lower_bound(order_.begin(), order_.end(), box.low[axis_] - widest_, below);
       i != order_.end() && of(*i).low[axis_] <= box.high[axis_]; ++i)
    if ((of(*i).low.array() <= box.high.array()).all() && (box.low.array() <= of(*i).high.array()).all())
      parts.push_back(*i);
  std::sort(parts.begin(), parts.end());
}

Bounds seen_from(const Pose& to, const Pose& from, const Bounds& box, Real margin) {
  const Matrix3 turn = to.rotation.transpose() * from.rotation;
  const Vector3 half = turn.cwiseAbs() * ((box.high - box.low) / 2) + Vector3::Constant(margin);
  const Vector3 middle =
      to.rotation.transpose() * (from.position - to.position) + turn * ((box.high + box.low) / 2);
  return {middle - half, middle + half};
}

}  // namespace cylon::engine
