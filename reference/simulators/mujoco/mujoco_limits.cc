#include "reference/simulators/mujoco/mujoco_limits.h"

#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forces.h"
#include "reference/applied/forest.h"
#include "reference/applied/masses.h"
#include "reference/applied/materials.h"
#include "reference/applied/parts.h"
#include "reference/simulators/mujoco/mujoco_contacts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <variant>

namespace cylon::simulators {
namespace {

using core::Overloaded;
using core::Scene;
using Reason = std::optional<std::string>;

constexpr double least = 1e-15;     // mjMINVAL, of a mass and a moment; mujoco/mjtnum.h:27
constexpr double most = 1e10;       // mjMAXVAL, of a coordinate; mujoco/mjmodel.h:24
constexpr int most_bodies = 65534;  // a pair of bodies is one int; engine/engine_collision_driver.c:87
constexpr int deepest = 90;         // elements within each other in XML: 100, less those around the bodies
constexpr double largest_array = 2147483647.;      // a size is an int
constexpr double most_memory = 6. * (1ull << 30);  // [bytes]; a worker may have 8 GiB of address space

const core::Body& body(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }

// Why a shape cannot collide; nullptr where it can.  Types of geoms: mujoco/mjmodel.h:88.
const char* missing(const core::Primitive& shape) {
  using What = const char*;
  return std::visit(
      Overloaded{[](const core::Cone&) -> What { return "MuJoCo has no cone (mujoco/mjmodel.h:88)"; },
                 [](const core::Rod&) -> What {
                   return "MuJoCo has no solid without thickness, such as a rod (mujoco/mjmodel.h:88)";
                 },
                 [](const core::Disc&) -> What {
                   return "MuJoCo has no solid without thickness, such as a disc (mujoco/mjmodel.h:88)";
                 },
                 [](const core::Mesh&) -> What {
                   return "MuJoCo collides the convex hull of a mesh, not the mesh "
                          "(engine/engine_collision_convex.c:107); give its convex parts as a compound";
                 },
                 [](const core::Hull& hull) -> What {
                   return hull.vertices.size() < 4 ? "MuJoCo needs four vertices (user/user_mesh.cc:152)"
                                                   : nullptr;
                 },
                 [](const auto&) -> What { return nullptr; }},
      shape);
}

Reason against(const core::Body& body) {
  const core::BodyState& start = body.initial;
  for (const core::Vector3* v : {&start.position, &start.velocity, &start.angular_velocity})
    if (!(v->cwiseAbs().maxCoeff() <= most))
      return fmt::format("MuJoCo resets what is beyond {:g} in a coordinate; '{}' starts there.", most,
                         body.name);
  if (body.locked) return {};
  if (!(body.mass >= least))
    return fmt::format("MuJoCo needs a mass of at least {:g} kg; '{}' has {} kg.", least, body.name,
                       body.mass);
  const core::Vector3 moments = core::principal_axes(body.inertia).moments;
  if (!(moments.minCoeff() >= least))
    return fmt::format("MuJoCo needs principal moments of at least {:g} kg m^2; '{}' has one of {} kg m^2.",
                       least, body.name, moments.minCoeff());
  return {};
}

Reason against(const Scene& scene, const core::Pair& pair, const core::Material& material) {
  const std::string& name = body(scene, pair.body).name;
  const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                             : body(scene, pair.other).name;
  if (material.restitution > 0)
    return fmt::format(
        "'{}' and '{}' bounce by {}, and MuJoCo has no coefficient of restitution: its contacts are damped "
        "springs, whose stiffness the scene does not state (doc/modeling.rst:1357).",
        name, other, material.restitution);
  for (const int i : {pair.body, pair.other}) {
    if (i == core::world) continue;
    for (const core::Part& part : applied::parts_of(body(scene, i).shape))
      if (const char* what = missing(part.shape))
        return fmt::format("Body '{}': {}.", body(scene, i).name, what);
  }
  return {};
}

Reason against_contacts(const Scene& scene) {
  if (Reason reason = applied::without_material(scene)) return reason;
  const core::Surfaces surfaces = core::surfaces(scene);
  const auto class_of = [&](const core::Pair& pair) {
    return pair.plane >= 0 ? surfaces.of_plane[static_cast<std::size_t>(pair.plane)]
                           : surfaces.of_body[static_cast<std::size_t>(pair.other)];
  };
  Reason reason;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    const int row = surfaces.material(surfaces.of_body[static_cast<std::size_t>(pair.body)], class_of(pair));
    reason = against(scene, pair, scene.materials[static_cast<std::size_t>(row)]);
    return reason.has_value();
  });
  return reason;
}

// What closes a loop (mujoco_model.cc, write_loops); all kinds hang a body from another but the screw.
bool closes(core::JointType type) {
  using core::JointType;
  return type == JointType::ball || type == JointType::hinge || type == JointType::distance ||
         type == JointType::fixed;
}

// Limits and friction are MuJoCo's soft constraints; a tree has them, loops are closed by points.
Reason against_joints(const Scene& scene) {
  const applied::Forest forest = applied::forest_of(scene);
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    const core::Joint& joint = scene.joints[j];
    const std::string& name = body(scene, joint.body).name;
    bool bounces = false;
    core::for_each_coordinate(
        joint, [&](const core::JointCoordinate& c) { bounces |= core::has_limit(c) && c.restitution > 0; });
    if (bounces)
      return fmt::format(
          "The joint of '{}' bounces from its limits, and MuJoCo has no coefficient of restitution: its "
          "limits are damped springs (doc/modeling.rst:1357).",
          name);
    const bool loop = std::ranges::find(forest.loops, j) != forest.loops.end();
    bool acts = false;
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
      acts |= core::has_limit(c) || c.friction != 0 || core::has_rotor(c);
    });
    if (loop && (!closes(joint.type) || acts))
      return fmt::format(
          "The {} joint of '{}' closes a loop, which this adapter closes by balls, hinges and fixed joints "
          "without limits, friction and rotors.",
          core::kind_of(joint.type).name, name);
    // Its displacements are of axes that `to` carries: MuJoCo's are of the parent.
    if (core::kind_of(joint.type).place == core::JointPlace::in_plane && core::acted_on(joint) &&
        forest.nodes[static_cast<std::size_t>(joint.body)].joint != static_cast<int>(j))
      return fmt::format(
          "The {} joint of '{}' hangs '{}' from it, and MuJoCo's displacements are of the parent's axes.",
          core::kind_of(joint.type).name, name, body(scene, joint.to).name);
  }
  return {};
}

Reason against_size(const Scene& scene) {
  if (scene.bodies.size() > most_bodies)
    return fmt::format("MuJoCo has at most {} bodies; the scene has {}.", most_bodies, scene.bodies.size());
  const applied::Forest forest = applied::forest_of(scene);
  for (const applied::Node& node : forest.nodes)
    if (node.depth > deepest)
      return fmt::format(
          "MuJoCo's reader of XML takes at most {} bodies that hang from each other; '{}' is deeper.",
          deepest, body(scene, node.body).name);
  // Without contacts first: their number alone takes long to find where there are too many bodies.
  MujocoMemory memory = mujoco_memory(scene, 0);
  if (memory.bytes() <= most_memory) memory = mujoco_memory(scene, mujoco_contacts(scene).points);
  if (std::max(memory.buffer, memory.numbers) <= largest_array && memory.bytes() <= most_memory) return {};
  return fmt::format(
      "MuJoCo allocates room for all constraints before it starts, which grows with the square of the scene: "
      "{:.2g} GiB here, and {:g} GiB is the most that this adapter asks for.",
      memory.bytes() / (1ull << 30), most_memory / (1ull << 30));
}

}  // namespace

Reason mujoco_limit(const Scene& scene) {
  for (const core::Body& one : scene.bodies)
    if (Reason reason = against(one)) return reason;
  if (Reason reason = applied::without_triangle("MuJoCo", scene)) return reason;
  if (Reason reason = applied::unmapped(scene)) return reason;
  if (Reason reason = against_joints(scene)) return reason;
  if (Reason reason = against_contacts(scene)) return reason;
  return against_size(scene);
}

core::Vector3 mujoco_moments(const core::Vector3& moments) {
  core::Vector3 result = moments;
  Eigen::Index i = 0;
  result.maxCoeff(&i);
  // Sums in the order in which MuJoCo takes them.
  const double others = result[(i + 1) % 3] + result[(i + 2) % 3];
  result[i] = std::min(result[i], others);
  return result;
}

}  // namespace cylon::simulators
