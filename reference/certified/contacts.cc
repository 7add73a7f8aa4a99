// Pairs that may touch: gaps, and velocities after an impact, as nodes of the graph.
#include "reference/certified/builder.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::certified {
namespace {

double radius_of(const core::Scene& scene, int body, const std::string& names) {
  const core::Body& b = scene.bodies[static_cast<std::size_t>(body)];
  if (const auto* sphere = std::get_if<core::Sphere>(&b.shape)) return sphere->radius;
  refuse(fmt::format("{} may touch, and only blows between spheres and planes are followed", names));
}

void check_joints(const core::Scene& scene, int body, const std::string& names) {
  if (std::ranges::any_of(scene.joints, [&](const core::Joint& j) { return j.body == body || j.to == body; }))
    refuse(fmt::format("{} may touch, and a blow to a body with a joint is not followed", names));
}

core::Material material_for(const core::Scene& scene, const core::Pair& pair, const std::string& names) {
  const auto material = core::material_of(scene, pair);
  if (!material) refuse(fmt::format("{} may touch, and no material says how they rebound", names));
  if (material->friction > 0)
    refuse(fmt::format("{} may touch with friction {}, and only blows without friction are followed", names,
                       material->friction));
  return *material;
}

struct Blow {
  const Builder& b;
  const std::vector<Motion>& motions;
  Contact& contact;

  // v + change of a body that moves.
  void change(int body, const Vector& by) {
    const auto i = static_cast<std::size_t>(body);
    if (b.bodies[i].locked) return;
    const Vector after = motions[i].velocity + by;
    for (std::size_t k = 0; k < 3; ++k) {
      const Node& before = b.graph[static_cast<std::size_t>(motions[i].velocity[k].node)];
      contact.after.push_back({before.a, after[k].node});
    }
  }
};

// gap = n.p - offset - r, gap' = n.v, v+ = v - (1 + e) (n.v) n.
void strike_plane(Blow blow, const core::Plane& plane, double radius, Expr more) {
  const Builder& b = blow.b;
  const Motion& m = blow.motions[static_cast<std::size_t>(blow.contact.pair.body)];
  Vector n = b.vector(plane.normal);
  const Expr length = sqrt(dot(n, n));
  for (Expr& x : n) x = x / length;
  const Expr rate = dot(n, m.velocity);
  blow.contact.gap = (dot(n, m.position) - (b.number(plane.offset) + b.number(radius))).node;
  blow.contact.rate = rate.node;
  blow.change(blow.contact.pair.body, -((more * rate) * n));
}

// With d = p_a - p_b, w = v_a - v_b, R = r_a + r_b:  gap = d.d - R^2, gap' = 2 d.w, and at the blow, where
// d.d = R^2,  v_a+ = v_a - (1 + e) m_b/(m_a + m_b) (d.w)/R^2 d,  and so for b; a locked body has all the
// mass.
void strike_sphere(Blow blow, double radius, double other_radius, Expr more) {
  const Builder& b = blow.b;
  const int one = blow.contact.pair.body, two = blow.contact.pair.other;
  const auto i = static_cast<std::size_t>(one), j = static_cast<std::size_t>(two);
  const Frozen &f = b.bodies[i], &g = b.bodies[j];
  const Vector d = blow.motions[i].position - blow.motions[j].position;
  const Expr reach = b.number(radius) + b.number(other_radius), square = reach * reach;
  const Expr along = dot(d, blow.motions[i].velocity - blow.motions[j].velocity);
  blow.contact.gap = (dot(d, d) - square).node;
  blow.contact.rate = (2 * along).node;
  const Expr total = f.mass + g.mass, nothing = b.exact(0), all = b.exact(1);
  const Expr share = f.locked ? nothing : g.locked ? all : g.mass / total;
  const Expr rest = g.locked ? nothing : f.locked ? all : f.mass / total;
  const Expr size = more / square * along;
  blow.change(one, -((share * size) * d));
  blow.change(two, (rest * size) * d);
}

}  // namespace

void add_contacts(const Builder& b, const std::vector<Motion>& motions, std::vector<Contact>& contacts) {
  for (const core::Pair& pair : core::touching_pairs(b.scene)) {
    Contact contact{pair, names_of(b.scene, pair), -1, -1, {}};
    const core::Material material = material_for(b.scene, pair, contact.names);
    const double radius = radius_of(b.scene, pair.body, contact.names);
    check_joints(b.scene, pair.body, contact.names);
    const Expr more = b.exact(1) + b.number(material.restitution);
    const Blow blow{b, motions, contact};
    if (pair.plane >= 0) {
      strike_plane(blow, b.scene.planes[static_cast<std::size_t>(pair.plane)], radius, more);
    } else {
      check_joints(b.scene, pair.other, contact.names);
      strike_sphere(blow, radius, radius_of(b.scene, pair.other, contact.names), more);
    }
    contacts.push_back(contact);
  }
  if (contacts.empty()) return;
  for (std::size_t i = 0; i < b.graph.size(); ++i)
    if (b.graph[i].op == Op::time || b.graph[i].op == Op::cosine)
      refuse(
          "a force or a mass that changes with time, and blows, whose times are known within a radius only");
}

}  // namespace cylon::certified
