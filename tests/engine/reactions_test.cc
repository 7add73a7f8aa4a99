// The forces that are told of joints are those that move the bodies, with contacts and all other forces.
#include "engine/reactions.h"

#include "tests/engine/fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>

namespace cylon::engine {
namespace {

using namespace joint_types;

constexpr Real g = Real(9.81), eps = std::numeric_limits<Real>::epsilon();

// ---- Statics ----------------------------------------------------------------------------------------

Body beam_body(Real mass) { return make_body(mass, general_inertia(Real(0.02), Real(0.03), Real(0.04))); }

// One body at (0.4, -0.2, 0.3) from what holds it, at rest.
Model held(const Joint::Type& type, Real mass) {
  Model model;
  model.forces.gravity = {0, -g, 0};
  const Vector3 place(Real(0.4), Real(-0.2), Real(0.3));
  add_body(model, beam_body(mass), place, Vector3::Zero(), Vector3::Zero(), Vector3::Zero());
  Joint joint;
  joint.type = type, joint.anchor = -place, joint.axis = joint.to_axis = Vector3::UnitY();
  model.joints = {joint};
  return model;
}

Options steps() {
  Options options;
  options.dt = 1. / 120;
  return options;
}

std::vector<Reaction> after_steps(const Model& model, const Options& options, int steps) {
  World world(model, options);
  for (int k = 1; k < steps; ++k) world.step();
  EXPECT_EQ(world.reactions().has_value(), model.joints.empty()) << "not told unless asked for";
  world.keep_contacts(true);
  world.step();
  auto told = world.reactions();
  EXPECT_TRUE(told);
  return told.value_or(std::vector<Reaction>());
}

// What is welded bears m g and its moment; so does a hinge whose axis is upright.
TEST(Reactions, OfABodyAtRestAreItsWeight) {
  for (const Joint::Type& type : {fixed, hinge})
    for (const char* path : {"", "events", "stepping"}) {
      Options options = steps();
      options.path = path;
      const std::vector<Reaction> told = after_steps(held(type, 2), options, 5);
      ASSERT_EQ(told.size(), 1U);
      const Real impulse = 2 * g * static_cast<Real>(options.dt), near = 1000 * impulse * eps;
      EXPECT_LT((told[0].impulse - Vector3(0, impulse, 0)).norm(), near) << path;
      // (-r) x m g of the weight, taken up: moment = r x (0, m g, 0) dt of the centre from the anchor
      const Vector3 moment = Vector3(Real(0.4), Real(-0.2), Real(0.3)).cross(Vector3(0, impulse, 0));
      EXPECT_LT((told[0].moment - moment).norm(), near) << path;
      EXPECT_LT(told[0].point.norm(), 1000 * eps) << path;
    }
}

// ---- Motion -----------------------------------------------------------------------------------------

struct Off {
  Real force = 0, moment = 0;  // [N s], [N m s], the largest of a step
};

// What is missing in each step for  dp = sum of impulses  and  dL = sum of moments; of all bodies.
Off off(const Model& model, const char* integrator, double dt, double duration) {
  Options options;
  options.dt = dt, options.integrator = integrator;
  World world(model, options), plain(model, options);
  world.keep_contacts(true);
  Off worst;
  for (int k = 0; k < static_cast<int>(std::lround(duration / dt)); ++k) {
    const std::vector<Motion> before = world.motions();
    std::vector<Vector3> impulse(before.size(), Vector3::Zero()), moment = impulse;
    const auto half = [&](const std::vector<Motion>& motions, Time t) {
      std::vector<Kinematics> kinematics;
      std::vector<Load> loads(motions.size());
      for (std::size_t i = 0; i < motions.size(); ++i)
        kinematics.push_back({motions[i].orientation.toRotationMatrix(),
                              velocity(world.bodies()[i], motions[i]),
                              angular_velocity(world.bodies()[i], motions[i])});
      apply(model.forces, t, world.bodies(), motions.size(), motions.data(), kinematics.data(), loads.data());
      for (std::size_t i = 0; i < motions.size(); ++i) {
        impulse[i] += static_cast<Real>(dt / 2) * loads[i].force;
        moment[i] += static_cast<Real>(dt / 2) * loads[i].torque;
      }
    };
    half(before, world.time());
    world.step(), plain.step();
    half(world.motions(), world.time());
    const auto give = [&](int body, Real sign, const Reaction& r) {
      if (body == fixed_world) return;
      const auto i = static_cast<std::size_t>(body);
      // In a step the arm moves: from the mean of both ends.
      const Vector3 middle = (before[i].position + world.motions()[i].position) / 2;
      impulse[i] += sign * r.impulse;
      moment[i] += sign * (r.moment + (r.point - middle).cross(r.impulse));
    };
    const auto told = world.reactions();
    if (!told) return ADD_FAILURE() << "not told", worst;
    for (const Reaction& r : *told) {
      give(model.joints[r.joint].body, 1, r);
      give(model.joints[r.joint].to, -1, r);
    }
    for (std::size_t i = 0; i < before.size(); ++i) {
      const Motion &was = before[i], &is = world.motions()[i];
      EXPECT_EQ(is.momentum, plain.motions()[i].momentum) << "telling moves nothing";
      if (model.bodies[i].locked) continue;
      worst.force = std::max(worst.force, (is.momentum - was.momentum - impulse[i]).norm());
      worst.moment = std::max(worst.moment, (is.angular_momentum - was.angular_momentum - moment[i]).norm());
    }
  }
  return worst;
}

struct Row {
  const char* name;
  Model model;
};

Model with(Model model, const std::function<void(Model&)>& change) {
  change(model);
  return model;
}

std::vector<Row> rows() {
  const Model linked = linked_bodies(true);
  return {
      {"a top on its tip", heavy_top()},
      {"two links", linked},
      {"two links in space", linked_bodies(false)},
      {"drag, a spring and a drive",
       with(linked,
            [](Model& m) {
              m.forces.drags.push_back({0, Real(0.3), Real(0.2), Real(0.1)});
              m.forces.springs.push_back({1,
                                          {Real(0.2), Real(0.1), Real(-0.3)},
                                          fixed_world,
                                          {Real(0.6), Real(1.9), Real(0.4)},
                                          25,
                                          Real(0.5),
                                          Real(0.6)});
              m.forces.drives.push_back({0, {Real(0.9), Real(0.4), Real(-1.1)}, Real(2.3)});
            })},
      {"the second body loses mass", with(linked,
                                          [](Model& m) {
                                            m.bodies[1].mass_rate = Real(-0.2);
                                            Thrust dust;
                                            dust.body = 1, dust.mass_rate = Real(-0.2), dust.relative = true;
                                            m.forces.thrusts.push_back(dust);
                                          })},
      {"all kept as constraints", with(linked, [](Model& m) { m.reduce_joints = false; })},
  };
}

// The trapezoid: dt^3 in a step, of forces; of moments dt^2, as the point is told of the end.
TEST(Reactions, AreWhatMovesTheBodiesToSecondOrder) {
  for (const Row& row : rows())
    for (const char* integrator : {"auto", "rk4"}) {
      const double dt = 1. / 256;
      const Off coarse = off(row.model, integrator, dt, 0.25),
                fine = off(row.model, integrator, dt / 2, 0.25);
      const std::string what = std::string(row.name) + ", " + integrator;
      EXPECT_LT(coarse.force, Real(2e-3) * g * static_cast<Real>(dt)) << what;
      EXPECT_GT(coarse.force, 6 * fine.force) << what;
      EXPECT_LT(coarse.moment, Real(0.1) * g * static_cast<Real>(dt)) << what;
      EXPECT_GT(coarse.moment, Real(3.3) * fine.moment) << what;
    }
}

// ---- With contacts ----------------------------------------------------------------------------------

// A plank of 2 m, hinged at one end and laid with the other on a ball at rest: the hinge and the ball bear
// half of it each.
TEST(Reactions, ShareALoadWithContacts) {
  Model model;
  model.forces.gravity = {0, -g, 0};
  const Real radius = Real(0.25), thick = Real(0.05);
  const Body plank = make_body(3, Vector3(Real(0.1), 1, 1).asDiagonal().toDenseMatrix());
  const Body ball = make_body(1, Matrix3::Identity() * Real(0.025), true);
  const Real height = 2 * radius + thick;
  add_body(model, plank, {0, height, 0}, Vector3::Zero(), Vector3::Zero(), Vector3::Zero(),
           Box{{1, thick, Real(0.1)}});
  add_body(model, ball, {1, radius, 0}, Vector3::Zero(), Vector3::Zero(), Vector3::Zero(), Sphere{radius});
  model.joints = {{.type = hinge,
                   .body = 0,
                   .anchor = {-1, 0, 0},
                   .to_anchor = {-1, height, 0},
                   .axis = {0, 0, 1},
                   .to_axis = {0, 0, 1}}};
  make_touchable(model, 0, Real(0.5));
  for (const char* path : {"events", "stepping"}) {
    Options options = steps();
    options.path = path;
    const std::vector<Reaction> told = after_steps(model, options, 20);
    ASSERT_EQ(told.size(), 1U) << path;
    const Real half = Real(1.5) * g * static_cast<Real>(options.dt);
    EXPECT_NEAR(told[0].impulse.y(), half, Real(1e-3) * half) << path;
  }
}

TEST(Reactions, OfLockedBodiesAreNone) {
  Model model = held(fixed, 2);
  model.bodies[0].locked = true, model.bodies[0].inverse_mass = 0, model.bodies[0].inverse_inertia.setZero();
  EXPECT_TRUE(after_steps(model, steps(), 3).empty());
  model.joints.clear();
  EXPECT_TRUE(after_steps(model, steps(), 3).empty()) << "without joints";
}

}  // namespace
}  // namespace cylon::engine
