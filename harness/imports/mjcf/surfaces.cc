// Geoms: which touch which, and with what friction (MuJoCo's engine_collision_driver.c, mj_contactParam).
#include "harness/imports/mjcf/mjcf.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>
#include <vector>

namespace cylon::imports {
namespace {

using foreign::Solid;
using foreign::Vector3;

// All that decides whom a geom touches and how; `body` only where <exclude> names it or it is free of its parent.  That is
// the body itself and not the one that it is welded to: of a base that is a part of the world, <exclude> leaves the floor
// as it is.
struct Surface {
  int type = 0, affinity = 0, dimension = 3, priority = 0, body = -1;
  double friction = 1;
  // NOLINTNEXTLINE(modernize-use-nullptr): the literal that the compiler compares with
  friend auto operator<=>(const Surface&, const Surface&) = default;
};

using Pairs = std::set<std::pair<int, int>>;

// Bodies that <exclude> keeps apart; its signature is (body1 << 16) + body2, with 1 added to both before MuJoCo 3.
Pairs excluded(const Compiled& m) {
  Pairs pairs;
  const int base = m.version() < 300 ? 1 : 0;
  for (int i = 0; i < static_cast<int>(m.length("exclude_signature")); ++i) {
    const int signature = m.integer("exclude_signature", i);
    const int a = (signature >> 16) - base, b = (signature & 0xffff) - base;
    pairs.insert({a, b});
  }
  return pairs;
}

// The degrees of freedom of a free body: its motions leave no joint in a scene (harness/imports/joints.cc).
constexpr int all_motions = 6;

// Bodies that move freely and hang on one that moves.  MuJoCo keeps parent and child apart, each with what is welded to
// it (engine_collision_driver.c, filterBodyPair); in a scene joints do, and here there is none.
void add_free_children(const Compiled& m, Pairs& pairs) {
  if (m.disabled("filterparent")) return;
  std::map<int, std::vector<int>> welded;
  for (int body = 1; body < m.size("nbody"); ++body) welded[m.integer("body_weldid", body)].push_back(body);
  for (int child = 1; child < m.size("nbody"); ++child) {
    const int parent = m.integer("body_weldid", m.integer("body_parentid", child));
    if (parent == 0 || m.integer("body_dofnum", child) != all_motions) continue;
    for (const int a : welded[child])
      for (const int b : welded[parent]) pairs.insert({a, b});
  }
}

bool touch(const Surface& a, const Surface& b, const Pairs& apart) {
  if (apart.contains({a.body, b.body}) || apart.contains({b.body, a.body})) return false;
  return (a.type & b.affinity) != 0 || (b.type & a.affinity) != 0;
}

foreign::Meeting meeting_of(int i, const Surface& a, int j, const Surface& b) {
  const Surface& first = a.priority >= b.priority ? a : b;
  const Surface& second = a.priority >= b.priority ? b : a;
  const bool equal = a.priority == b.priority;
  const int dimension = equal ? std::max(a.dimension, b.dimension) : first.dimension;
  const double friction = equal ? std::max(first.friction, second.friction) : first.friction;
  return {i, j, dimension == 1 ? 0 : friction, 0};
}

// The vertices that MuJoCo collides with: of the hull where it has one.
std::vector<Vector3> vertices_of(const Compiled& m, int mesh) {
  const int first = m.integer("mesh_vertadr", mesh), count = m.integer("mesh_vertnum", mesh);
  const int graph = m.integer("mesh_graphadr", mesh, -1);
  std::vector<Vector3> vertices;
  if (graph < 0) {
    for (int i = 0; i < count; ++i) vertices.push_back(m.vector("mesh_vert", first + i));
    return vertices;
  }
  // numvert, numface, vert_edgeadr[numvert], vert_globalid[numvert], …
  const int hull = m.integer("mesh_graph", graph);
  for (int i = 0; i < hull; ++i)
    vertices.push_back(m.vector("mesh_vert", first + m.integer("mesh_graph", graph + 2 + hull + i)));
  return vertices;
}

Solid solid_of(const Compiled& m, int geom) {
  const auto kind = static_cast<MjGeom>(m.integer("geom_type", geom));
  const Vector3 size = m.vector("geom_size", geom);
  Solid solid;
  solid.place = m.place("geom", geom);
  if (m.name("geom", geom).empty())
    solid.place.element += fmt::format(" of body '{}'", m.name("body", m.integer("geom_bodyid", geom)));
  solid.size = size;
  switch (kind) {
    case MjGeom::plane:
      solid.kind = "plane";
      break;
    case MjGeom::sphere:
      solid.kind = "sphere";
      break;
    case MjGeom::box:
      solid.kind = "box";
      break;
    case MjGeom::capsule:
    case MjGeom::cylinder:
      solid.kind = kind == MjGeom::capsule ? "capsule" : "cylinder";
      solid.size = {size.x(), 2 * size.y(), 0};
      break;
    case MjGeom::ellipsoid:
      solid.kind = size.x() == size.y() && size.y() == size.z() ? "sphere" : "ellipsoid";
      break;
    case MjGeom::mesh:
      solid.kind = "hull";
      solid.vertices = vertices_of(m, m.integer("geom_dataid", geom));
      break;
    case MjGeom::hfield:
      solid.kind = "heightfield";
      break;
    default:
      solid.kind = "signed distance";
      break;
  }
  // From the frame of the body to its centre of mass.
  const int body = m.integer("geom_bodyid", geom);
  solid.pose = {m.vector("geom_pos", geom) - m.vector("body_ipos", body), m.quaternion("geom_quat", geom)};
  return solid;
}

void lose_of_geom(const Compiled& m, int geom, const Surface& surface, foreign::Model& model) {
  const auto lose = [&](const char* what, std::string detail = "") {
    model.losses.push_back({what, m.place("geom", geom), std::move(detail)});
  };
  if (surface.dimension > 3) lose("torsional_friction", fmt::format("condim {}", surface.dimension));
  if (const double margin =
          m.margin_of_all().value_or(m.number("geom_margin", geom)) - m.number("geom_gap", geom);
      margin != 0)
    lose("contact_margin", fmt::format("{} m", margin));
  if (m.is_override_anisotropic() && surface.dimension > 1) lose("anisotropic_friction", "o_friction");
  if (m.number("geom_adhesion", geom) != 0) lose("contact_pair", "adhesion");
  if (m.any("geom_surfacevel", geom, m.size("ngeom"))) lose("surface_velocity");
}

}  // namespace

void add_surfaces(const Compiled& m, foreign::Model& model) {
  Pairs apart = excluded(m);
  add_free_children(m, apart);
  std::set<int> named;
  for (const auto& [a, b] : apart) named.insert(a), named.insert(b);
  const std::string collision = m.collision();
  if (collision != "dynamic")  // where MuJoCo leaves them out
    for (int i = 0; i < m.size("npair"); ++i)
      model.losses.push_back({"contact_pair", m.place("pair", i), ""});

  std::map<Surface, int> numbers;
  if (m.disabled("contact") || m.disabled("constraint")) {
    for (int geom = 0; geom < m.size("ngeom"); ++geom)
      model.losses.push_back({"visual", m.place("geom", geom), "contacts are disabled"});
    return;
  }
  for (int geom = 0; geom < m.size("ngeom"); ++geom) {
    Surface s{.type = m.integer("geom_contype", geom),
              .affinity = m.integer("geom_conaffinity", geom),
              .dimension = m.integer("geom_condim", geom),
              .priority = m.integer("geom_priority", geom),
              .friction = m.friction_of_all().value_or(m.number("geom_friction", 3 * geom))};
    if (collision == "predefined" || (s.type == 0 && s.affinity == 0)) {
      model.losses.push_back({"visual", m.place("geom", geom), ""});
      continue;
    }
    const int body = m.integer("geom_bodyid", geom);
    if (named.contains(body)) s.body = body;
    lose_of_geom(m, geom, s, model);
    Solid solid = solid_of(m, geom);
    solid.surface = numbers.try_emplace(s, static_cast<int>(numbers.size())).first->second;
    model.bodies[static_cast<std::size_t>(body)].solids.push_back(std::move(solid));
  }
  constexpr std::size_t most = 1000;
  if (numbers.size() > most) {
    model.losses.push_back(
        {"too_large", {"geom", "", 0}, fmt::format("{} kinds of surface", numbers.size())});
    return;
  }
  for (const auto& [a, i] : numbers)
    for (const auto& [b, j] : numbers)
      if (i <= j && touch(a, b, apart)) model.meetings.push_back(meeting_of(i, a, j, b));
}

}  // namespace cylon::imports
