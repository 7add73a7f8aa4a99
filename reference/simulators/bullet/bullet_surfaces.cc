#include "reference/simulators/bullet/bullet_surfaces.h"

#include <set>
#include <string>

namespace cylon::simulators {
namespace {

// Who is in a class: enough to know whether two of them may touch, and whom to ask for the material.
struct Members {
  int moving = 0, locked = 0, planes = 0;
  int body = core::world, plane = -1;
};

// Locked bodies touch neither each other nor planes; planes touch no planes.
bool may_touch(const Members& a, const Members& b, bool same) {
  const int others_of_a = b.moving + b.locked + b.planes - (same ? 1 : 0);
  const int others_of_b = a.moving + a.locked + a.planes - (same ? 1 : 0);
  return (a.moving > 0 && others_of_a > 0) || (b.moving > 0 && others_of_b > 0);
}

std::optional<core::Material> material(const core::Scene& scene, const Members& a, const Members& b) {
  if (a.body != core::world && b.body != core::world) return material_of(scene, {a.body, b.body, -1});
  if (a.body != core::world) return material_of(scene, {a.body, core::world, b.plane});
  return material_of(scene, {b.body, core::world, a.plane});
}

}  // namespace

Surfaces::Surfaces(const core::Scene& scene) {
  std::set<std::string> named;
  for (const core::Material& m : scene.materials) named.insert(m.between, m.between + 2);

  std::vector<Members> members(1);
  const auto join = [&](const std::string& name) {
    if (!named.contains(name)) return 0;
    members.emplace_back();
    return static_cast<int>(members.size()) - 1;
  };
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const core::Body& body = scene.bodies[i];
    body_class_.push_back(join(body.name));
    Members& m = members[static_cast<std::size_t>(body_class_.back())];
    m.body = static_cast<int>(i);
    if (body.collide && !std::holds_alternative<std::monostate>(body.shape))
      ++(body.locked ? m.locked : m.moving);
  }
  for (std::size_t i = 0; i < scene.planes.size(); ++i) {
    plane_class_.push_back(join(scene.planes[i].name));
    Members& m = members[static_cast<std::size_t>(plane_class_.back())];
    m.plane = static_cast<int>(i);
    ++m.planes;
  }

  classes_ = members.size();
  table_.resize(classes_ * classes_);
  for (std::size_t a = 0; a < classes_; ++a)
    for (std::size_t b = 0; b < classes_; ++b) {
      if (!may_touch(members[a], members[b], a == b)) continue;
      const std::optional<core::Material> m = material(scene, members[a], members[b]);
      if (m) table_[a * classes_ + b] = {m->restitution, m->friction, true};
    }
}

}  // namespace cylon::simulators
