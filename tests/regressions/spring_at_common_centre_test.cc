// A spring that ends at the common centre of two bodies that are fixed to each other turns them by rounding
// alone.  The error-controlled integrator measured its error by that spin, found no step small enough, and
// every state was NaN.
#include "harness/process/client.h"
#include "tests/paths.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

core::Body part(std::string name, double share, double height) {
  core::Body body;
  body.name = std::move(name);
  body.mass = share;
  body.inertia = share * core::Vector3(0.8, 1, 0.8).asDiagonal().toDenseMatrix();
  body.initial.position = {0.1, height, -0.3};
  return body;
}

// m = 1, k = 10: the centre moves as x0 cos(sqrt(10) t), and nothing turns.
TEST(SpringAtCommonCentre, PullsWithoutTurning) {
  constexpr double stiffness = 10, duration = 2, centre = 0.56;
  core::Scene scene;
  scene.bodies = {part("a", 0.6, 0.2), part("b", 0.4, 1.1)};
  scene.joints = {{core::JointType::fixed, 0, 1, {0.1, 0.2, -0.3}}};
  core::Spring spring;
  spring.anchor = {0, centre - 0.2, 0}, spring.stiffness = stiffness;
  scene.forces = {spring};
  RunRequest request;
  request.scene = &scene;
  request.setup.dt = 0.125;
  request.steps = request.every = std::lround(duration / request.setup.dt);
  const RunOutcome outcome = run(parse_engine("in-house", default_engines(binary_dir)), request);
  ASSERT_TRUE(outcome.recording) << outcome.reason;
  const core::State& end = outcome.recording->states.back();
  const double factor = std::cos(std::sqrt(stiffness) * duration);
  const core::Vector3 start(0.1, centre, -0.3);
  const core::Vector3 common = 0.6 * end[0].position + 0.4 * end[1].position;
  EXPECT_LT((common - factor * start).norm(), 1e-9);
  EXPECT_LT(end[0].angular_velocity.norm(), 1e-12);
  EXPECT_LT(end[0].orientation.angularDistance(core::Quaternion::Identity()), 1e-12);
}

}  // namespace
}  // namespace cylon::process
