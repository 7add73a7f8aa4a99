// Planes, materials of pairs, and nothing inside anything else at the start.
#include "harness/scenario/budget.h"
#include "harness/scenario/read_element.h"
#include "harness/scenario/sphere_grid.h"

#include "harness/core/collision_filter.h"
#include "harness/core/observable.h"
#include "harness/core/surfaces.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <string>
#include <utility>

namespace cylon::scenario {
namespace {

using core::Vector3;

constexpr double overlap_allowed = 1e-9;  // [m]

// Names that a material may state: bodies, planes, generators (all their bodies), "*".
std::vector<std::string> resolve(const Table& t, const Draft& draft, const std::string& name) {
  if (name == "*") return {name};
  if (const auto group = draft.groups.find(name); group != draft.groups.end()) {
    std::vector<std::string> names;
    for (const int body : group->second)
      names.push_back(draft.scene.bodies[static_cast<std::size_t>(body)].name);
    return names;
  }
  if (draft.has_body(name) || draft.planes.contains(name)) return {name};
  std::vector<std::string> names;
  for (const core::Plane& plane : draft.scene.planes) names.push_back(plane.name);
  for (const auto& [group, bodies] : draft.groups) names.push_back(group);
  for (const core::Body& body : draft.scene.bodies) names.push_back(body.name);
  t.fail("between", fmt::format("between: no body, plane or generator is called '{}'{}", name,
                                core::did_you_mean(name, names)));
}

// `patterns`: where a name and "*" were written, by the name.
void require_materials(const Draft& draft, const std::map<std::string, Table>& patterns) {
  const core::Scene& scene = draft.scene;
  const std::optional<core::UnclearPair> unclear = core::unclear_pair(scene);
  if (!unclear) return;
  const core::Pair& pair = unclear->pair;
  const auto body = static_cast<std::size_t>(pair.body);
  const std::string& one = scene.bodies[body].name;
  const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                             : scene.bodies[static_cast<std::size_t>(pair.other)].name;
  if (unclear->disputed)
    patterns.at(other).fail(
        "between",
        fmt::format("between: '{0}' and '{1}' may touch, and [\"{0}\", \"*\"] and [\"{1}\", \"*\"] "
                    "say other numbers; add between = [\"{0}\", \"{1}\"]",
                    one, other));
  draft.origin[body].fail(
      fmt::format("'{0}' and '{1}' may touch, but no [[material]] says how; add between = [\"{0}\", "
                  "\"{1}\"], collide = false or collision_mask",
                  one, other));
}

double size_of(const Vector3& p) { return std::max(1.0, p.cwiseAbs().maxCoeff()); }

void refuse_overlapping_spheres(Draft& draft) {
  const auto& bodies = draft.scene.bodies;
  SphereGrid locked, free;
  const core::ContactRules rules(draft.scene);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const auto* sphere = std::get_if<core::Sphere>(&bodies[i].shape);
    if (!sphere || !bodies[i].collide) continue;
    const auto overlap = [&](int other, double radius) {
      const core::Body& that = bodies[static_cast<std::size_t>(other)];
      return sphere->radius + radius - (bodies[i].initial.position - that.initial.position).norm();
    };
    const auto meets = [&](int other, const Vector3&, double radius) {
      if (!rules.bodies(static_cast<int>(i), other)) return false;
      const double size = std::min(size_of(bodies[i].initial.position),
                                   size_of(bodies[static_cast<std::size_t>(other)].initial.position));
      return overlap(other, radius) > overlap_allowed * size;
    };
    const Vector3& at = bodies[i].initial.position;
    int other = free.first(at, sphere->radius, draft.neighbours, meets);
    if (!bodies[i].locked)
      if (const int held = locked.first(at, sphere->radius, draft.neighbours, meets); held >= 0)
        other = other < 0 ? held : std::min(other, held);
    if (other >= 0) {
      const auto& that = bodies[static_cast<std::size_t>(other)];
      const double radius = std::get<core::Sphere>(that.shape).radius;
      draft.origin[i].fail(
          "position",
          fmt::format("'{}' and '{}' overlap by {} m at the start; valid: {} m apart or more, "
                      "collide = false or collision_mask",
                      that.name, bodies[i].name, overlap(other, radius), sphere->radius + radius));
    }
    if (draft.neighbours > budget::neighbours)
      draft.origin[i].fail(
          "position", fmt::format("'{}': too many spheres crowd here to look for overlaps", bodies[i].name));
    (bodies[i].locked ? locked : free).add(static_cast<int>(i), at, sphere->radius);
  }
}

}  // namespace

void read_planes(const Table& root, Draft& draft) {
  for (const Table& t : root.tables("plane")) {
    auto plane = read_element<core::Plane>(t, draft);
    if (plane.name == "*") t.fail("name", "name: \"*\" stands for all names in a material");
    if (!draft.planes.insert(plane.name).second)
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
  std::set<std::string> named;
  for (std::size_t i = 0; i < draft.scene.bodies.size(); ++i)
    if (draft.planes.contains(draft.scene.bodies[i].name))
      draft.origin[i].fail("name", fmt::format("name '{}' is taken by a plane", draft.scene.bodies[i].name));
  std::set<std::pair<std::string, std::string>> stated;
  std::map<std::string, Table> patterns;
  for (const Table& t : root.tables("material")) {
    auto material = read_element<core::Material>(t, draft);
    const std::string between[] = {material.between[0], material.between[1]};
    const auto first = resolve(t, draft, between[0]), second = resolve(t, draft, between[1]);
    constexpr std::size_t most = 10'000;
    if (first.size() * second.size() > most)
      t.fail("between",
             fmt::format("between = [\"{}\", \"{}\"] makes {} pairs, but at most {} are listed; use \"*\"",
                         between[0], between[1], first.size() * second.size(), most));
    if (draft.scene.materials.size() + first.size() * second.size() > budget::material_pairs)
      t.fail("between", fmt::format("between: all materials together list more than {} pairs; use \"*\"",
                                    budget::material_pairs));
    named.insert(first.begin(), first.end());
    named.insert(second.begin(), second.end());
    if (named.size() > budget::material_names)
      t.fail("between",
             fmt::format("between: all materials together name more than {} bodies and planes; use "
                         "\"*\"",
                         budget::material_names));
    for (const std::string& a : first)
      for (const std::string& b : second) {
        if (!stated.insert(std::minmax(a, b)).second) {
          if (between[0] == between[1]) continue;  // a generator with itself names each pair twice
          t.fail("between", fmt::format("the pair '{}', '{}' has a material already", a, b));
        }
        if ((a == "*") != (b == "*")) patterns.emplace(a == "*" ? b : a, t);
        material.between[0] = a, material.between[1] = b;
        draft.scene.materials.push_back(material);
      }
  }
  require_materials(draft, patterns);
}

void refuse_overlaps(Draft& draft) {
  refuse_overlapping_spheres(draft);
  const core::Scene& scene = draft.scene;
  if (scene.planes.empty()) return;
  const double looks =
      static_cast<double>(scene.bodies.size() + draft.points) * static_cast<double>(scene.planes.size());
  if (looks > static_cast<double>(budget::gaps))
    draft.origin.back().fail(fmt::format(
        "bodies, their points and {} planes are too many to look for overlaps", scene.planes.size()));
  const core::State state = core::initial_state(scene);
  const core::ContactRules rules(scene);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!scene.bodies[i].collide || scene.bodies[i].locked) continue;
    for (std::size_t p = 0; p < scene.planes.size(); ++p) {
      if (!rules.body_and_plane(static_cast<int>(i), static_cast<int>(p))) continue;
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
