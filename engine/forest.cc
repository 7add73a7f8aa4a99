#include "engine/forest.h"

#include <algorithm>
#include <cstddef>
#include <functional>

namespace cylon::engine {

std::vector<Hung> forest(const Model& model) {
  std::vector<std::vector<const Joint*>> joints(model.bodies.size());
  std::vector<char> found(model.bodies.size(), 0);
  std::vector<Hung> hung;
  std::size_t holding = 0, used = 0;
  const auto take = [&](int body, int parent, const Joint* joint) {
    hung.push_back({body, parent, joint});
    found[index(body)] = 1;
    used += joint != nullptr;
  };
  for (const Joint& joint : model.joints) {
    if (!model.moves(joint.body) && !model.moves(joint.to)) continue;
    ++holding;
    for (const int end : {joint.body, joint.to})
      if (model.moves(end)) joints[index(end)].push_back(&joint);
  }
  const auto spread = [&](std::size_t from) {
    for (; from < hung.size(); ++from) {
      const int parent = hung[from].body;
      for (const Joint* joint : joints[index(parent)]) {
        const int other = joint->body == parent ? joint->to : joint->body;
        if (model.moves(other) && !found[index(other)]) take(other, parent, joint);
      }
    }
  };
  for (const Joint& joint : model.joints) {
    if (model.moves(joint.body) == model.moves(joint.to)) continue;
    const int body = model.moves(joint.body) ? joint.body : joint.to;
    if (!found[index(body)]) take(body, joint.body == body ? joint.to : joint.body, &joint);
  }
  spread(0);
  // The heaviest body of a tree in space is its root: on the spin of a light one the rounding of forces on heavy ones far away
  // would act.
  std::vector<int> free;
  for (std::size_t i = 0; i < model.bodies.size(); ++i)
    if (!found[i] && !model.bodies[i].locked) free.push_back(static_cast<int>(i));
  std::ranges::stable_sort(free, std::ranges::greater(), [&](int i) { return model.bodies[index(i)].mass; });
  for (const int root : free) {
    if (found[index(root)]) continue;
    take(root, fixed_world, nullptr);
    spread(hung.size() - 1);
  }
  if (used != holding) return {};
  return hung;
}

}  // namespace cylon::engine
