// Every solution with contacts refuses what it cannot serve and says which condition failed: a row for each.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/contact_scenes.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

using S = core::Scene;

core::Truth make(std::string_view name, const core::Scene& scene, double horizon = 2) {
  for (const Solution& solution : catalogue()) {
    if (solution.name == name) return solution.make(scene, horizon);
  }
  throw std::runtime_error("no solution " + std::string(name));
}

struct Refusal {
  const char* reason;
  void (*change)(S&);
};

const std::vector<Refusal> common = {
    {"no body", [](S& s) { s.bodies.clear(); }},
    {"is locked", [](S& s) { s.bodies[0].locked = true; }},
    {"has no positive mass", [](S& s) { s.bodies[0].mass = 0; }},
    {"frame",
     [](S& s) {
       s.frame = core::Frame{{0, 0, 0}, {0, 1, 0}};
     }},
    {"drag on body",
     [](S& s) {
       s.forces.emplace_back(core::Drag{0, 1, 0, 0});
     }},
    {"spring on body", [](S& s) { s.forces.emplace_back(core::Spring{}); }},
    {"water", [](S& s) { s.forces.emplace_back(core::Water{}); }},
    {"has a joint", [](S& s) { s.joints.emplace_back(); }},
};

struct Table {
  const char* solution;
  unsigned seed;
  std::vector<Refusal> rows;
};

const std::vector<Table> tables = {
    {"sphere_two_walls",
     3,
     {{"two planes", [](S& s) { s.planes.pop_back(); }},
      {"do not face each other", [](S& s) { s.planes[1].normal *= -1; }},
      {"gravity acts across", [](S& s) { s.forces.emplace_back(core::UniformGravity{}); }},
      {"is not a sphere",
       [](S& s) {
         s.bodies[0].shape = core::Box{{1, 1, 1}};
       }},
      {"does not collide", [](S& s) { s.bodies[0].collide = false; }},
      {"no material", [](S& s) { s.materials.pop_back(); }},
      {"and plane 'right' apart",
       [](S& s) {
         s.bodies[0].collision_groups = {"ghosts"};
         s.planes[1].collision_mask = {"default"};
       }},
      {"friction of", [](S& s) { s.materials[0].friction = 0.1; }},
      {"starts inside plane 'left'", [](S& s) { s.bodies[0].initial.position -= 9 * s.planes[0].normal; }},
      {"has no room",
       [](S& s) {
         std::get<core::Sphere>(s.bodies[0].shape).radius = 9;
         s.planes[0].offset -= 12;
       }},
      {"does not turn about a principal axis",
       [](S& s) { s.bodies[0].inertia = core::Vector3(1, 2, 2.5).asDiagonal(); }},
      {"more than 100000 impacts",
       [](S& s) {
         s.bodies[0].initial.velocity = 1e6 * s.planes[0].normal;
         s.materials = {{{"*", "*"}, 1, 0}};
       }},
      {"may touch body 'other'",
       [](S& s) {
         s.bodies.push_back(s.bodies[0]);
         s.bodies[1].name = "other";
         s.bodies[1].initial.position +=
             1.5 * s.bodies[0].initial.velocity.cross(s.planes[0].normal).normalized();
         s.bodies[1].initial.velocity = {0, 0, 0};
         s.bodies[0].initial.velocity = s.bodies[1].initial.position - s.bodies[0].initial.position;
         s.materials = {{{"*", "*"}, 1, 0}};
       }}}},
    {"sphere_row",
     4,
     {{"has plane 'floor'",
       [](S& s) {
         s.planes.push_back({"floor", {0, 1, 0}, -9});
       }},
      {"is not a sphere", [](S& s) { s.bodies[1].shape = std::monostate{}; }},
      {"no material", [](S& s) { s.materials.clear(); }},
      {"friction of", [](S& s) { s.materials[0].friction = 0.1; }},
      {"overlap at the start", [](S& s) { s.bodies[1].initial.position = s.bodies[0].initial.position; }},
      {"is not in line with", [](S& s) { s.bodies[2].initial.position.x() += 1e-3; }},
      {"does not move along the line", [](S& s) { s.bodies[2].initial.velocity.x() += 1e-3; }},
      {"impacts at one instant are to be simultaneous",
       [](S& s) {
         s.impacts = core::Impacts::simultaneous;
         s.materials[0].restitution = 1;
         for (core::Body& b : s.bodies) b = s.bodies[0], b.name += "'", b.initial.velocity.z() = 0;
         for (std::size_t i = 1; i < 4; ++i) {
           s.bodies[i].initial.position.z() +=
               2 * std::get<core::Sphere>(s.bodies[0].shape).radius * double(i);
           s.bodies[i].name += std::to_string(i);
           s.bodies[i].initial.velocity = s.bodies[0].initial.velocity;
         }
         s.bodies[0].initial.position.z() -= 1;
         s.bodies[0].initial.velocity.z() += 3;
       }},
      {"its events are not certain",  // a ball struck from both sides at once
       [](S& s) {
         s.bodies.resize(3);
         for (std::size_t i = 0; i < 3; ++i) {
           s.bodies[i].shape = core::Sphere{0.5};
           s.bodies[i].initial.position = {0, 0, 2.0 * double(i)};
           s.bodies[i].initial.velocity = {0, 0, 1 - double(i)};
         }
       }},
      {"more than 20000 impacts",  // a light ball that rattles between two heavy ones
       [](S& s) {
         s.materials[0].restitution = 1;
         s.bodies.resize(3);
         for (std::size_t i = 0; i < 3; ++i) {
           s.bodies[i].mass = i == 1 ? 1e-12 : 1;
           s.bodies[i].shape = core::Sphere{0.5};
           s.bodies[i].initial.position = {0, 0, 2.0 * double(i)};
           s.bodies[i].initial.velocity = {0, 0, i == 1 ? 1e5 : 0.0};
         }
       }}}},
    {"sliding_block",
     2,
     {{"one plane", [](S& s) { s.planes.clear(); }},
      {"gravity does not point into", [](S& s) { s.forces.clear(); }},
      {"is not a box", [](S& s) { s.bodies[0].shape = core::Sphere{1}; }},
      {"does not lie flat",
       [](S& s) { s.bodies[0].initial.orientation = core::Quaternion(0.9, 0.1, 0.2, 0.3); }},
      {"does not touch", [](S& s) { s.bodies[0].initial.position += 1e-6 * s.planes[0].normal; }},
      {"does not move along the plane", [](S& s) { s.bodies[0].initial.velocity += s.planes[0].normal; }},
      {"turns", [](S& s) { s.bodies[0].initial.angular_velocity = s.planes[0].normal; }},
      {"line of steepest descent",
       [](S& s) { s.bodies[0].initial.velocity += s.bodies[0].initial.velocity.cross(s.planes[0].normal); }},
      {"no material", [](S& s) { s.materials.clear(); }},
      {"may tip over",
       [](S& s) {
         std::get<core::Box>(s.bodies[0].shape).half_extents.y() += 3;
         s.bodies[0].initial.position += 3 * s.planes[0].normal;
       }}}},
    {"rough_sphere",
     6,
     {{"one plane", [](S& s) { s.planes.clear(); }},
      {"gravity points out", [](S& s) { s.forces = {core::UniformGravity{5 * s.planes[0].normal}}; }},
      {"is not a sphere",
       [](S& s) {
         s.bodies[0].shape = core::Box{{1, 1, 1}};
       }},
      {"same moment of inertia", [](S& s) { s.bodies[0].inertia(0, 0) *= 1.01; }},
      {"no material", [](S& s) { s.materials.clear(); }},
      {"starts inside", [](S& s) { s.bodies[0].initial.position -= 9 * s.planes[0].normal; }},
      {"not clear of the plane",
       [](S& s) {
         const double r = std::get<core::Sphere>(s.bodies[0].shape).radius;
         s.bodies[0].initial.position = (r + 1e-8) * s.planes[0].normal;
       }},
      {"neither level nor a slope",
       [](S& s) {
         const core::Vector3 n = s.planes[0].normal;
         s.forces = {core::UniformGravity{-9 * n + 1e-7 * n.unitOrthogonal()}};
       }},
      {"neither none nor along the slope",
       [](S& s) {
         const core::Vector3 n = s.planes[0].normal, a = n.unitOrthogonal();
         s.forces = {core::UniformGravity{-9 * n + a}};
         s.bodies[0].initial.position = std::get<core::Sphere>(s.bodies[0].shape).radius * n;
         s.bodies[0].initial.velocity = 3 * a.cross(n) + a;
       }},
      {"more than 20000 bounces",
       [](S& s) {
         s.materials[0].restitution = 1;
         s.bodies[0].initial.position =
             (std::get<core::Sphere>(s.bodies[0].shape).radius + 1e-4) * s.planes[0].normal;
         s.bodies[0].initial.velocity = {0, 0, 0};
         s.forces = {core::UniformGravity{-1e6 * s.planes[0].normal}};
       }}}},
};

void expect_refused(const Table& table, const Refusal& row) {
  SCOPED_TRACE(row.reason);
  core::Scene scene = ContactScenes(table.seed).scene(table.solution);
  row.change(scene);
  try {
    make(table.solution, scene);
    ADD_FAILURE() << table.solution << " accepted the scene";
  } catch (const core::OutOfDomain& refusal) {
    EXPECT_NE(std::string(refusal.what()).find(row.reason), std::string::npos) << refusal.what();
    EXPECT_EQ(std::string(refusal.what()).find(table.solution), 0u) << refusal.what();
  }
}

TEST(ContactDomain, refusals) {
  for (const Table& table : tables) {
    SCOPED_TRACE(table.solution);
    const core::Scene good = ContactScenes(table.seed).scene(table.solution);
    EXPECT_NO_THROW(make(table.solution, good));
    EXPECT_THROW(make(table.solution, good, 0), core::OutOfDomain);
    for (const Refusal& row : common) expect_refused(table, row);
    for (const Refusal& row : table.rows) expect_refused(table, row);
  }
}

// Names of scenarios that mean one of these solutions.
TEST(ContactDomain, names) {
  for (const auto& [name, solution] :
       std::vector<std::pair<std::string, std::string>>{{"block_slides", "sliding_block"},
                                                        {"block_sticks", "sliding_block"},
                                                        {"block_stops", "sliding_block"},
                                                        {"block_uphill", "sliding_block"},
                                                        {"newtons_cradle", "sphere_row"},
                                                        {"newtons_cradle_gapped", "sphere_row"},
                                                        {"two_sphere_head_on", "sphere_row"},
                                                        {"rough_ball_bounce", "rough_sphere"},
                                                        {"rolling_sphere_incline", "rough_sphere"},
                                                        {"slide_to_roll", "rough_sphere"},
                                                        {"slipping_sphere_incline", "rough_sphere"}}) {
    const core::Scene scene = ContactScenes(8).scene(solution);
    EXPECT_EQ(make(name, scene).source, make(solution, scene).source);
  }
}

}  // namespace
}  // namespace cylon::exact
