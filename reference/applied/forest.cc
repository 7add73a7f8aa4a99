#include "reference/applied/forest.h"

#include <deque>

namespace cylon::applied {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Grow {
 public:
  explicit Grow(const core::Scene& scene)
      : scene_(scene), joints_of_(scene.bodies.size()), found_(scene.bodies.size()) {
    forest_.nodes.resize(scene.bodies.size());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) forest_.nodes[i].body = static_cast<int>(i);
    for (std::size_t j = 0; j < scene.joints.size(); ++j)
      for (const int end : {scene.joints[j].body, scene.joints[j].to})
        if (moves(end)) joints_of_[at(end)].push_back(static_cast<int>(j));
    used_.resize(scene.joints.size());
  }

  Forest forest() {
    for (std::size_t j = 0; j < scene_.joints.size(); ++j) {
      const core::Joint& joint = scene_.joints[j];
      if (!is_tree_joint(joint) || moves(joint.body) == moves(joint.to)) continue;
      const int body = moves(joint.body) ? joint.body : joint.to;
      if (!found_[at(body)]) hang(body, static_cast<int>(j), core::world);
    }
    spread();
    for (std::size_t i = 0; i < scene_.bodies.size(); ++i) {
      if (found_[i] || scene_.bodies[i].locked) continue;
      hang(static_cast<int>(i), -1, core::world);
      spread();
    }
    for (std::size_t j = 0; j < scene_.joints.size(); ++j)
      if (!used_[j] && (moves(scene_.joints[j].body) || moves(scene_.joints[j].to)))
        forest_.loops.push_back(j);
    return std::move(forest_);
  }

 private:
  bool moves(int i) const { return i != core::world && !scene_.bodies[at(i)].locked; }

  static bool is_tree_joint(const core::Joint& joint) { return !core::kind_of(joint.type).joins_centres(); }

  void hang(int body, int joint, int parent) {
    Node& node = forest_.nodes[at(body)];
    node.joint = joint, node.parent = parent;
    if (parent == core::world)
      forest_.roots.push_back(body);
    else
      forest_.nodes[at(parent)].children.push_back(body), node.depth = forest_.nodes[at(parent)].depth + 1;
    if (joint >= 0) used_[at(joint)] = true;
    found_[at(body)] = true;
    edge_.push_back(body);
  }

  void spread() {
    for (; !edge_.empty(); edge_.pop_front()) {
      const int body = edge_.front();
      for (const int j : joints_of_[at(body)]) {
        const core::Joint& joint = scene_.joints[at(j)];
        const int other = joint.body == body ? joint.to : joint.body;
        if (is_tree_joint(joint) && moves(other) && !found_[at(other)]) hang(other, j, body);
      }
    }
  }

  const core::Scene& scene_;
  Forest forest_;
  std::vector<std::vector<int>> joints_of_;
  std::vector<bool> found_, used_;
  std::deque<int> edge_;
};

}  // namespace

Forest forest_of(const core::Scene& scene) { return Grow(scene).forest(); }

}  // namespace cylon::applied
