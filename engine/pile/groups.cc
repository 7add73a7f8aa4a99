#include "engine/pile/groups.h"

#include <algorithm>
#include <numeric>

namespace cylon::engine::pile {

std::vector<Group> find_groups(const std::vector<Block>& blocks, const std::vector<Mover>& movers) {
  std::vector<int> root(movers.size());
  std::iota(root.begin(), root.end(), 0);
  const auto find = [&](int i) {
    while (root[index(i)] != i) i = root[index(i)] = root[index(root[index(i)])];
    return i;
  };
  const auto is_moving = [&](int body) { return body != fixed_world && moves(movers[index(body)]); };
  for (const Block& block : blocks) {
    if (!is_moving(block.a) || !is_moving(block.b)) continue;
    const int a = find(block.a), b = find(block.b);
    root[index(std::max(a, b))] = std::min(a, b);
  }
  std::vector<Group> groups;
  std::vector<int> group_of(movers.size(), -1);
  std::vector<char> touches(movers.size(), 0),
      holds(movers.size(), 0);  // a moving body; a group, what is locked
  for (std::size_t k = 0; k < blocks.size(); ++k) {
    const int mover = is_moving(blocks[k].a) ? blocks[k].a : blocks[k].b;
    if (!is_moving(mover)) continue;
    int& group = group_of[index(find(mover))];
    if (group < 0) group = static_cast<int>(groups.size()), groups.emplace_back();
    groups[index(group)].blocks.push_back(static_cast<int>(k));
    for (const int body : {blocks[k].a, blocks[k].b}) {
      if (is_moving(body)) {
        touches[index(body)] = 1;
      } else if (body != fixed_world) {
        groups[index(group)].bodies.push_back(body), holds[index(group)] = 1;
      }
    }
  }
  for (std::size_t i = 0; i < movers.size(); ++i)
    if (touches[i])
      groups[index(group_of[index(find(static_cast<int>(i)))])].bodies.push_back(static_cast<int>(i));
  for (std::size_t g = 0; g < groups.size(); ++g) {
    if (!holds[g]) continue;  // in order already
    std::vector<int>& bodies = groups[g].bodies;
    std::sort(bodies.begin(), bodies.end());
    bodies.erase(std::unique(bodies.begin(), bodies.end()), bodies.end());
  }
  return groups;
}

void GroupLists::gather(const Group& group, const std::vector<Block>& all_blocks,
                        const std::vector<Body>& all_bodies, const std::vector<Mover>& all_movers,
                        const std::vector<Motion>& all_motions) {
  const auto place = [&](int body) {
    if (body == fixed_world) return fixed_world;
    return static_cast<int>(std::lower_bound(group.bodies.begin(), group.bodies.end(), body) -
                            group.bodies.begin());
  };
  blocks.clear(), bodies.clear(), movers.clear(), motions.clear();
  for (const int k : group.blocks) {
    blocks.push_back(all_blocks[index(k)]);
    blocks.back().a = place(blocks.back().a), blocks.back().b = place(blocks.back().b);
  }
  for (const int body : group.bodies) {
    bodies.push_back(all_bodies[index(body)]);
    movers.push_back(all_movers[index(body)]);
    motions.push_back(all_motions[index(body)]);
  }
}

}  // namespace cylon::engine::pile
