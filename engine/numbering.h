// The bodies of a part of a model, or all of them in another order, and their places there.
#pragma once

#include "engine/body.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace cylon::engine {

class Numbering {
 public:
  /// `bodies`: of the whole model, each at most once.
  explicit Numbering(std::vector<int> bodies) : bodies_(std::move(bodies)) {
    for (std::size_t i = 0; i < bodies_.size(); ++i) places_.emplace_back(bodies_[i], static_cast<int>(i));
    std::sort(places_.begin(), places_.end());
  }

  const std::vector<int>& bodies() const { return bodies_; }

  /// The place of a body in the part; the world stays the world.  Requires that the part has it.
  int operator()(int body) const {
    if (body == fixed_world) return fixed_world;
    return std::lower_bound(places_.begin(), places_.end(), std::pair(body, 0))->second;
  }

 private:
  std::vector<int> bodies_;
  std::vector<std::pair<int, int>> places_;  // body, place; ascending
};

}  // namespace cylon::engine
