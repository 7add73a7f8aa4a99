// The contact forces that are told are those that move the bodies: m dv = m g dt + sum J in each step of each path, over scenes in which bodies of several shapes fall, bounce, slide, roll, stack and rest.
#include "engine/world.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace cylon::engine {
namespace {

// Balls and boxes in turns, dropped into an open box; as many layers as asked for.
Model mixed_heap(int side, int layers, Real restitution, bool boxes_alone) {
  Model model = ball_pile(side, layers, restitution, Real(0.5));
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    if (!boxes_alone && i % 2 == 0) continue;
    model.bodies[i] = make_body(Real(1.5), Matrix3::Identity() / 4);
    model.shapes[i] = Box{Vector3::Constant(Real(0.5))};
  }
  return model;
}

// A slope that bears what slips, what sticks and what rolls; `last`: a locked box under a ball stands first.
Model on_a_slope(Real friction) {
  Model model = pile_model(0, friction, false);
  const Vector3 n = Vector3(Real(0.3), 1, Real(-0.1)).normalized();
  model.planes = {Plane{n, 0}}, model.plane_surfaces = {0};
  const Quaternion upright = Quaternion::FromTwoVectors(Vector3::UnitY(), n);
  const Body slab = make_body(3, Matrix3::Identity(), true);
  add_body(model, slab, Box{Vector3(1, Real(0.2), 1)}, Vector3(9, 0, 0), Vector3::Zero(), Vector3::Zero());
  add_box(model, 2, Vector3(Real(0.4), Real(0.2), Real(0.3)),
          Vector3(0, 0, 4) + Real(0.2) * n - n * n.z() * 4, Vector3::Zero(), Vector3::Zero(), upright);
  add_ball(model, Real(1.3), Real(0.25), Vector3(2, 0, -1) + n * (Real(0.25) - Real(2) * n.x() + n.z()));
  add_ball(model, Real(0.7), Real(0.3), Vector3(9, Real(0.5), 0), Vector3(Real(0.4), 0, Real(-0.2)));
  return model;
}

struct Scene {
  const char* name;
  Model model;
  const char* path;
  int steps;
  int least;    // steps of bodies whose forces are all told
  Real curved;  // most that a force which changes within the step may be off, of all that acts; 0: rounding
};

struct Balance {
  double worst = 0;  // of all that acts on a body in a step
  int told = 0;      // steps of bodies whose forces are all told
  std::string where;
};

// What the contacts of a step give to each body [N s], and whether all of it is told.
struct Given {
  explicit Given(std::size_t bodies) : impulse(bodies, Vector3::Zero()), size(bodies, 0), known(bodies, 0) {}
  void add(const Contact& c) {
    for (const auto& [body, sign] : {std::pair(c.body, 1), std::pair(c.other, -1)}) {
      if (body == fixed_world) continue;
      const auto i = static_cast<std::size_t>(body);
      if (!c.impulse || !c.friction) {
        known[i] = untold;
        continue;
      }
      if (known[i] != untold) known[i] = 1;
      impulse[i] += static_cast<Real>(sign) * (*c.impulse * c.normal + *c.friction);
      size[i] += *c.impulse + c.friction->norm();
      EXPECT_LE(std::abs(c.friction->dot(c.normal)), 1000 * eps * (1 + c.friction->norm()));
    }
  }
  static constexpr int untold = -1;
  std::vector<Vector3> impulse;
  std::vector<Real> size;
  std::vector<int> known;
};

Balance balance(const Scene& scene, double dt, int steps) {
  const Model& model = scene.model;
  Options options;
  options.dt = dt;
  options.path = scene.path;
  World world(model, options), plain(model, options);
  world.keep_contacts(true);
  Balance result;
  for (int k = 0; k < steps; ++k) {
    const std::vector<Motion> before = world.motions();
    world.step(), plain.step();
    Given given(model.bodies.size());
    for (const Contact& c : world.contacts()) given.add(c);
    for (std::size_t i = 0; i < model.bodies.size(); ++i) {
      const Vector3 &p = world.motions()[i].momentum, &p_before = before[i].momentum;
      EXPECT_EQ(p, plain.motions()[i].momentum) << "telling moves nothing";
      if (model.bodies[i].locked || given.known[i] != 1) continue;
      ++result.told;
      const Real weight = model.bodies[i].mass * g * static_cast<Real>(dt);
      const Vector3 off = p - p_before + weight * Vector3::UnitY() - given.impulse[i];
      // Laid to rest: before and after the step whose impulses are told from then on, the speed was at most 2^-20 of what
      // gravity gives in a step, so they are off by at most twice that; so are those that are struck in that step.
      const Real laid = 2 * weight / (1 << 20);
      if ((p.isZero(0) || p_before.norm() <= laid) && off.norm() <= laid) continue;
      const auto part =
          static_cast<double>(off.norm() / (weight + given.size[i] + p_before.norm() + p.norm()));
      if (part > result.worst)
        result.worst = part, result.where = "step " + std::to_string(k) + ", body " + std::to_string(i);
    }
  }
  return result;
}

TEST(ContactsTold, AreTheForcesThatMoveTheBodies) {
  const Scene scenes[] = {
      {"balls", ball_pile(3, 3, Real(0.3), Real(0.5)), "stepping", 200, 2000, 0},
      {"boxes, few", mixed_heap(2, 1, 0, true), "stepping", 200, 500, 0},
      {"boxes, many", mixed_heap(4, 3, 0, true), "stepping", 150, 3000, 0},
      {"boxes that bounce", mixed_heap(3, 2, Real(0.4), true), "stepping", 150, 1000, 0},
      {"balls and boxes", mixed_heap(4, 2, Real(0.2), false), "stepping", 150, 1500, 0},
      {"a slope that slips", on_a_slope(Real(0.1)), "stepping", 100, 200, 0},
      {"a slope that holds", on_a_slope(1), "events", 100, 200, 0},
      {"a slope that slips", on_a_slope(Real(0.1)), "events", 100, 200, 0},
      {"balls one by one", ball_pile(2, 1, Real(0.3), 0), "events", 150, 100, 0},
      {"balls on balls", ball_pile(2, 2, Real(0.3), 0), "", 150, 100, Real(2e-5)},
      {"balls on balls that do not bounce", ball_pile(2, 2, 0, 0), "", 150, 100, Real(2e-5)},
      {"a ball and a box", mixed_heap(1, 2, Real(0.3), false), "events", 150, 50, Real(2e-5)},
  };
  constexpr double dt = 1. / 120;
  for (const Scene& scene : scenes) {
    const Balance found = balance(scene, dt, scene.steps);
    // Two bodies in the air get back what angular momentum it cost to move them apart: 6e-11 of all that acts.
    const double rounding = 1e6 * static_cast<double>(eps);
    EXPECT_LT(found.worst, static_cast<double>(scene.curved) + rounding)
        << scene.name << ", path '" << scene.path << "': " << found.where;
    EXPECT_GE(found.told, scene.least) << scene.name << ", path '" << scene.path << "'";
    // The mean of the forces at both ends: dt^3 of an impulse that grows with dt.
    if (scene.curved > 0) {
      const Balance fine = balance(scene, dt / 2, 2 * scene.steps);
      EXPECT_LT(fine.worst, found.worst / 3) << scene.name << ": " << fine.where;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
