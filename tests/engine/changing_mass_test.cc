// Bodies that lose or gain mass while joints and surfaces hold them.
#include "engine/world.h"
#include "tests/engine/pile/pile_fixtures.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace cylon::engine {
namespace {

// Two bodies that swing from a locked one; `rate`: of the mass of the first; `last`: the locked one is.
Model swing(Real rate, bool last) {
  Model model;
  model.forces.gravity = Vector3(0, -g, 0);
  const auto add_one = [&](const Vector3& p, const Vector3& v, bool locked) {
    model.bodies.push_back(make_body(Real(1.3), Matrix3::Identity() * Real(0.1), locked));
    model.motions.push_back(make_motion(model.bodies.back(), p, Quaternion::Identity(), v, Vector3::Zero()));
    model.shapes.emplace_back();
    model.surfaces.push_back(no_surface);
  };
  const Vector3 pivot(0, 0, 0), middle(Real(0.6), Real(-0.3), Real(0.1)), end(1, Real(-0.9), Real(-0.2));
  if (!last) add_one(pivot, Vector3::Zero(), true);
  add_one(middle, Vector3::Zero(), false);
  add_one(end, Vector3::Zero(), false);
  if (last) add_one(pivot, Vector3::Zero(), true);
  // A rod from the locked body to the first, and a ball joint off the centres between the two that move.
  const int first = last ? 0 : 1, anchor = last ? 2 : 0;
  Joint rod;
  rod.body = first, rod.to = anchor;
  rod.type.place = Joint::Place::at_length;
  rod.length = (middle - pivot).norm();
  Joint ball;
  ball.body = first + 1, ball.to = first;
  ball.anchor = Vector3(Real(-0.1), Real(0.4), Real(0.2));
  ball.to_anchor = end + ball.anchor - middle;
  ball.type.place = Joint::Place::together;
  model.joints = {rod, ball};
  model.bodies[static_cast<std::size_t>(first)].mass_rate = rate;
  Thrust dust;
  dust.body = first, dust.mass_rate = rate, dust.relative = true;
  model.forces.thrusts.push_back(dust);
  return model;
}

// Places and rates of turn.
std::vector<Vector3> after(const Model& model, const char* integrator, double dt, int steps) {
  Options options;
  options.dt = dt;
  options.integrator = integrator;
  World world(model, options);
  for (int k = 0; k < steps; ++k) world.step();
  EXPECT_TRUE(world.remarks().empty()) << world.remarks().front();
  std::vector<Vector3> result;
  for (std::size_t i = 0; i < world.motions().size(); ++i) {
    result.push_back(world.motions()[i].position);
    result.push_back(angular_velocity(world.bodies()[i], world.motions()[i]));
  }
  return result;
}

Real apart(const std::vector<Vector3>& a, const std::vector<Vector3>& b) {
  Real most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, (a[i] - b[i]).norm());
  return most;
}

// A joint took the momentum that the dust carries for a force, so that rk4 was of first order, and was closed with
// the masses of the last stage, so that auto was off by 1e-2.
TEST(ChangingMass, HeldByJointsConverges) {
  for (const bool last : {false, true})
    for (const Real rate : {Real(-0.4), Real(0.7)}) {
      const Model model = swing(rate, last);
      const auto exact = after(model, "auto", 0.01, 100);
      for (const auto& [integrator, order] : {std::pair("rk4", 4), std::pair("velocity-verlet", 2)}) {
        const Real coarse = apart(after(model, integrator, 0.01, 100), exact);
        const Real fine = apart(after(model, integrator, 0.005, 200), exact);
        EXPECT_LT(coarse, order == 4 ? Real(1e-5) : Real(1e-2)) << integrator << ", " << rate;
        EXPECT_NEAR(std::log2(coarse / fine), order, Real(0.3)) << integrator << ", " << rate;
      }
    }
}

// A ball that rolls down a slope: a = 5/7 g sin for a solid ball whatever it weighs, but here the inertia stays
// while the mass goes, so the law is  a = g sin m/(m + I/r^2)  with m(t).
TEST(ChangingMass, OfABallThatRollsFollowsItsLaw) {
  const Real rate = Real(-0.3), radius = Real(0.25), m0 = 1, inertia = Real(0.4) * m0 * radius * radius;
  const Vector3 n = Vector3(Real(0.3), 1, 0).normalized(), down = Vector3(n.y(), -n.x(), 0);
  Model model = pile_model(0, Real(0.8), false);
  model.planes = {Plane{n, 0}}, model.plane_surfaces = {0};
  add_ball(model, m0, radius, radius * n);
  model.bodies[0].mass_rate = rate;
  Thrust dust;
  dust.body = 0, dust.mass_rate = rate, dust.relative = true;
  model.forces.thrusts.push_back(dust);
  Options options;
  options.dt = 0.01;
  options.path = "events";
  World world(model, options);
  for (int k = 0; k < 100; ++k) world.step();
  // v(1) = g sin int_0^1 m/(m + c) dt,  c = I/r^2,  m = m0 + rate t:  g sin (1 - c/rate ln((m0 + rate + c)/(m0 + c)))
  const double c = static_cast<double>(inertia / (radius * radius)), r = static_cast<double>(rate);
  const double speed = static_cast<double>(g * n.x()) * (1 - c / r * std::log((1 + r + c) / (1 + c)));
  const Vector3 v = velocity(world.bodies()[0], world.motions()[0]);
  EXPECT_NEAR(static_cast<double>(v.dot(down)), speed, 1e-9);
}

}  // namespace
}  // namespace cylon::engine
