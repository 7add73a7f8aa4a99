// A symmetric top on its tip and a spherical pendulum move like general bodies, for every integrator.
#include "engine/tops.h"

#include "tests/engine/fixtures.h"
#include "tests/engine/joint_types.h"

namespace cylon::engine {
namespace {

Model spherical_pendulum() {
  Model model;
  add_body(model, make_body(1.2, Matrix3::Zero()), {0.5, -0.7, 0.4}, {0.2, 0.1, -0.3}, {0.3, 0.5, 0.5},
           {0, 0, 0});
  model.forces.gravity = {0.2, -9.81, 0.3};
  Motion& m = model.motions[0];
  const Vector3 d = m.position.normalized();
  m.momentum -= d * d.dot(m.momentum);  // along the sphere
  model.joints.push_back({.type = joint_types::distance, .body = 0, .length = m.position.norm()});
  return model;
}

std::vector<Motion> carried(const Model& model, std::string_view integrator, Time duration, int steps,
                            bool full) {
  Options options = {.integrator = std::string(integrator), .dt = duration / steps};
  options.full = full;
  World world(model, options);
  for (int i = 0; i < steps; ++i) world.step();
  return world.motions();
}

Real apart(const Motion& a, const Motion& b) {
  return (a.position - b.position).norm() + (a.momentum - b.momentum).norm() +
         (a.angular_momentum - b.angular_momentum).norm() +
         2 * (a.orientation.conjugate() * b.orientation).vec().norm();
}

TEST(Top, IsUsedWhereItApplies) {
  EXPECT_TRUE(Top::applies(reduce(heavy_top()).model));
  EXPECT_TRUE(Top::applies(reduce(spherical_pendulum()).model));
  Model oblique = heavy_top();  // the tip is off the axis
  oblique.joints[0].anchor = {0.05, -0.3, 0};
  EXPECT_FALSE(Top::applies(reduce(oblique).model));
  Model asymmetric = heavy_top();
  asymmetric.bodies[0] = make_body(1.1, Vector3(0.02, 0.01, 0.025).asDiagonal());
  EXPECT_FALSE(Top::applies(reduce(asymmetric).model));
  Model dragged = heavy_top();
  dragged.forces.drags.push_back({0, 0.1, 0, 0});
  EXPECT_FALSE(Top::applies(reduce(dragged).model));
}

// The parts of a splitting are the same flows, so that one step differs by rounding alone; over 300 steps of
// a top at 25 rad/s each part's rounding of a turn adds up.
TEST(Top, AgreesWithGeneralSplittings) {
  for (const Model& model : {heavy_top(), spherical_pendulum()}) {
    for (const char* integrator : {"lie-trotter", "velocity-verlet", "bm4", "rkn6"}) {
      const Real difference = apart(carried(model, integrator, 1.5, 300, false)[0],
                                    carried(model, integrator, 1.5, 300, true)[0]);
      EXPECT_LT(difference, 300 * 30 * 4 * std::numeric_limits<Real>::epsilon()) << integrator;
    }
  }
}

TEST(Top, HasOrderOfIntegrator) {
  const Model model = heavy_top();
  const Motion exact = carried(model, "rk8", 0.8, 3000, true)[0];
  for (const auto& [integrator, steps, order] : {std::tuple{"velocity-verlet", 200, 2},
                                                 {"bm4", 20, 4},
                                                 {"rkn4", 20, 4},
                                                 {"bm6", 10, 6},
                                                 {"rk4", 200, 4}}) {
    const Real coarse = apart(carried(model, integrator, 0.8, steps, false)[0], exact);
    const Real fine = apart(carried(model, integrator, 0.8, 2 * steps, false)[0], exact);
    EXPECT_NEAR(std::log2(coarse / fine), order, 0.35) << integrator << " " << coarse << " " << fine;
    EXPECT_GT(fine, 1e-11);
  }
}

TEST(Top, ConservesIntegralsOfTop) {
  const Model model = heavy_top();
  const Model reduced = reduce(model).model;
  Top top(reduced);
  std::vector<Real> y = top.initial();
  const Vector3 up = model.forces.gravity.normalized();
  const auto along = [&](const Real* z) { return Vector3(z[4], z[5], z[6]).dot(up); };
  const auto spin = [&](const Real* z) {
    const Motion m = top.motion(z);
    return m.angular_momentum.dot(m.orientation * Vector3::UnitY());
  };
  const Real vertical = along(y.data()), own = spin(y.data()),
             size = reduced.motions[0].angular_momentum.norm();
  for (int i = 0; i < 1000; ++i) {
    top.kick(0, Real(0.01), y.data());
    top.drift(Real(0.02), y.data());
    top.kick(0, Real(0.01), y.data());
    top.project(y.data());
  }
  // a few roundings of L in each of 1000 steps
  EXPECT_NEAR(along(y.data()), vertical, 4000 * std::numeric_limits<Real>::epsilon() * size);
  EXPECT_NEAR(spin(y.data()), own, 4000 * std::numeric_limits<Real>::epsilon() * size);
}

}  // namespace
}  // namespace cylon::engine
