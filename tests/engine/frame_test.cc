// A frame that turns: the same motion as in the inertial frame, seen turning back.
#include "tests/engine/fixtures.h"

namespace cylon::engine {
namespace {

const Vector3 turning = {0.3, 0.7, -0.4};  // rad/s

// What a frame that agrees with the inertial one at t = 0 and turns with W sees of an inertial motion;
// momenta stay those of the inertial frame, in turned axes.
std::vector<Motion> seen(std::vector<Motion> motions, Time t) {
  const Quaternion back = exponential(-static_cast<Real>(t) * turning);
  for (Motion& m : motions) {
    m.position = back * m.position;
    m.momentum = back * m.momentum;
    m.angular_momentum = back * m.angular_momentum;
    m.orientation = back * m.orientation;
  }
  return motions;
}

Model in_frame(Model model) {
  model.frame = RotatingFrame{turning};
  return model;
}

class Frame : public EveryIntegrator {};

// Free flight and free rotation: a straight line looks curved.  A splitting makes both exactly.
TEST_P(Frame, FreeTopAgreesWithInertialSolution) {
  const Model model = free_top();
  const auto exact = seen(run(model, "rk8", 2, 2000).motions, 2);
  const auto error = [&](int n) {
    return distance(run(in_frame(model), GetParam().name, 2, n).motions, exact);
  };
  if (GetParam().kind == Kind::splitting) {
    EXPECT_LT(error(100), 1e-12);
  } else if (GetParam().order == 8) {
    EXPECT_LT(error(400), 1e-12);
  } else {
    const int n = GetParam().order == 4 ? 128 : 16384;
    EXPECT_NEAR(std::log2(error(n) / error(2 * n)), GetParam().order, 0.1);
  }
  // Negative control: without the frame it is another motion.
  EXPECT_GT(distance(run(model, GetParam().name, 2, 100).motions, exact), 0.5);
}

// Bodies on springs between them: isolated, so that forces know nothing of the frame.
TEST_P(Frame, CoupledBodiesAgreeWithInertialSolution) {
  const Model model = coupled_bodies(0.3);
  const auto exact = seen(run(model, "rk8", 1, 2000).motions, 1);
  const auto error = [&](int n) {
    return distance(run(in_frame(model), GetParam().name, 1, n).motions, exact);
  };
  const int order = GetParam().order;
  if (order >= 6) {
    EXPECT_LT(error(512), 1e-9);
  } else {
    const int n = order == 4 ? 128 : order == 2 ? 1024 : 16384;
    EXPECT_NEAR(std::log2(error(n) / error(2 * n)), order, 0.1);
  }
}

CYLON_EVERY_SCHEME(Frame);

// Joints between free bodies do not know of the frame either.
TEST(Frame, JointsHoldInIt) {
  const Model model = linked_bodies(false);
  const auto exact = seen(run(model, "rk8", 1, 2000).motions, 1);
  const Outcome end = run(in_frame(model), "rk8", 1, 500);
  EXPECT_LT(distance(end.motions, exact), 1e-11);
  EXPECT_LT(joint_gap(end.motions, model.joints[0]), 1e-13);
}

// From rest in the frame: Coriolis and centrifugal acceleration,
//   a = -2 W x v - W x (W x r) + F/m,  by a Runge-Kutta of its own in the frame's velocities.
TEST(Frame, FeelsCoriolisAndCentrifugalForce) {
  const Vector3 g = {0.2, -9.81, 0.1}, pin = {0.3, 0.9, -0.2};
  const Real mass = 1.3, stiffness = 8;
  Vector3 r = {0.7, 0.2, -0.5}, v = {0.4, -0.3, 0.6};
  Model model;
  add_body(model, make_body(mass, Matrix3::Zero()), r, {0, 0, 0}, v + turning.cross(r), {0, 0, 0});
  model.frame = RotatingFrame{turning};
  model.forces.gravity = g;
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, pin, stiffness, 0, 0});
  const auto a = [&](const Vector3& x, const Vector3& u) -> Vector3 {
    return g - stiffness / mass * (x - pin) - 2 * turning.cross(u) - turning.cross(turning.cross(x));
  };
  const int n = 4000;
  const Real h = 2.0 / n;
  for (int i = 0; i < n; ++i) {
    const Vector3 v1 = v, a1 = a(r, v1), v2 = v + h / 2 * a1, a2 = a(r + h / 2 * v1, v2), v3 = v + h / 2 * a2,
                  a3 = a(r + h / 2 * v2, v3), v4 = v + h * a3, a4 = a(r + h * v3, v4);
    r += h / 6 * (v1 + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
  }
  const Outcome end = run(model, "rk8", 2, 400);
  EXPECT_LT((end.motions[0].position - r).norm(), 1e-11);
  EXPECT_LT((end.motions[0].momentum / mass - turning.cross(end.motions[0].position) - v).norm(), 1e-11);
}

// At rest in the frame where k (r - L) = m W^2 r: the spring is as long as the centrifugal force makes it.
TEST(Frame, ASpringAtRestCarriesTheCentrifugalForce) {
  const Real w = turning.norm(), mass = 1.3, stiffness = 8, rest = 0.6;
  const Vector3 out = turning.unitOrthogonal();
  const Real r = stiffness * rest / (stiffness - mass * w * w);
  Model model;
  add_body(model, make_body(mass, Matrix3::Zero()), r * out, {0, 0, 0}, turning.cross(r * out), {0, 0, 0});
  model.frame = RotatingFrame{turning};
  model.forces.springs.push_back({0, {0, 0, 0}, fixed_world, {0, 0, 0}, stiffness, rest, 0});
  const Outcome end = run(model, "rk8", 3, 300);
  EXPECT_LT((end.motions[0].position - r * out).norm(), 1e-12);
  model.forces.springs[0].rest_length = 0.5;  // negative control
  EXPECT_GT((run(model, "rk8", 3, 300).motions[0].position - r * out).norm(), 0.01);
}

// Galilei: isolated bodies with another speed are the same bodies elsewhere.
TEST(Boost, OnlyAddsUniformMotion) {
  const Vector3 u = {3, -2, 1};
  const Model model = coupled_bodies(0.4);
  Model boosted = model;
  for (std::size_t i = 0; i < 2; ++i) boosted.motions[i].momentum += model.bodies[i].mass * u;
  for (const Integrator& integrator : fixed_integrators()) {
    const Outcome a = run(model, integrator.name, 1, 400);
    Outcome b = run(boosted, integrator.name, 1, 400);
    for (std::size_t i = 0; i < 2; ++i) {
      b.motions[i].position -= u;
      b.motions[i].momentum -= model.bodies[i].mass * u;
    }
    // Integrators are covariant: only rounding of places some times as large, a few ulp a part
    EXPECT_LT(distance(a.motions, b.motions), 400 * integrator.evaluations * 8e-16) << integrator.name;
  }
}

TEST(Refused, ContactsInRotatingFrame) {
  Model model = ball_over_plane(0.5, 0.5);
  model.frame = RotatingFrame{turning};
  EXPECT_NE(unsupported(model, with("rk4", 0.01)).find("rotating frame"), std::string::npos);
}

}  // namespace
}  // namespace cylon::engine
