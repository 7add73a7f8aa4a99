#include "engine/pile/rest.h"

namespace cylon::engine::pile {

bool stands_on_a_line(int body, const Group& group, const std::vector<Block>& blocks, Real size) {
  const Real near = size / 1000;
  Vector3 first = Vector3::Zero(), along = Vector3::Zero();
  int points = 0;
  for (const int k : group.blocks) {
    const Block& block = blocks[static_cast<std::size_t>(k)];
    if (block.kind != Block::Kind::contact || (block.a != body && block.b != body)) continue;
    const Vector3& point = block.a == body ? block.anchor : block.to_anchor;
    if (points++ == 0) first = point;
    const Vector3 from_first = point - first;
    if (along.isZero(0)) {
      if (from_first.norm() > near) along = from_first.normalized();
    } else if (along.cross(from_first).norm() > near) {
      return false;
    }
  }
  return points > 0;
}

}  // namespace cylon::engine::pile
