// The heavy top where Euler's angles fail: vertical, through the vertical, past it, and as a plane pendulum.
#include "reference/exact/solutions.h"
#include "tests/reference/exact/newton_euler.h"
#include "tests/reference/exact/random_scenes.h"
#include "tests/reference/exact/reference_file.h"

#include <gtest/gtest.h>

namespace cylon::exact {
namespace {

struct Start {
  double tilt;  // angle of the axis from the upward vertical [rad]
  double spin;  // about the axis [rad/s]
  core::Vector3
      across;  // of the axis' motion, w = spin d + across [rad/s]; x turns the axis away from the vertical
};

// Vertical along y, the axis tilted about x; turned as a whole by `frame`, a quarter turn keeps every zero
// exact.
core::Scene top(const Start& start, const core::Quaternion& frame) {
  core::Scene scene;
  core::Body b;
  b.name = "top";
  b.mass = 1.5;
  b.inertia = core::Vector3(0.005, 0.008, 0.005).asDiagonal();
  const core::Quaternion tilt(Eigen::AngleAxisd(start.tilt, core::Vector3::UnitX()));
  const core::Vector3 d = tilt * core::Vector3::UnitY();
  b.initial.orientation = frame * tilt;
  b.initial.position = frame * core::Vector3(0.1 * d);
  b.initial.angular_velocity = frame * core::Vector3(start.spin * d + start.across);
  b.initial.velocity = b.initial.angular_velocity.cross(b.initial.position);
  scene.bodies.push_back(b);
  scene.joints.emplace_back();
  scene.forces.emplace_back(core::UniformGravity{frame * core::Vector3(0, -9.81, 0)});
  return scene;
}

void expect_integration_agrees(const core::Scene& scene, double horizon) {
  const core::Truth truth = heavy_top(scene, horizon);
  NewtonEuler integration(scene, 0);
  for (int k = 0; k <= 40; ++k) {
    SCOPED_TRACE(k);
    const double t = horizon * k / 40;
    const core::BodyState a = truth.state(t)[0], b = integration.at(t, 0.004L);
    EXPECT_LE((a.position - b.position).norm(), truth.error.position + 1e-15);
    EXPECT_LE((a.velocity - b.velocity).norm(), truth.error.velocity + 1e-14);
    EXPECT_LE(angle_between(a.orientation, b.orientation), truth.error.orientation + 1e-14);
    EXPECT_LE((a.angular_velocity - b.angular_velocity).norm(), truth.error.angular_velocity + 1e-13);
  }
}

constexpr double pi = 3.14159265358979323846;

class HeavyTopPoles : public testing::TestWithParam<std::pair<const char*, Start>> {};

TEST_P(HeavyTopPoles, integration_agrees) {
  const Start& start = GetParam().second;
  expect_integration_agrees(top(start, core::Quaternion::Identity()), 2);
  expect_integration_agrees(top(start, core::Quaternion(0.5, 0.5, 0.5, 0.5)), 2);  // y to z, exactly
  expect_integration_agrees(top(start, RandomScenes(7).rotation()), 2);            // the pole up to rounding
}

using P = std::pair<const char*, Start>;
INSTANTIATE_TEST_SUITE_P(all, HeavyTopPoles,
                         testing::Values(P{"starts_upright_and_leaves", {0, 9, {3, 0, 0.7}}},
                                         P{"starts_upright_without_spin", {0, 0, {2, 0, 0}}},
                                         P{"starts_hanging_and_leaves", {pi, 9, {3, 0, 0.7}}},
                                         P{"through_upright", {1, 0, {-20, 0, 0}}},
                                         P{"plane_pendulum", {2.2, 0, {0.3, 0, 0}}},
                                         P{"plane_pendulum_from_rest", {0.8, 0, {0, 0, 0}}},
                                         P{"whirling_pendulum", {0.5, 0, {25, 0, 0}}},
                                         P{"past_upright", {0.3, 20, {-4, 1e-4, 2e-4}}},
                                         P{"just_past_upright", {0.3, 0, {-14, 0, 1e-9}}},
                                         P{"just_past_hanging", {2.5, 0, {1, 0, 1e-10}}},
                                         P{"nearly_upright_at_start", {1e-9, 30, {2, 0, 1}}},
                                         P{"nearly_sleeping", {1e-7, 60, {0, 0, 0}}},
                                         P{"horizontal_steady_start", {pi / 2, 50, {0, 1.47, 0}}}),
                         [](const auto& p) { return std::string(p.param.first); });

// Exactly vertical it stays vertical for ever, stable or not, and turns by w t.
TEST(HeavyTopPoles, sleeping_exactly_upright_or_hanging) {
  for (double tilt : {0.0, pi}) {
    core::Scene scene = top({0, 3, {0, 0, 0}}, core::Quaternion::Identity());
    if (tilt > 0) {
      core::Body& body = scene.bodies[0];
      body.initial.orientation = core::Quaternion(0, 1, 0, 0);
      body.initial.position = {0, -0.1, 0};
    }
    const core::Truth truth = heavy_top(scene, 10);
    const core::BodyState start = scene.bodies[0].initial, end = truth.state(10)[0];
    const core::Quaternion turned(Eigen::AngleAxisd(30, core::Vector3::UnitY()));
    EXPECT_LE((end.position - start.position).norm(), 1e-19);
    EXPECT_LE(end.velocity.norm(), 1e-18);
    EXPECT_LE((end.angular_velocity - start.angular_velocity).norm(), 1e-15);
    EXPECT_LE(angle_between(end.orientation, turned * start.orientation), 1e-14);
  }
}

// Replacing I3 at equal I3 w3 keeps the path of the axis; only the spin changes, by (w3' - w3) t.
TEST(HeavyTopPoles, path_of_the_axis_depends_on_axial_momentum_alone) {
  core::Scene one = top({0.7, 20, {1, 0, 2}}, core::Quaternion::Identity()), other = one;
  other.bodies[0].inertia(1, 1) *= 0.5;
  const core::Vector3 d = one.bodies[0].initial.position / 0.1;
  other.bodies[0].initial.angular_velocity += one.bodies[0].initial.angular_velocity.dot(d) * d;
  const core::Truth a = heavy_top(one, 5), b = heavy_top(other, 5);
  for (double t : {0.6, 2.5, 5.0}) {
    const core::BodyState x = a.state(t)[0], y = b.state(t)[0];
    EXPECT_LE((x.position - y.position).norm(), a.error.position + b.error.position);
    const double more = one.bodies[0].initial.angular_velocity.dot(d) * t;
    const core::Quaternion spun =
        x.orientation * core::Quaternion(Eigen::AngleAxisd(more, core::Vector3::UnitY()));
    EXPECT_LE(angle_between(spun, y.orientation), a.error.orientation + b.error.orientation);
  }
}

}  // namespace
}  // namespace cylon::exact
