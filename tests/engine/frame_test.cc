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

// The motion of a model as the frame sees it, its own motion a force.
Model with_force(Model model, const FrameForce& frame) {
  for (std::size_t i = 0; i < model.bodies.size(); ++i) {
    const Body& body = model.bodies[i];
    const Motion& m = model.motions[i];
    model.motions[i] = make_motion(body, m.position, m.orientation,
                                   velocity(body, m) - frame.angular_velocity.cross(m.position),
                                   angular_velocity(body, m) - frame.angular_velocity);
  }
  model.forces.frame_forces = {frame};
  return model;
}

// Places and turns of two motions, momenta aside.
Real apart(const std::vector<Motion>& a, const std::vector<Motion>& b) {
  Real most = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    most = std::max(
        {most, (a[i].position - b[i].position).norm(), a[i].orientation.angularDistance(b[i].orientation)});
  return most;
}

// An inertial motion, seen from a frame that turns about W by  W t + W' t^2/2,  W' along W.
std::vector<Motion> seen_turned(std::vector<Motion> motions, const Vector3& by) {
  const Quaternion back = exponential(-by);
  for (Motion& m : motions) m.position = back * m.position, m.orientation = back * m.orientation;
  return motions;
}

// The same motions, whether the frame is a force or is turned back; in a frame that turns ever faster, too.
TEST_P(Frame, AsAForceItIsTheSameMotion) {
  for (const Real faster : {Real(0), Real(0.6)}) {
    const Model model = coupled_bodies(0.3);
    FrameForce frame;
    frame.angular_velocity = turning, frame.angular_acceleration = faster * turning;
    const auto exact = seen_turned(run(model, "rk8", 1, 2000).motions, (1 + faster / 2) * turning);
    const auto error = [&](int n) {
      return apart(run(with_force(model, frame), GetParam().name, 1, n).motions, exact);
    };
    const int order = GetParam().order;
    if (order >= 6) {
      EXPECT_LT(error(512), 1e-9);
    } else {
      const int n = order == 4 ? 128 : order == 2 ? 1024 : 16384;
      EXPECT_NEAR(std::log2(error(n) / error(2 * n)), order, 0.1) << faster;
    }
    frame.angular_velocity *= 1.01;  // negative control
    EXPECT_GT(apart(run(with_force(model, frame), "rk8", 1, 200).motions, exact), 1e-4);
  }
}

// At rest in a frame that accelerates evenly where the weight and the frame's pull are in line with the rod: pinned
// (in reduced coordinates) or held by a constraint; tan phi = a/g.
TEST(Frame, APendulumHangsAskewInOneThatAccelerates) {
  const Real g = 9.81, a = 2.5, length = 0.8;
  const Vector3 along = Vector3(-a, -g, 0).normalized();
  for (const bool reduced : {true, false}) {
    Model model;
    add_body(model, make_body(1.3, Vector3(0.2, 0.3, 0.4).asDiagonal()), length * along, {0, 0, 0}, {0, 0, 0},
             {0, 0, 0});
    model.reduce_joints = reduced;
    model.forces.gravity = {0, -g, 0};
    model.joints.push_back({.anchor = -length * along});
    FrameForce frame;
    frame.acceleration = {a, 0, 0};
    model.forces.frame_forces = {frame};
    EXPECT_LT((run(model, "rk8", 2, 400).motions[0].position - length * along).norm(), 1e-12) << reduced;
    model.forces.frame_forces[0].acceleration *= 1.1;  // negative control
    EXPECT_GT((run(model, "rk8", 2, 400).motions[0].position - length * along).norm(), 1e-3) << reduced;
  }
}

// A conical pendulum at rest in the frame that turns with it:  cos phi = g/(W^2 l)  of a point on a rod; of a body, whose
// moments about the vertical the frame twists:  (I_3 - I_1 - m l^2) W^2 cos phi = -m g l.
TEST(Frame, AConicalPendulumRestsInTheFrameThatTurnsWithIt) {
  const Real g = 9.81, w = 4.5, length = 0.8, mass = 1.3, across = 0.05, along_rod = 0.01;
  const Real cosine = mass * g * length / ((mass * length * length + across - along_rod) * w * w);
  const Real sine = std::sqrt(1 - cosine * cosine);
  const Quaternion turned = exponential(std::atan2(sine, cosine) * Vector3::UnitZ());
  for (const bool reduced : {true, false}) {
    Model model;
    add_body(model, make_body(mass, Vector3(across, along_rod, across).asDiagonal()),
             turned * Vector3(0, -length, 0), {0, 0, 0}, {0, 0, 0}, {0, 0, 0});
    model.motions[0].orientation = turned;
    model.reduce_joints = reduced;
    model.forces.gravity = {0, -g, 0};
    model.joints.push_back({.anchor = {0, length, 0}});
    FrameForce frame;
    frame.angular_velocity = {0, w, 0};
    model.forces.frame_forces = {frame};
    const Vector3 at = model.motions[0].position;
    EXPECT_LT((run(model, "rk8", 1, 400).motions[0].position - at).norm(), 1e-11) << reduced;
    model.forces.frame_forces[0].angular_velocity *= 1.01;  // negative control
    EXPECT_GT((run(model, "rk8", 1, 400).motions[0].position - at).norm(), 1e-3) << reduced;
  }
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
