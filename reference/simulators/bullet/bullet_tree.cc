#include "reference/simulators/bullet/bullet_tree.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

namespace cylon::simulators {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

bool still(const core::Scene& scene, int body) {
  return body == core::world || scene.bodies[at(body)].locked;
}

core::JointCoordinate coordinate_of(const core::Joint& joint) {
  if (!joint.displacements.empty()) return joint.displacements[0];
  if (!joint.angles.empty()) return joint.angles[0];
  return {};
}
bool resisted(const core::Joint& joint) {
  bool found = false;
  core::for_each_coordinate(
      joint, [&](const core::JointCoordinate& c) { found |= core::has_limit(c) || c.friction != 0; });
  return found;
}

Tree tree_of(const core::Scene& scene, int first) {
  Tree tree;
  std::vector<bool> used(scene.joints.size(), false);
  const auto in_tree = [&](int body) {
    return std::find(tree.bodies.begin(), tree.bodies.end(), body) != tree.bodies.end();
  };
  // Bodies that joints connect with those before, breadth first.
  const auto grow = [&] {
    for (std::size_t i = 0; i < tree.bodies.size(); ++i)
      for (std::size_t j = 0; j < scene.joints.size(); ++j) {
        const core::Joint& joint = scene.joints[j];
        const int here = tree.bodies[i];
        if (used[j] || (joint.body != here && joint.to != here)) continue;
        const int there = joint.body == here ? joint.to : joint.body;
        used[j] = true;
        if (still(scene, there) || in_tree(there)) {
          tree.loops.push_back(static_cast<int>(j));
        } else {
          tree.bodies.push_back(there);
          tree.places.push_back({static_cast<int>(j), here});
        }
      }
  };
  tree.bodies = {first}, tree.places = {{}};
  grow();
  // Of the joints to what stands still, the first becomes the root's.
  const auto to_world = std::find_if(tree.loops.begin(), tree.loops.end(), [&](int j) {
    return still(scene, scene.joints[at(j)].body) || still(scene, scene.joints[at(j)].to);
  });
  if (to_world == tree.loops.end()) return tree;
  const int root_joint = *to_world;
  const core::Joint& joint = scene.joints[at(root_joint)];
  tree = {};
  used.assign(scene.joints.size(), false);
  used[at(root_joint)] = true;
  tree.bodies = {still(scene, joint.body) ? joint.to : joint.body};
  tree.places = {{root_joint, core::world}};
  grow();
  return tree;
}

namespace {

// Shows the tree of each moving body once, until `found` says true; whether it did.
bool any_tree(const core::Scene& scene, const std::function<bool(const Tree&)>& found) {
  std::vector<bool> seen(scene.bodies.size(), false);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (seen[i] || scene.bodies[i].locked) continue;
    const Tree tree = tree_of(scene, static_cast<int>(i));
    for (const int body : tree.bodies) seen[at(body)] = true;
    if (found(tree)) return true;
  }
  return false;
}

}  // namespace

bool has_loops(const core::Scene& scene) {
  return any_tree(scene, [](const Tree& tree) { return !tree.loops.empty(); });
}

bool all_hung(const core::Scene& scene) {
  return !any_tree(scene, [&](const Tree& tree) {
    const core::Body& root = scene.bodies[at(tree.bodies[0])];
    const core::Vector3 moments = core::principal_axes(root.inertia).moments;
    const bool no_torque =
        moments.maxCoeff() == moments.minCoeff() || root.initial.angular_velocity.isZero(0);
    const bool alone = tree.bodies.size() == 1;
    return !tree.loops.empty() || (tree.places[0].joint < 0 && !(alone && no_torque));
  });
}

namespace {

std::optional<std::string> untreelike(const core::Scene& scene, const core::Joint& joint, bool closes) {
  using core::JointType;
  const JointType type = joint.type;
  const std::string of =
      fmt::format("the {} joint of '{}'", core::kind_of(type).name, scene.bodies[at(joint.body)].name);
  if (closes && type == JointType::hinge)
    return "btMultiBody has no hinge constraint that closes a loop (BulletDynamics/Featherstone/, ball, "
           "fixed and "
           "slider), and this adapter makes none of two balls.";
  const bool is_ball = type == JointType::ball || type == JointType::gimbal;
  if (closes && !is_ball && type != JointType::fixed)
    return fmt::format(
        "This adapter closes loops of a btMultiBody by balls and fixed joints, and {} closes one.", of);
  if (type == JointType::cylindrical || type == JointType::universal || type == JointType::rectangular)
    return fmt::format(
        "btMultiBody has no joint of these two freedoms (BulletDynamics/Featherstone/btMultiBodyLink.h, "
        "eFeatherstoneJointType), and a link without mass between two is singular: {}.",
        of);
  if ((type == JointType::planar || type == JointType::gimbal) && resisted(joint))
    return fmt::format(
        "btMultiBody's limits and motors are of joints with one freedom "
        "(BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h); {} has some.",
        of);
  const core::JointCoordinate c = coordinate_of(joint);
  if (core::has_limit(c) && c.restitution > 0)
    return fmt::format(
        "btMultiBody's limits have no restitution "
        "(BulletDynamics/Featherstone/btMultiBodyJointLimitConstraint.h); {} has one.",
        of);
  return std::nullopt;
}

}  // namespace

std::optional<std::string> untreelike(const core::Scene& scene) {
  std::optional<std::string> reason;
  any_tree(scene, [&](const Tree& tree) {
    for (const int j : tree.loops)
      if (!reason) reason = untreelike(scene, scene.joints[at(j)], true);
    for (const TreePlace& place : tree.places)
      if (!reason && place.joint >= 0) reason = untreelike(scene, scene.joints[at(place.joint)], false);
    return reason.has_value();
  });
  return reason;
}

}  // namespace cylon::simulators
