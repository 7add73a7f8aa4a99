// The numbers of Bullet, ODE, MuJoCo, Jolt and Rapier, digit by digit, against their published schemes written out here: what an
// adapter passes on wrongly shows at once, however small, and not only once it exceeds the engine's own error.
#include "tests/conformance/adapters_fixture.h"

#include <array>
#include <cmath>
#include <string_view>

namespace cylon::conformance {
namespace {

class Schemes : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, Schemes,
                         testing::ValuesIn(subjects_but({"in-house", "in-house-float", "simbody"})),
                         test_name);

// ---- Forces ---------------------------------------------------------------------------------------

struct Laws {
  Vector3 gravity{3.3, -8.1, 4.6}, drive{2.3, -1.1, 3.7}, pin{0.8, -1.4, 0.5};
  double stiffness = 17, rest = 0.4, damping = 1.9, drag = 0.7, frequency = 5.3, strength = 4.2;
};

// Bodies that do not turn: what pulls at them pulls at their centres.
core::Scene forced(const Laws& laws) {
  core::Scene scene = three_bodies(151);
  for (core::Body& body : scene.bodies) body.initial.angular_velocity.setZero();
  const Vector3 centre = Vector3::Zero();
  scene.forces = {core::UniformGravity{laws.gravity},
                  core::Spring{0, centre, 1, centre, laws.stiffness, laws.rest, laws.damping},
                  core::Spring{2, centre, core::world, laws.pin, laws.stiffness, laws.rest, laws.damping},
                  core::Drag{2, laws.drag, 0, 0},
                  core::Drive{1, laws.drive, laws.frequency},
                  core::Attraction{0, 2, laws.strength}};
  return scene;
}

// Equal parts of a step in which a state moves under the forces of its beginning.
int substeps(const Subject& subject) { return std::string_view(subject.id).starts_with("rapier") ? 4 : 1; }

// v' = v + dt F(x, v, t)/m,  x' = x + dt v';  in n substeps of dt/n with the force of the first.
core::State semi_implicit_euler(const core::Scene& scene, const Laws& laws, double dt, int steps,
                                int substeps) {
  core::State state = core::initial_state(scene);
  const auto mass = [&](std::size_t i) { return scene.bodies[i].mass; };
  for (int n = 0; n < steps; ++n) {
    std::array<Vector3, 3> force;
    for (std::size_t i = 0; i < 3; ++i) force[i] = mass(i) * laws.gravity;
    // k (|d| - L) + c d|d|/dt along d, from one end to the other
    const auto spring = [&](std::size_t i, const Vector3& end, const Vector3& end_velocity) -> Vector3 {
      const Vector3 d = end - state[i].position, along = d.normalized();
      const double rate = along.dot(end_velocity - state[i].velocity);
      return (laws.stiffness * (d.norm() - laws.rest) + laws.damping * rate) * along;
    };
    const Vector3 between = spring(0, state[1].position, state[1].velocity);
    force[0] += between, force[1] -= between;
    force[2] += spring(2, laws.pin, Vector3::Zero()) - laws.drag * state[2].velocity;
    force[1] += laws.drive * std::cos(laws.frequency * n * dt);
    const Vector3 d = state[2].position - state[0].position;
    const Vector3 attraction = laws.strength * mass(0) * mass(2) / std::pow(d.norm(), 3) * d;
    force[0] += attraction, force[2] -= attraction;
    for (std::size_t i = 0; i < 3; ++i) {
      for (int part = 0; part < substeps; ++part) {
        state[i].velocity += dt / substeps / mass(i) * force[i];
        state[i].position += dt / substeps * state[i].velocity;
      }
    }
  }
  return state;
}

TEST_P(Schemes, ForcesActAsSemiImplicitEulerSays) {
  constexpr double dt = 2e-3;
  constexpr int steps = 250;
  const Laws laws;
  const core::Scene scene = forced(laws);
  const core::State predicted = semi_implicit_euler(scene, laws, dt, steps, substeps(subject()));
  ASSERT_GT(difference(predicted, core::initial_state(scene)), 0.5) << "hardly a motion";
  // Rounding of a few units a step, of values up to ten, which springs and attraction amplify.
  expect_within(fmt::format("forces, {}", subject().id),
                difference(last(subject().choice(), scene, dt, steps), predicted),
                40.0 * steps * subject().unit());
}

// ---- Free rotation ------------------------------------------------------------------------------------

core::Matrix3 cross(const Vector3& v) {
  core::Matrix3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

// Angular velocity after a step, in the axes of I and w.
using Turn = Vector3 (*)(const core::Matrix3& inertia, const Vector3& w, double dt);

// One Newton step of I (w' - w) + dt w' x I w' = 0 from w' = w, of btRigidBody:
//   w' = w - (I + dt ([w] I - [I w]))^-1 dt w x I w.
Vector3 of_bullet(const core::Matrix3& inertia, const Vector3& w, double dt) {
  const core::Matrix3 jacobian = inertia + dt * (cross(w) * inertia - cross(inertia * w));
  return w - jacobian.inverse() * (dt * w.cross(inertia * w));
}

// I (w' - w) + dt w x I w = 0, of btMultiBody and of MuJoCo's Euler.
Vector3 of_multibody(const core::Matrix3& inertia, const Vector3& w, double dt) {
  return w - dt * inertia.inverse() * w.cross(inertia * w);
}

// I (w' - w) + dt w' x I w = 0, of ODE.
Vector3 of_ode(const core::Matrix3& inertia, const Vector3& w, double dt) {
  return (inertia - dt * cross(inertia * w)).inverse() * (inertia * w);
}

// L' = L - dt w x L, given the length of L: of Jolt, PhysX and crashcat, and of Rapier in each substep.
Vector3 of_jolt(const core::Matrix3& inertia, const Vector3& w, double dt) {
  const Vector3 before = inertia * w, after = before - dt * w.cross(before);
  return inertia.inverse() * (after * (before.norm() / after.norm()));
}

Turn turn_of(std::string_view id) {
  if (id == "jolt" || id.starts_with("rapier") || id == "physx" || id == "crashcat") return of_jolt;
  if (id.starts_with("bullet-multibody") || id.starts_with("mujoco")) return of_multibody;
  return id.starts_with("bullet") ? of_bullet : of_ode;
}

// Each step by its scheme with the inertia of the step's beginning, then q' = exp(w' dt) q, x' = x + v dt.
core::State rotated(const core::Scene& scene, Turn turn, double dt, int steps) {
  core::State state = core::initial_state(scene);
  for (int n = 0; n < steps; ++n)
    for (std::size_t i = 0; i < state.size(); ++i) {
      core::BodyState& s = state[i];
      s.angular_velocity = turn(core::world_inertia(scene.bodies[i], s.orientation), s.angular_velocity, dt);
      const double rate = s.angular_velocity.norm();
      s.orientation =
          (Quaternion(Eigen::AngleAxisd(rate * dt, s.angular_velocity / rate)) * s.orientation).normalized();
      s.position += dt * s.velocity;
    }
  return state;
}

TEST_P(Schemes, FreeBodiesTurnAsTheirGyroscopicTermSays) {
  constexpr double dt = 2e-3;
  constexpr int steps = 250;
  const core::Scene scene = three_bodies(152);
  const int parts = substeps(subject());
  const core::State predicted = rotated(scene, turn_of(subject().id), dt / parts, steps * parts);
  const core::State run = last(subject().choice(), scene, dt, steps);
  expect_within(fmt::format("free rotation, {}", subject().id), difference(run, predicted),
                20.0 * subject().drift * steps * subject().unit());
  // Another engine's scheme is another motion, so the test can tell them apart.
  for (const Turn other : {of_bullet, of_multibody, of_ode, of_jolt}) {
    if (other == turn_of(subject().id)) continue;
    EXPECT_GT(difference(run, rotated(scene, other, dt / parts, steps * parts)), 1e-4) << subject().id;
  }
}

}  // namespace
}  // namespace cylon::conformance
