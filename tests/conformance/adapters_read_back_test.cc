// Most cross-engine errors are set-up errors: every adapter gives back the very state that it was given.
#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {
namespace {

class ReadBack : public EveryEngine {};
INSTANTIATE_TEST_SUITE_P(Adapters, ReadBack, testing::ValuesIn(subjects), test_name);
INSTANTIATE_TEST_SUITE_P(Dart, ReadBack, testing::Values(dart), test_name);

// Position, velocity and angular velocity relative to their own size, orientation absolutely, of the worst
// body.
double start_error(const Subject& subject, const core::Scene& scene) {
  const core::State start = play(subject.choice(), scene, 1e-3, 0).states.front();
  double worst = 0;
  const auto relative = [](const Vector3& got, const Vector3& asked) {
    return asked.isZero(0) ? got.norm() : (got - asked).norm() / asked.norm();
  };
  for (std::size_t i = 0; i < start.size(); ++i) {
    const core::BodyState &got = start[i], &asked = scene.bodies[i].initial;
    const double sign = got.orientation.dot(asked.orientation) < 0 ? -1 : 1;
    worst = std::max({worst, relative(got.position, asked.position), relative(got.velocity, asked.velocity),
                      relative(got.angular_velocity, asked.angular_velocity),
                      (got.orientation.coeffs() - sign * asked.orientation.coeffs()).norm()});
  }
  return worst;
}

// Rounding on the way in and out: momenta, matrices and principal axes there and back.
TEST_P(ReadBack, FreeBodiesWithFullInertia) {
  double worst = 0;
  for (unsigned seed = 1; seed <= 8; ++seed)
    worst = std::max(worst, start_error(subject(), three_bodies(seed)));
  expect_within(fmt::format("read back, {}", subject().id), worst, subject().start_units * subject().unit());
}

TEST_P(ReadBack, SizesFarFromOne) {
  core::Scene scene = three_bodies(9);
  scene.bodies[0].mass = 3e-4, scene.bodies[0].inertia *= 2e-9;
  scene.bodies[1].mass = 7e3, scene.bodies[1].inertia *= 4e5;
  scene.bodies[2].initial.position *= 1e4;
  scene.bodies[2].initial.velocity *= 1e3;
  expect_within(fmt::format("read back of small and large, {}", subject().id), start_error(subject(), scene),
                subject().start_units * subject().unit());
}

// A locked body stands where it stands, turned as it is.
TEST_P(ReadBack, LockedBodies) {
  core::Scene scene = three_bodies(10);
  scene.bodies[1].locked = true;
  scene.bodies[1].initial.velocity = scene.bodies[1].initial.angular_velocity = Vector3::Zero();
  expect_within(fmt::format("read back with a locked body, {}", subject().id), start_error(subject(), scene),
                subject().start_units * subject().unit());
}

// Reduced coordinates compute position and velocity from the joint's: 32 units of the arm's length and speed.
TEST_P(ReadBack, BodiesOnJoints) {
  double worst = 0;
  for (unsigned seed = 11; seed <= 14; ++seed)
    worst = std::max(worst, start_error(subject(), exact::RandomScenes(seed).heavy_top()));
  expect_within(fmt::format("read back on a joint, {}", subject().id), worst, 32 * subject().unit());
}

// Colliding bodies get a shape, turned into the engine's own axes; the state must not notice.
TEST_P(ReadBack, CollidingBodies) {
  if (!subject().touches) GTEST_SKIP() << "it has no contacts that a scene could state";
  core::Scene scene = three_bodies(15);
  for (core::Body& body : scene.bodies) body.shape = core::Sphere{0.05}, body.collide = true;
  scene.planes = {{"floor", Vector3(1, 2, -3).normalized(), -100}};
  scene.materials = {{{"*", "*"}, pair_restitution(), 0}};
  expect_within(fmt::format("read back of colliding bodies, {}", subject().id), start_error(subject(), scene),
                subject().start_units * subject().unit());
}

}  // namespace
}  // namespace cylon::conformance
