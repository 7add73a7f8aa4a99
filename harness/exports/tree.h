// The joints of a scene as a tree of bodies and what closes loops in it, as MJCF has them: a ball or a fixed joint may be
// an equality constraint, no other; and a body that a fixed joint carried would be a part of its parent.
#pragma once

#include "harness/core/scene.h"

#include <vector>

namespace cylon::exports {

/// What carries a body.
struct Link {
  int parent = core::world;
  int joint = -1;  ///< In Scene::joints; -1: none, the body is free, or locked.
  std::vector<int> children;
};

struct Tree {
  std::vector<Link> links;  ///< One per body.
  std::vector<int> roots;   ///< Bodies on the world.
  std::vector<int> loops;   ///< Joints that carry no body.
};

/// Each joint that is not fixed carries its `body`, unless another does or the body would hang on itself; balls come last.
Tree tree_of(const core::Scene&);

}  // namespace cylon::exports
