// The joints of a scene as an engine of reduced coordinates has them: a forest of bodies that hang from each other,
// and what closes loops.  Knows no engine.
#pragma once

#include "harness/core/scene.h"

#include <cstddef>
#include <vector>

namespace cylon::applied {

/// How a moving body hangs: by a joint of the scene from its parent, or freely from the world.
struct Node {
  int body = 0;
  int joint = -1;             ///< Of the scene's; -1: six degrees of freedom.
  int parent = core::world;   ///< A moving body; the world for what hangs from the world or a locked body.
  std::vector<int> children;  ///< Bodies, in the order in which they were found.
  int depth = 1;              ///< Bodies from the world to this one.
};

struct Forest {
  std::vector<Node> nodes;         ///< By body; locked bodies are alone, without a joint, at depth 1.
  std::vector<int> roots;          ///< Moving bodies that hang from the world, by joints first.
  std::vector<std::size_t> loops;  ///< Joints that are constraints: what closes loops, and distances.
};

/// Bodies that joints hang from the world come first, each as near to it as its joints allow; a mechanism that
/// floats has its body of the lowest index as root.  Joints between two locked ends hold nothing and are left out.
Forest forest_of(const core::Scene&);

}  // namespace cylon::applied
