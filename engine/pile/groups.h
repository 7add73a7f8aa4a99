// Groups of bodies that no contact or joint ties to another group: each is solved by itself.
#pragma once

#include "engine/pile/block.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace cylon::engine::pile {

/// Places in the lists of a whole pile, ascending.  Locked bodies are in every group that they touch.
struct Group {
  std::vector<int> bodies, blocks;
};

/// In the order of their first blocks.  Bodies without a block are in none.
std::vector<Group> find_groups(const std::vector<Block>&, const std::vector<Mover>&);

/// The lists of a group, numbered by its own bodies.
struct GroupLists {
  std::vector<Block> blocks;
  std::vector<Body> bodies;
  std::vector<Mover> movers;
  std::vector<Motion> motions;

  void gather(const Group&, const std::vector<Block>&, const std::vector<Body>&, const std::vector<Mover>&,
              const std::vector<Motion>&);
};

}  // namespace cylon::engine::pile
