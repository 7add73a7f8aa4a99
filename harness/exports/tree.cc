#include "harness/exports/tree.h"

#include "harness/core/joint_coordinates.h"

namespace cylon::exports {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool hangs_on(const std::vector<Link>& links, int body, int on) {
  for (; body != core::world; body = links[at(body)].parent)
    if (body == on) return true;
  return false;
}

}  // namespace

Tree tree_of(const core::Scene& scene) {
  Tree tree;
  tree.links.resize(scene.bodies.size());
  const auto carry = [&](std::size_t i) {
    const core::Joint& joint = scene.joints[i];
    Link& link = tree.links[at(joint.body)];
    const bool locked = joint.to != core::world && scene.bodies[at(joint.to)].locked;
    const int parent = locked ? core::world : joint.to;
    if (joint.type == core::JointType::fixed || link.joint >= 0 || hangs_on(tree.links, parent, joint.body))
      tree.loops.push_back(static_cast<int>(i));
    else
      link.joint = static_cast<int>(i), link.parent = parent;
  };
  for (const bool balls : {false, true})
    for (std::size_t i = 0; i < scene.joints.size(); ++i)
      if (core::is_ball(scene.joints[i]) == balls) carry(i);
  for (std::size_t i = 0; i < tree.links.size(); ++i) {
    const int parent = tree.links[i].parent;
    (parent == core::world ? tree.roots : tree.links[at(parent)].children).push_back(static_cast<int>(i));
  }
  return tree;
}

}  // namespace cylon::exports
