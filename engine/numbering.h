// The bodies of a part of a model, and their places there.
#pragma once

#include "engine/body.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cylon::engine {

class Numbering {
 public:
  /// `bodies`: of the whole model, ascending.
  explicit Numbering(std::vector<int> bodies) : bodies_(std::move(bodies)) {}

  const std::vector<int>& bodies() const { return bodies_; }

  /// The place of a body in the part; the world stays the world.  Requires that the part has it.
  int operator()(int body) const {
    if (body == fixed_world) return fixed_world;
    return static_cast<int>(std::lower_bound(bodies_.begin(), bodies_.end(), body) - bodies_.begin());
  }

 private:
  std::vector<int> bodies_;
};

}  // namespace cylon::engine
