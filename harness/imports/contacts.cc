#include "harness/core/collision_filter.h"
#include "harness/imports/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

namespace cylon::imports {
namespace {

using foreign::Body;
using foreign::Meeting;
using foreign::Model;
using foreign::Solid;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// The meetings of one kind of surface: with whom, and how.
using Meets = std::map<int, std::pair<double, double>>;

std::vector<Meets> meets_of(const Model& model) {
  int count = 0;
  for (const Meeting& m : model.meetings) count = std::max({count, m.a + 1, m.b + 1});
  for (const Body& body : model.bodies)
    for (const Solid& solid : body.solids) count = std::max(count, solid.surface + 1);
  std::vector<Meets> meets(at(count));
  for (const Meeting& m : model.meetings) {
    meets[at(m.a)][m.b] = {m.friction, m.restitution};
    meets[at(m.b)][m.a] = {m.friction, m.restitution};
  }
  return meets;
}

std::optional<core::Primitive> primitive_of(const Solid& s) {
  if (s.kind == "sphere") return core::Sphere{s.size.x()};
  if (s.kind == "box") return core::Box{s.size};
  if (s.kind == "capsule") return core::Capsule{s.size.x(), s.size.y()};
  if (s.kind == "cylinder") return core::Cylinder{s.size.x(), s.size.y()};
  if (s.kind == "hull") return core::Hull{s.vertices};
  if (s.kind == "mesh") return core::Mesh{s.vertices, s.faces};
  return std::nullopt;
}

// A solid alone at the centre of mass is the body's shape; all others are parts, whose places count from there
// because the body states its inertia.
void take_shape(core::Body& body, const std::vector<core::Part>& parts, bool touches) {
  body.collide = touches && !parts.empty();
  if (parts.empty()) return;
  const core::Part& first = parts.front();
  const bool alone = parts.size() == 1 && first.position.isZero(0) && first.orientation.vec().isZero(0);
  if (alone)
    std::visit([&](const auto& shape) { body.shape = shape; }, first.shape);
  else
    body.shape = core::Compound{parts};
}

core::Plane plane_of(const Body& body, const Solid& solid, std::set<std::string>& taken) {
  const foreign::Pose pose = body.pose * solid.pose;
  core::Plane plane;
  for (int number = 1; plane.name.empty() || !taken.insert(plane.name).second; ++number)
    plane.name = fmt::format("plane {}", number);
  plane.normal = (pose.turn * core::Vector3::UnitY()).normalized();
  for (double& x : plane.normal)  // of a turn by a right angle the zeros are known
    if (std::abs(x) < 1e-15) x = 0;
  plane.normal.normalize();
  plane.offset = plane.normal.dot(pose.position);
  return plane;
}

// A thing of the scene that touches: its name and its kind of surface.
struct Thing {
  std::string name;
  int surface = 0;
  std::vector<std::string>*groups = nullptr, *mask = nullptr;
};

// Kinds of surface that touch the same others are one group.
void add_groups(std::vector<Thing>& things, const std::vector<Meets>& meets, Model& model) {
  std::set<int> present;
  for (const Thing& thing : things) present.insert(thing.surface);
  std::map<std::set<int>, std::vector<int>> by_partners;
  for (const int s : present) {
    std::set<int> partners;
    for (const auto& [other, how] : meets[at(s)])
      if (present.contains(other)) partners.insert(other);
    by_partners[partners].push_back(s);
  }
  if (by_partners.size() <= 1 && (present.empty() || by_partners.begin()->first == present)) return;
  if (by_partners.size() > core::most_groups) {
    model.losses.push_back({"too_large",
                            {"contacts", "", 0},
                            fmt::format("{} groups, at most {}", by_partners.size(), core::most_groups)});
    return;
  }
  std::map<int, std::string> group_of;
  for (int number = 1; const auto& [partners, surfaces] : by_partners) {
    for (const int s : surfaces) group_of[s] = fmt::format("group {}", number);
    ++number;
  }
  for (Thing& thing : things) {
    *thing.groups = {group_of.at(thing.surface)};
    std::set<std::string> mask;
    for (const auto& [other, how] : meets[at(thing.surface)])
      if (present.contains(other)) mask.insert(group_of.at(other));
    *thing.mask = {mask.begin(), mask.end()};
  }
}

// The most frequent pair of numbers is that of "*" and "*"; the pairs of things that differ are listed.
void add_materials(const std::vector<Thing>& things, const std::vector<Meets>& meets, core::Scene& scene,
                   Model& model) {
  std::map<int, std::vector<const Thing*>> of_surface;
  for (const Thing& thing : things) of_surface[thing.surface].push_back(&thing);
  std::map<std::pair<double, double>, std::size_t> counts;
  for (const auto& [a, first] : of_surface)
    for (const auto& [b, how] : meets[at(a)])
      if (const auto second = of_surface.find(b); second != of_surface.end())
        counts[how] += first.size() * second->second.size();
  if (counts.empty()) return;
  const auto usual = std::ranges::max_element(counts, {}, [](const auto& row) { return row.second; })->first;
  scene.materials.push_back({{"*", "*"}, usual.second, usual.first});
  constexpr std::size_t most = 20'000;
  for (const auto& [a, first] : of_surface)
    for (const auto& [b, how] : meets[at(a)]) {
      const auto second = of_surface.find(b);
      if (b < a || how == usual || second == of_surface.end()) continue;
      for (const Thing* x : first)
        for (const Thing* y : second->second) {
          if (x == y || (a == b && x > y)) continue;
          if (scene.materials.size() > most) {
            model.losses.push_back({"too_large",
                                    {"contacts", "", 0},
                                    fmt::format("more than {} pairs with a friction of their own", most)});
            return;
          }
          scene.materials.push_back({{x->name, y->name}, how.second, how.first});
        }
    }
}

// Bodies that a joint ties never touch each other in a scene.
void lose_joined_contacts(const std::vector<Meets>& meets, Model& model) {
  const auto touch = [&](const Body& a, const Body& b) {
    return std::ranges::any_of(a.solids, [&](const Solid& x) {
      return std::ranges::any_of(b.solids,
                                 [&](const Solid& y) { return meets[at(x.surface)].contains(y.surface); });
    });
  };
  for (const foreign::Joint& joint : model.joints)
    if (joint.may_touch && joint.to >= 0 && touch(model.bodies[at(joint.body)], model.bodies[at(joint.to)]))
      model.losses.push_back({"joined_contact", joint.place, ""});
}

}  // namespace

void add_contacts(Model& model, core::Scene& scene) {
  const std::vector<Meets> meets = meets_of(model);
  lose_joined_contacts(meets, model);
  std::vector<Thing> things;
  std::set<std::string> taken;
  for (const Body& body : model.bodies) taken.insert(body.name);
  std::vector<int> surface_of_body(model.bodies.size(), -1);
  std::vector<std::pair<core::Plane, int>> planes;
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& from = model.bodies[i];
    std::vector<core::Part> parts;
    // What touches nothing shows only where nothing of the body does touch.
    const bool touches =
        std::ranges::any_of(from.solids, [&](const Solid& s) { return !meets[at(s.surface)].empty(); });
    for (const Solid& solid : from.solids) {
      if (touches == meets[at(solid.surface)].empty()) continue;
      if (solid.kind == "plane" && from.locked && touches) {
        planes.emplace_back(plane_of(from, solid, taken), solid.surface);
        continue;
      }
      auto shape = primitive_of(solid);
      if (!shape && !touches) continue;
      if (!shape) {
        model.losses.push_back({"shape", solid.place, from.locked ? solid.kind : solid.kind + " that moves"});
        continue;
      }
      int& surface = surface_of_body[i];
      if (surface >= 0 && meets[at(surface)] != meets[at(solid.surface)])
        model.losses.push_back({"surfaces", solid.place, ""});
      surface = solid.surface;
      parts.push_back({std::move(*shape), 0, solid.pose.position, solid.pose.turn});
    }
    if (i >= scene.bodies.size()) continue;  // ground
    for (core::Part& part : parts) part.mass = scene.bodies[i].mass / static_cast<double>(parts.size());
    take_shape(scene.bodies[i], parts, touches);
  }
  for (auto& [plane, surface] : planes) scene.planes.push_back(plane);
  for (std::size_t i = 0; i < planes.size(); ++i)
    things.push_back({scene.planes[i].name, planes[i].second, &scene.planes[i].collision_groups,
                      &scene.planes[i].collision_mask});
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)
    if (scene.bodies[i].collide)
      things.push_back({scene.bodies[i].name, surface_of_body[i], &scene.bodies[i].collision_groups,
                        &scene.bodies[i].collision_mask});
  add_groups(things, meets, model);
  add_materials(things, meets, scene, model);
}

}  // namespace cylon::imports
