// Planes, materials of pairs, and nothing inside anything else at the start.
#include "harness/scenario/read_element.h"

#include "harness/core/observable.h"
#include "harness/core/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace cylon::scenario {
namespace {

using core::Vector3;

constexpr double overlap_allowed = 1e-9;  // [m]

// Names that a material may state: bodies, planes, generators (all their bodies), "*".
std::vector<std::string> resolve(const Table& t, const Draft& draft, const std::string& name) {
  if (name == "*") return {name};
  std::vector<std::string> names;
  if (const auto group = draft.groups.find(name); group != draft.groups.end()) {
    for (const int body : group->second)
      names.push_back(draft.scene.bodies[static_cast<std::size_t>(body)].name);
    return names;
  }
  for (const core::Body& body : draft.scene.bodies) names.push_back(body.name);
  for (const core::Plane& plane : draft.scene.planes) names.push_back(plane.name);
  for (const auto& [group, bodies] : draft.groups) names.push_back(group);
  if (std::ranges::find(names, name) != names.end()) return {name};
  t.fail("between", fmt::format("between: no body, plane or generator is called '{}'{}", name,
                                core::did_you_mean(name, names)));
}

void require_materials(const Draft& draft) {
  const core::Scene& scene = draft.scene;
  const std::optional<core::Pair> pair = core::pair_without_material(scene);
  if (!pair) return;
  const auto body = static_cast<std::size_t>(pair->body);
  const std::string& other = pair->plane >= 0 ? scene.planes[static_cast<std::size_t>(pair->plane)].name
                                              : scene.bodies[static_cast<std::size_t>(pair->other)].name;
  draft.origin[body].fail(
      fmt::format("'{0}' and '{1}' may touch, but no [[material]] says how; add between = [\"{0}\", "
                  "\"{1}\"], or collide = false",
                  scene.bodies[body].name, other));
}

double size_of(const Vector3& p) { return std::max(1.0, p.cwiseAbs().maxCoeff()); }

// Spheres in order of their least x; only those whose x intervals meet can overlap.
void refuse_overlapping_spheres(const Draft& draft) {
  struct Ball {
    double low, radius;
    std::size_t body;
  };
  const auto& bodies = draft.scene.bodies;
  std::vector<Ball> balls;
  for (std::size_t i = 0; i < bodies.size(); ++i)
    if (const auto* sphere = std::get_if<core::Sphere>(&bodies[i].shape); sphere && bodies[i].collide)
      balls.push_back({bodies[i].initial.position.x() - sphere->radius, sphere->radius, i});
  std::ranges::sort(balls, {}, &Ball::low);
  for (auto a = balls.begin(); a != balls.end(); ++a)
    for (auto b = std::next(a); b != balls.end() && b->low < a->low + 2 * a->radius; ++b) {
      const core::Body &one = bodies[a->body], &other = bodies[b->body];
      if (one.locked && other.locked) continue;
      const Vector3 d = other.initial.position - one.initial.position;
      const double gap = d.norm() - a->radius - b->radius;
      if (gap < -overlap_allowed * size_of(one.initial.position))
        draft.origin[std::max(a->body, b->body)].fail(
            "position",
            fmt::format(
                "'{}' and '{}' overlap by {} m at the start; valid: {} m apart or more, or collide = false",
                one.name, other.name, -gap, a->radius + b->radius));
    }
}

}  // namespace

void read_planes(const Table& root, Draft& draft) {
  std::set<std::string> names;
  for (const Table& t : root.tables("plane")) {
    auto plane = read_element<core::Plane>(t, draft);
    if (plane.name == "*") t.fail("name", "name: \"*\" stands for all names in a material");
    if (!names.insert(plane.name).second)
      t.fail("name", fmt::format("name '{}' is taken by another plane", plane.name));
    const double norm = plane.normal.norm();
    if (!(std::abs(norm - 1) <= 1e-9))
      t.fail("normal", fmt::format("normal = {} has the norm {}, but must be a unit vector within 1e-9{}",
                                   written(plane.normal), norm,
                                   norm > 0 ? "; normalised: " + written(plane.normal / norm) : ""));
    make_unit(plane.normal);
    draft.scene.planes.push_back(plane);
  }
}

void read_materials(const Table& root, Draft& draft) {
  for (const core::Plane& plane : draft.scene.planes)
    for (std::size_t i = 0; i < draft.scene.bodies.size(); ++i)
      if (draft.scene.bodies[i].name == plane.name)
        draft.origin[i].fail("name", fmt::format("name '{}' is taken by a plane", plane.name));
  std::set<std::pair<std::string, std::string>> stated;
  for (const Table& t : root.tables("material")) {
    auto material = read_element<core::Material>(t, draft);
    const std::string between[] = {material.between[0], material.between[1]};
    const auto first = resolve(t, draft, between[0]), second = resolve(t, draft, between[1]);
    constexpr std::size_t most = 10'000;
    if (first.size() * second.size() > most)
      t.fail("between",
             fmt::format("between = [\"{}\", \"{}\"] makes {} pairs, but at most {} are listed; use \"*\"",
                         between[0], between[1], first.size() * second.size(), most));
    for (const std::string& a : first)
      for (const std::string& b : second) {
        if (!stated.insert(std::minmax(a, b)).second) {
          if (between[0] == between[1]) continue;  // a generator with itself names each pair twice
          t.fail("between", fmt::format("the pair '{}', '{}' has a material already", a, b));
        }
        material.between[0] = a, material.between[1] = b;
        draft.scene.materials.push_back(material);
      }
  }
  require_materials(draft);
}

void refuse_overlaps(const Draft& draft) {
  refuse_overlapping_spheres(draft);
  const core::Scene& scene = draft.scene;
  const core::State state = core::initial_state(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].collide || scene.bodies[i].locked) continue;
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
      const double gap = core::gap(scene, {static_cast<int>(i), core::world, static_cast<int>(p)}, state);
      if (gap < -overlap_allowed * size_of(scene.bodies[i].initial.position))
        draft.origin[i].fail(
            "position",
            fmt::format("'{}' reaches {} m into plane '{}' at the start; move it out by that much",
                        scene.bodies[i].name, -gap, scene.planes[p].name));
    }
  }
}

}  // namespace cylon::scenario
