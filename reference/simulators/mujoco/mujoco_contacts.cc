#include "reference/simulators/mujoco/mujoco_contacts.h"

#include "harness/core/collision_filter.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/overloaded.h"
#include "harness/core/surfaces.h"
#include "reference/applied/forest.h"
#include "reference/applied/parts.h"

#include <algorithm>
#include <variant>

namespace cylon::simulators {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Room beyond this would be a gigabyte: the rows of contacts make a square matrix.
constexpr std::int64_t most_points = 1500;
// A body among equal ones touches at most twelve; half of the points belong to the other body.
constexpr std::int64_t neighbours = 12;

// Contact points of a shape with another at most: a ball has one, the ends of a capsule two, a face of a box on another
// box eight.
std::int64_t points_of(const core::Primitive& shape) {
  return std::visit(core::Overloaded{[](const core::Sphere&) { return std::int64_t{1}; },
                                     [](const core::Capsule&) { return std::int64_t{2}; },
                                     [](const auto&) { return std::int64_t{8}; }},
                    shape);
}

struct Points {
  std::int64_t parts = 1, most = 8;  // a plane takes what the other has
};

Points points_of(const core::Body& body) {
  Points points{0, 0};
  for (const core::Part& part : applied::parts_of(body.shape))
    ++points.parts, points.most = std::max(points.most, points_of(part.shape));
  return points;
}

}  // namespace

MujocoContacts mujoco_contacts(const core::Scene& scene) {
  MujocoContacts result;
  const core::Surfaces surfaces = core::surfaces(scene);
  const auto friction = [&](const core::Pair& pair) {
    const int other = pair.plane >= 0 ? surfaces.of_plane[at(pair.plane)] : surfaces.of_body[at(pair.other)];
    return scene.materials[at(surfaces.material(surfaces.of_body[at(pair.body)], other))].friction;
  };
  std::vector<Points> points;
  for (const core::Body& body : scene.bodies) points.push_back(points_of(body));

  result.uniform = !core::states_filters(scene);
  bool any = false;
  std::int64_t bound = 0, of_bodies = 0;
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    const double mu = friction(pair);
    if (!any) result.friction = mu;
    any = true;
    result.uniform = result.uniform && mu == result.friction;
    result.rubs = result.rubs || mu > 0;
    const Points &a = points[at(pair.body)], b = pair.plane >= 0 ? Points() : points[at(pair.other)];
    bound += a.parts * b.parts * std::min(a.most, b.most);
    return false;
  });
  if (!result.uniform)
    core::any_touching_pair(scene, [&](const core::Pair& pair) {
      result.pairs.push_back({pair, friction(pair)});
      return false;
    });
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (core::collides(scene.bodies[i]) && !scene.bodies[i].locked)
      of_bodies += neighbours * points[i].parts * points[i].most;
  result.points = std::min({bound, of_bodies, most_points});
  return result;
}

MujocoMemory mujoco_memory(const core::Scene& scene, std::int64_t points) {
  const auto loops = static_cast<double>(applied::forest_of(scene).loops.size());
  const auto bodies = static_cast<double>(scene.bodies.size()) + 1;
  double freedoms = 0;
  for (const core::Body& body : scene.bodies) freedoms += body.locked ? 0 : 6;
  double of_joints = 0;  // a row for each stop and each dry friction
  for (const core::Joint& joint : scene.joints)
    core::for_each_coordinate(joint, [&](const core::JointCoordinate& c) {
      of_joints += (c.lower ? 1 : 0) + (c.upper ? 1 : 0) + (c.friction != 0 ? 1 : 0);
    });
  MujocoMemory memory;
  memory.rows = 4 * static_cast<double>(points) + 6 * loops + of_joints;
  // efc_AR and its indices, efc_J and efc_JT and theirs: mujoco/mjxmacro.h:482
  memory.buffer = 12 * memory.rows * memory.rows + 24 * memory.rows * freedoms;
  // MuJoCo's own rule, user/user_model.cc:2578, and what the implicit scheme takes beside it, engine/engine_derivative.c:445.
  const double side = memory.rows + loops + freedoms;
  const double own = 1000 + 5 * side * side + 20 * (13 * bodies + 3 * loops + bodies);
  memory.numbers = own + 18 * bodies * freedoms + 6 * freedoms * freedoms;
  return memory;
}

}  // namespace cylon::simulators
