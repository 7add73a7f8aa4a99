#include "harness/hunt/scene_parts.h"

#include "harness/core/fields.h"
#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <type_traits>
#include <vector>

namespace cylon::hunt {
namespace {

// Whether an element refers to a body; else its references move down past it.
template <class Element>
bool refers(Element& element, int gone) {
  bool found = false;
  const auto look_at = [&](int& body) {
    found = found || body == gone;
    if (body > gone) --body;
  };
  core::for_each_field(element, [&]<class Value>(const auto&, Value& value) {
    if constexpr (std::is_same_v<Value, int>) look_at(value);
    if constexpr (std::is_same_v<Value, std::vector<int>>) std::ranges::for_each(value, look_at);
  });
  return found;
}

}  // namespace

std::set<std::string> parts_without_shapes(const core::Scene& scene) {
  std::set<std::string> names;
  for (const core::Body& body : scene.bodies)
    if (body.locked) names.insert("locked body");
  for (const core::Force& force : scene.forces)
    std::visit([&]<class Kind>(const Kind&) { names.emplace(core::Element<Kind>::name); }, force);
  for (const core::Joint& joint : scene.joints) {
    names.emplace(core::kind_of(joint.type).name);
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
      if (core::has_force(c)) names.insert(core::target_moves(c) ? "servo" : "force along a joint");
      if (core::has_limit(c)) names.insert("stop");
      if (c.friction != 0) names.insert("friction in a joint");
    });
  }
  if (!scene.planes.empty()) names.insert("plane");
  if (scene.frame) names.insert("frame");
  for (const core::Material& material : scene.materials) {
    if (material.friction > 0) names.insert("friction");
    if (material.restitution > 0) names.insert("restitution");
  }
  return names;
}

std::set<std::string> parts(const core::Scene& scene) {
  std::set<std::string> names = parts_without_shapes(scene);
  for (const core::Body& body : scene.bodies)
    std::visit(
        [&]<class Shape>(const Shape&) {
          if constexpr (!std::is_same_v<Shape, std::monostate>) names.emplace(core::Element<Shape>::name);
        },
        body.shape);
  return names;
}

core::Scene without_body(core::Scene scene, std::size_t i) {
  const auto gone = static_cast<int>(i);
  const std::string name = scene.bodies[i].name;
  std::erase_if(scene.forces, [&](core::Force& force) {
    return std::visit([&](auto& kind) { return refers(kind, gone); }, force);
  });
  std::erase_if(scene.joints, [&](core::Joint& joint) { return refers(joint, gone); });
  std::erase_if(scene.materials,
                [&](const core::Material& m) { return m.between[0] == name || m.between[1] == name; });
  scene.bodies.erase(scene.bodies.begin() + static_cast<std::ptrdiff_t>(i));
  return scene;
}

}  // namespace cylon::hunt
