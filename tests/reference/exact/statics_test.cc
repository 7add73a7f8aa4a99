// What hangs at rest stays there, each joint bears the weight below it, and what would not stay is refused.
#include "harness/core/joint_force.h"
#include "reference/exact/catalogue.h"
#include "tests/reference/exact/smooth_scenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

namespace cylon::exact {
namespace {

using core::JointType;
using core::Vector3;

core::Truth make(const core::Scene& scene, std::string_view name, double horizon = 2) {
  for (const Solution& solution : catalogue())
    if (solution.name == name) return solution.make(scene, horizon);
  throw std::runtime_error("no such solution");
}

std::string refusal(const core::Scene& scene) {
  try {
    make(scene, "statics");
  } catch (const core::OutOfDomain& why) {
    return why.what();
  }
  return "accepted";
}

core::Body body(double mass, const Vector3& position) {
  core::Body body;
  body.name = "of " + std::to_string(static_cast<int>(10 * mass));
  body.mass = mass, body.inertia = Vector3(0.03, 0.05, 0.04).asDiagonal();
  body.initial.position = position;
  return body;
}

// A bracket welded to the wall; from it hang a link on a ball joint and, on a hinge below that, a yoke with an arm welded to
// either side, which balance.  The world's y is up by default.
core::Scene mobile() {
  core::Scene s;
  s.bodies = {body(2, {0.4, 0.1, 0.25}), body(0.7, {0.75, -0.5, 0.5}), body(0.5, {0.75, -1, 0.5}),
              body(0.3, {0.25, -1.2, 0.5}), body(0.2, {1.5, -1.2, 0.5})};
  s.forces = {core::UniformGravity{{0, -9.81, 0}}};
  s.joints = {{JointType::fixed, 0, core::world, {0, 0, 0}},
              {JointType::ball, 0, 1, {0.75, 0, 0.5}},
              {JointType::hinge, 2, 1, {0.75, -0.75, 0.5}, {0.6, 0, 0.8}},
              {JointType::fixed, 3, 2, {0.5, -1, 0.5}},
              {JointType::fixed, 2, 4, {1, -1, 0.5}}};
  return s;
}

TEST(Statics, IsRest) {
  const core::Scene scene = mobile();
  const core::Truth truth = make(scene, "statics");
  for (const double t : {0.0, 1.3})
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const core::BodyState s = truth.state(t)[i];
      EXPECT_EQ(s.position, scene.bodies[i].initial.position);
      EXPECT_TRUE(s.velocity.isZero(0));
    }
  EXPECT_LT(truth.error.position, 1e-14);
  const double below[] = {3.7, -1.7, 1.0, 0.3, -0.2};  // on the body that the joint names first
  for (int j = 0; j < 5; ++j) {
    const core::Observable q{.quantity = core::Quantity::joint_force, .joint = j};
    const auto f = core::required_joint_forces(q, scene, truth, 2, 1e-3);
    EXPECT_NEAR(f.values.at(0).y(), below[j] * 9.81, 1e-12) << j;
    EXPECT_LT(f.error, 1e-9) << j;
  }
}

TEST(Statics, RefusesWhatWouldNotStay) {
  const struct {
    const char* name;
    std::function<void(core::Scene&)> change;
    const char* says;
  } rows[] = {
      {"as it is", [](core::Scene&) {}, "accepted"},
      {"turned upside down",
       [](core::Scene& s) { std::get<core::UniformGravity>(s.forces[0]).acceleration.y() = 9.81; },
       "does not hang straight below its joint"},
      {"an arm a little longer", [](core::Scene& s) { s.bodies[3].initial.position.x() -= 1e-6; },
       "what hangs with body 'of 5' does not hang straight"},
      {"a weld that carries anything", [](core::Scene& s) { s.bodies[0].initial.position.x() -= 0.1; },
       "accepted"},
      {"the first link stands, what hangs on it pulls it down past the joint",
       [](core::Scene& s) { s.bodies[1].initial.position.y() = 3, s.joints[2].point.y() = 0.75; },
       "what hangs with body 'of 7' does not hang straight"},
      {"the middle of a part on its joint",
       [](core::Scene& s) {
         s.bodies.resize(2), s.joints.resize(2);
         s.bodies[1].initial.position = s.joints[1].point;
       },
       "accepted"},
      {"a body that moves", [](core::Scene& s) { s.bodies[4].initial.velocity.z() = 0.1; },
       "does not start at rest"},
      {"a body that turns", [](core::Scene& s) { s.bodies[1].initial.angular_velocity.y() = 0.1; },
       "does not start at rest"},
      {"a slider", [](core::Scene& s) { s.joints[2].type = JointType::slider; }, "is of kind slider"},
      {"a loop",
       [](core::Scene& s) {
         s.joints.push_back({JointType::ball, 4, core::world, {1.5, -2, 0.5}});
       },
       "close a loop"},
      {"a body that falls", [](core::Scene& s) { s.joints.erase(s.joints.begin() + 3); },
       "body 'of 3' does not hang from the world"},
      {"a spring", [](core::Scene& s) { s.forces.emplace_back(core::Spring{}); },
       "a force that it does not know"},
      {"its own gravity", [](core::Scene& s) { s.bodies[1].gravity = Vector3(0, -1.6, 0); }, "gravity"},
      {"a motor", [](core::Scene& s) { s.joints[2].angles.emplace_back().force = 1; },
       "something acts along the joint"},
      {"bodies that may touch",
       [](core::Scene& s) {
         for (core::Body& b : s.bodies) b.shape = core::Sphere{0.1}, b.collide = true;
       },
       "may touch"},
      {"a locked body", [](core::Scene& s) { s.bodies[0].locked = true; }, "is locked"},
  };
  for (const auto& row : rows) {
    core::Scene scene = mobile();
    row.change(scene);
    EXPECT_NE(refusal(scene).find(row.says), std::string::npos) << row.name << ": " << refusal(scene);
  }
}

// Off by what rounding leaves, the part swings by that angle; the bound says so.
TEST(Statics, BoundsWhatRoundingLeaves) {
  core::Scene scene = mobile();
  scene.bodies[3].initial.position.x() -= 0x1p-51;
  const core::StateError error = make(scene, "statics").error;
  EXPECT_GT(error.orientation, 1e-17);
  EXPECT_LT(error.orientation, 1e-14);
  EXPECT_GT(error.velocity, 0);
  EXPECT_GT(error.angular_velocity, 0);
}

// ---- The joints of moving bodies -----------------------------------------------------------------------

// A pendulum of any shape on a hinge in a general place: along the arm m l w^2 and the weight's part, across it
// m l w' and the weight's part,  w' = -(m g l/J) sin a;  about the axis no torque.  Newton's second law by hand.
TEST(JointForces, OfPendulumsAreThoseOfTheTextbook) {
  for (const unsigned seed : {3U, 4U, 5U}) {
    const core::Scene scene = SmoothScenes(seed).scene("physical_pendulum");
    const core::Truth truth = make(scene, "physical_pendulum", 3);
    for (std::size_t j = 0; j < scene.joints.size(); ++j) {
      const core::Joint& joint = scene.joints[j];
      const auto i = static_cast<std::size_t>(joint.body);
      const core::Body& b = scene.bodies[i];
      const Vector3 n = joint.axis.normalized(), g = core::gravity_of(scene, b);
      const auto instant = [&](double t) -> Vector3 {
        const core::BodyState s = truth.state(t)[i];
        const Vector3 arm = s.position - joint.point, w = s.angular_velocity;
        const Vector3 across = arm - n.dot(arm) * n;
        const double moment =
            n.dot(core::world_inertia(b, s.orientation) * n) + b.mass * across.squaredNorm();
        const Vector3 spin_up = b.mass * arm.cross(g).dot(n) / moment * n;
        return b.mass * (spin_up.cross(arm) + w.cross(w.cross(arm)) - g);
      };
      const double end = 2.3, h = 1e-3;
      const Vector3 mean = (instant(end - h) + 4 * instant(end - h / 2) + instant(end)) / 6;  // O(h^4)
      const int which = static_cast<int>(j);
      const auto f = core::required_joint_forces({.quantity = core::Quantity::joint_force, .joint = which},
                                                 scene, truth, end, h);
      const auto m = core::required_joint_forces({.quantity = core::Quantity::joint_torque, .joint = which},
                                                 scene, truth, end, h);
      EXPECT_LT((f.values.at(0).head<3>() - mean).norm(), 1e-9 * mean.norm()) << seed << ", " << j;
      EXPECT_LT(std::abs(m.values.at(0).head<3>().dot(n)), 1e-9 * (1 + m.values.at(0).norm()))
          << "a hinge turns freely";
      EXPECT_LT(f.error, 1e-6 * mean.norm());
    }
  }
}

}  // namespace
}  // namespace cylon::exact
