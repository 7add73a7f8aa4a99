// A solution with contacts refuses a scene whose groups take them away, and spheres of a row go through those that
// their groups keep them apart from.
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/contact_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

using core::Scene;

core::Truth make(std::string_view name, const Scene& scene, double horizon) {
  for (const Solution& solution : catalogue())
    if (solution.name == name) return solution.make(scene, horizon);
  throw std::runtime_error("no solution " + std::string(name));
}

Scene box_and(core::Vector3 box_at, const core::Shape& other) {
  Scene scene;
  for (const core::Shape& shape : {core::Shape(core::Box{{0.3, 0.2, 0.25}}), other}) {
    core::Body body;
    body.name = "body" + std::to_string(scene.bodies.size()), body.shape = shape, body.collide = true;
    body.inertia = core::Vector3(0.034, 0.05, 0.043).asDiagonal();
    scene.bodies.push_back(body);
  }
  scene.bodies[0].initial.position = box_at;
  scene.materials = {{{"*", "*"}, 0.5, 0}};
  return scene;
}

Scene rod_hit() {
  Scene scene = box_and({0, 0, 0}, core::Sphere{0.1});
  scene.bodies[1].inertia = 0.004 * core::Matrix3::Identity();
  scene.bodies[1].initial.position = {0.1, 1, 0.05}, scene.bodies[1].initial.velocity = {0, -2, 0};
  return scene;
}

Scene box_drop() {
  Scene scene = box_and({0, 1, 0}, {});
  scene.bodies.pop_back();
  scene.bodies[0].initial.orientation = core::Quaternion(std::cos(0.1), 0, 0, std::sin(0.1));
  scene.planes = {{"floor", {0, 1, 0}, 0}};
  scene.forces.emplace_back(core::UniformGravity{});
  return scene;
}

TEST(CollisionGroups, EndSolutionsWithContacts) {
  struct Row {
    const char* solution;
    Scene scene;
    double horizon;
  };
  std::vector<Row> rows = {{"bouncing_sphere", ReferenceFile("bouncing_sphere").scene, 2},
                           {"two_sphere_oblique", ReferenceFile("two_sphere_oblique").scene, 2},
                           {"rod_offcentre_hit", rod_hit(), 0.6},
                           {"box_drop_edge", box_drop(), 0.4}};
  for (const char* name : {"sphere_two_walls", "sliding_block", "rough_sphere"})
    rows.push_back({name, ContactScenes(8).scene(name), 2});
  for (const Row& row : rows) {
    SCOPED_TRACE(row.solution);
    EXPECT_NO_THROW(make(row.solution, row.scene, row.horizon));
    Scene scene = row.scene;  // groups that change nothing
    for (core::Body& body : scene.bodies) body.collision_groups = {"a"};
    EXPECT_NO_THROW(make(row.solution, scene, row.horizon));
    scene.bodies[0].collision_mask = {"b"};
    try {
      make(row.solution, scene, row.horizon);
      ADD_FAILURE() << "accepted";
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_NE(std::string(refusal.what()).find("collision groups keep body"), std::string::npos)
          << refusal.what();
    }
  }
}

// Several balls in one place, each on the same floor.
TEST(CollisionGroups, LetBallsBounceInOnePlace) {
  Scene scene = ReferenceFile("bouncing_sphere").scene;
  const core::Truth alone = make("bouncing_sphere", scene, 2);
  scene.bodies.push_back(scene.bodies[0]);
  scene.bodies[1].name = "twin";
  scene.materials = {{{"*", "*"}, core::material_of(scene, {0, core::world, 0})->restitution, 0}};
  EXPECT_THROW(make("bouncing_sphere", scene, 2), core::OutOfDomain);
  scene.bodies[1].collision_groups = {"twin"}, scene.planes[0].collision_groups = {"floor"};
  scene.bodies[1].collision_mask = {"floor"};
  const core::Truth both = make("bouncing_sphere", scene, 2);
  for (const double t : {0.3, 0.9, 1.7})
    for (std::size_t i : {0u, 1u}) {
      EXPECT_EQ(both.state(t)[i].position, alone.state(t)[0].position);
      EXPECT_EQ(both.state(t)[i].velocity, alone.state(t)[0].velocity);
    }
}

// Two rows in one line that do not meet move as each does alone.
TEST(CollisionGroups, RowsGoThroughEachOther) {
  const Scene one = ContactScenes(4).scene("sphere_row");
  Scene other = one;
  for (core::Body& body : other.bodies) {  // from the other side, slower
    body.name += "'", body.collision_groups = {"other"}, body.collision_mask = {"other"};
    body.initial.position.z() = 1.7 - 0.8 * (body.initial.position.z() - one.bodies[0].initial.position.z()) +
                                one.bodies[0].initial.position.z();
    body.initial.velocity.z() = 0.3 - 0.5 * body.initial.velocity.z();
    std::get<core::Sphere>(body.shape).radius *= 0.7;
  }
  Scene both = one;
  both.bodies.insert(both.bodies.end(), other.bodies.begin(), other.bodies.end());
  const core::Truth a = make("sphere_row", one, 3), b = make("sphere_row", other, 3),
                    together = make("sphere_row", both, 3);
  EXPECT_GT(a.events.size(), 1u);
  EXPECT_GT(b.events.size(), 1u);
  EXPECT_EQ(together.events.size(), a.events.size() + b.events.size());
  const std::size_t n = one.bodies.size();
  for (int k = 0; k <= 60; ++k) {
    const double t = 0.05 * k;
    for (std::size_t i = 0; i < n; ++i) {
      EXPECT_NEAR((together.state(t)[i].position - a.state(t)[i].position).norm(), 0, 1e-14) << t;
      EXPECT_NEAR((together.state(t)[n + i].position - b.state(t)[i].position).norm(), 0, 1e-14) << t;
    }
  }
}

}  // namespace
}  // namespace cylon::exact
