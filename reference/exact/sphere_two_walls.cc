// Smooth spheres between two parallel walls, one sphere without another in its way.  Across the gap of width
// a = distance of the walls - 2 r the speed is constant between impacts:
//
//     t_1 = d/|u0|,  t_(k+1) = t_k + a/|u_k|,  u_(k+1) = -e u_k,  e the restitution of the wall struck
//
// A wall with e = 0 keeps the sphere.  Along the walls the motion is free, or falls.  Domain: two planes that
// face each other exactly, no gravity across them, no friction, steady spins, at most 1e5 impacts.
#include "reference/exact/domain.h"
#include "reference/exact/flight.h"
#include "reference/exact/pieces.h"
#include "reference/exact/solutions.h"

#include <algorithm>
#include <array>

namespace cylon::exact {
namespace {

constexpr auto name = "sphere_two_walls";
constexpr std::size_t most_impacts = 100000;

Track to_and_fro(const core::Scene& scene, int index, Wide horizon, std::vector<core::Event>& events) {
  const core::Body& body = scene.bodies[static_cast<std::size_t>(index)];
  const Wide r = colliding_radius(name, scene, index);
  const WideVector normal = widen(scene.planes[0].normal).normalized();
  const std::array<Wide, 2> wall = {Wide(scene.planes[0].offset) + r, -Wide(scene.planes[1].offset) - r};
  Flight along(body.initial, common_gravity(scene));
  Wide x = std::clamp(normal.dot(along.position), wall[0], wall[1]), u = normal.dot(along.velocity), t = 0;
  along.position -= normal.dot(along.position) * normal;
  along.velocity -= u * normal;

  Track track;
  const auto go = [&] {
    track.add(t, [=](Wide s) {
      WideState state = along.at(t + s);
      state.position += (x + u * s) * normal;
      state.velocity += u * normal;
      return state;
    });
  };
  go();
  std::array<int, 2> hits = {0, 0};
  while (u != 0) {
    const int side = u > 0 ? 1 : 0;
    t += std::max<Wide>(0, (wall[static_cast<std::size_t>(side)] - x) / u);
    if (t > horizon * beyond) break;
    if (track.pieces().size() > most_impacts) refuse(name, "more than 100000 impacts before the horizon");
    const core::Pair pair = {index, core::world, side};
    const auto material = core::material_of(scene, pair);
    x = wall[static_cast<std::size_t>(side)];
    u *= material ? -Wide(material->restitution) : 0;
    go();
    if (u != 0) {
      events.push_back({.kind = core::EventKind::bounce,
                        .pair = pair,
                        .index = ++hits[static_cast<std::size_t>(side)],
                        .time = static_cast<double>(t),
                        .speed = static_cast<double>(std::abs(u)),
                        .height = 0});
    }
  }
  return track;
}

}  // namespace

core::Truth sphere_two_walls(const core::Scene& scene, double horizon) {
  check_bodies(name, scene, horizon);
  check_forces(name, scene, {"gravity"});
  check_falls_alike(name, scene);
  check_no_joints(name, scene);
  if (scene.planes.size() != 2) refuse(name, "the scene must have two planes");
  const core::Plane &left = scene.planes[0], &right = scene.planes[1];
  if (!(left.normal + right.normal).isZero(0)) refuse(name, "the planes do not face each other");
  if (left.normal.dot(common_gravity(scene)) != 0) refuse(name, "gravity acts across the walls");
  const core::ContactRules may_touch(scene);
  const int count = static_cast<int>(scene.bodies.size());
  for (int i = 0; i < count; ++i) {
    const double r = colliding_radius(name, scene, i);
    check_steady_spin(name, scene, i, horizon);
    if (!(-right.offset - left.offset > 2 * r)) refuse(name, named(scene, i) + " has no room");
    const core::Vector3& p = scene.bodies[static_cast<std::size_t>(i)].initial.position;
    for (int k : {0, 1}) {
      const core::Plane& plane = scene.planes[static_cast<std::size_t>(k)];
      check_meets(name, scene, may_touch, {i, core::world, k});
      check_smooth(name, scene, {i, core::world, k});
      if (plane.normal.dot(p) - plane.offset - r < -1e-12 * r) {
        refuse(name, named(scene, i) + " starts inside plane '" + plane.name + "'");
      }
    }
  }
  const auto solve = [horizon](const core::Scene& s) {
    Course course;
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
      course.tracks.push_back(to_and_fro(s, static_cast<int>(i), horizon, course.events));
    }
    return course;
  };
  const Course course = solve(scene);
  for (int i = 0; i < count; ++i) {
    for (int j = 0; j < i; ++j) {
      if (!may_touch.bodies(j, i)) continue;
      const double reach = colliding_radius(name, scene, i) + colliding_radius(name, scene, j);
      check_apart(name, scene, course, j, i, reach, horizon);
    }
  }
  return truth_of(name, scene, solve, horizon, "Newton's restitution between uniform motions");
}

}  // namespace cylon::exact
