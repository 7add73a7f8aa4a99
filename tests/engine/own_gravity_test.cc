// A gravity that every body states is the same as that of all, on every path; one body's own moves that body alone.
#include "engine/methods.h"
#include "engine/world.h"
#include "tests/engine/fixtures.h"

#include <gtest/gtest.h>

namespace cylon::engine {
namespace {

const Vector3 pull = {Real(0.3), Real(-9.1), Real(0.4)};

Model balls_on_floor(int count) {
  Model model;
  for (int i = 0; i < count; ++i) {
    const Real x = Real(0.63) * static_cast<Real>(i % 3),
               y = Real(0.4) + Real(0.7) * static_cast<Real>(i / 3);
    add_body(model, make_body(Real(0.8), Matrix3::Identity() * Real(0.03)), {x, y, Real(0.11) * x}, {0, 0, 0},
             {Real(0.2), Real(-0.4), Real(0.1)}, {Real(0.5), 0, Real(0.3)}, Sphere{Real(0.3)});
  }
  model.planes = {{Vector3::UnitY(), 0}};
  make_touchable(model, Real(0.5), Real(0.3));
  return model;
}

Model boxes_on_floor(int count) {
  Model model = balls_on_floor(count);
  for (std::size_t i = 0; i < model.shapes.size(); ++i) {
    model.shapes[i] = Box{{Real(0.2), Real(0.15), Real(0.25)}};
    model.bodies[i] = make_body(1, general_inertia(Real(0.03), Real(0.035), Real(0.04)));
  }
  make_touchable(model, 0, Real(0.3));
  return model;
}

Model sprung(Real rest_length) {
  Model model;
  for (int i = 0; i < 2; ++i)
    add_body(model, make_body(Real(1.2), Matrix3::Identity()),
             {Real(0.9) * static_cast<Real>(i), Real(0.3), 0}, {0, 0, 0}, {Real(0.2), Real(0.1), Real(0.4)},
             {0, 0, 0});
  model.forces.springs.push_back({0, Vector3::Zero(), 1, Vector3::Zero(), 9, rest_length});
  model.forces.springs.push_back({0, Vector3::Zero(), fixed_world, {Real(0.1), 1, Real(0.2)}, 7, 0});
  return model;
}

struct Row {
  const char* name;
  Model model;
  Options options;
  Path path;
  Real allowed;  // of positions [m]
};

std::vector<Row> rows() {
  const Options plain{.dt = 1. / 256};
  Options full = plain, events = plain, stepping = plain, rk = with("rk8", 1. / 256);
  full.full = true, events.path = "events", stepping.path = "stepping";
  Model jointed = linked_bodies(true);
  const Real bits = 0, near = sizeof(Real) == 8 ? Real(1e-7) : Real(1e-2);
  return {{"free", free_top(), plain, Path::exact, bits},
          {"full", free_top(), full, Path::events, near},
          {"modes", sprung(0), plain, Path::modes, bits},
          {"points", sprung(Real(0.5)), rk, Path::points, near},
          {"top", heavy_top(), rk, Path::bodies, near},
          {"joints", jointed, rk, Path::bodies, near},
          {"forces", forced_bodies(), rk, Path::bodies, near},
          {"ballistic", balls_on_floor(2), plain, Path::ballistic, bits},
          {"events", balls_on_floor(2), events, Path::events, near},
          {"spheres in steps", balls_on_floor(12), stepping, Path::stepping, near},
          {"boxes in steps", boxes_on_floor(4), stepping, Path::stepping, near}};
}

std::vector<Motion> run(const Model& model, const Options& options) {
  EXPECT_EQ(unsupported(model, options), "");
  World world(model, options);
  world.advance(120);
  return world.motions();
}

Real apart(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i].position - b[i].position).norm());
  return most;
}

TEST(OwnGravity, OfAllBodiesIsThatOfAll) {
  for (Row& row : rows()) {
    SCOPED_TRACE(row.name);
    row.model.forces.gravity = pull;
    Model own = row.model;
    own.forces.gravity = {2, 1, -3};
    for (Body& body : own.bodies) body.gravity = pull;
    EXPECT_EQ(make_plan(own, row.options).path, row.path);
    EXPECT_EQ(make_plan(row.model, row.options).path, row.path);
    const std::vector<Motion> expected = run(row.model, row.options);
    EXPECT_LE(apart(run(own, row.options), expected), row.allowed);
    // The control: it is seen.
    own.bodies.front().gravity = Vector3(2 * pull);
    EXPECT_GT(apart(run(own, row.options), expected), Real(1e-3));
  }
}

// Zero switches it off: a body floats beside others that fall, on every path that both can take.
TEST(OwnGravity, OfOneMovesOneAlone) {
  for (const bool full : {false, true})
    for (const char* path : {"", "events", "stepping"}) {
      Model model = balls_on_floor(3);
      model.forces.gravity = pull;
      for (Motion& motion : model.motions) motion.momentum.setZero();
      for (std::size_t i = 0; i < 3; ++i)
        model.motions[i].position += Vector3(3 * static_cast<Real>(i), 5, 0);
      model.bodies[1].gravity = Vector3::Zero(), model.bodies[2].gravity = Vector3(1, 0, 2);
      Options options{.dt = 1. / 256, .path = path, .full = full};
      const std::vector<Motion> end = run(model, options);
      const Real t = Real(120) / 256;
      EXPECT_EQ(end[1].position, model.motions[1].position) << path;
      const Real order = std::string(path) == "stepping" ? Real(0.05) : Real(1e-5);
      EXPECT_LE((end[2].position - model.motions[2].position - t * t / 2 * Vector3(1, 0, 2)).norm(), order)
          << path;
      EXPECT_LE((end[0].position - model.motions[0].position - t * t / 2 * pull).norm(), order) << path;
    }
}

// A ball without weight under one with: pressed together, they go on by what can express it.
TEST(OwnGravity, HoldsInLastingContacts) {
  Model model = balls_on_floor(2);
  model.forces.gravity = {0, Real(-9.81), 0};
  make_touchable(model, 0, 0);
  for (Motion& motion : model.motions) motion.momentum.setZero(), motion.angular_momentum.setZero();
  model.motions[0].position = {0, Real(0.3), 0}, model.motions[1].position = {0, Real(0.9), 0};
  model.bodies[0].gravity = Vector3(0, Real(9.81) / 2, 0);  // half of what presses on it
  const std::vector<Motion> end = run(model, {.dt = 1. / 256});
  EXPECT_NEAR(static_cast<double>(end[0].position.y()), 0.3, 1e-3);
  EXPECT_NEAR(static_cast<double>(end[1].position.y()), 0.9, 1e-3);
  model.bodies[0].gravity = Vector3(0, 3 * Real(9.81), 0);  // three times
  const std::vector<Motion> lifted = run(model, {.dt = 1. / 256});
  const double t = 120. / 256, rise = 9.81 * t * t / 2;
  EXPECT_NEAR(static_cast<double>(lifted[1].position.y()), 0.9 + rise, 0.02);
}

}  // namespace
}  // namespace cylon::engine
