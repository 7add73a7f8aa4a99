// What the joints of a double pendulum exert, from the certified motion, against the textbook's equations of motion.
#include "harness/core/joint_force.h"
#include "reference/certified/truth.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::certified {
namespace {

using core::Vector3;

// Two points on weightless rods.  With a, b the angles from the vertical (Landau & Lifshitz, Mechanics, section 5, problem 1):
//   (m + M) l a'' + M k (b'' cos(a - b) + b'^2 sin(a - b)) = -(m + M) g sin a
//   k b'' + l (a'' cos(a - b) - a'^2 sin(a - b)) = -g sin b
// and the joints exert m x'' + M y'' - (m + M) g and M y'' - M g.
TEST(JointForces, OfADoublePendulumAreThoseOfTheTextbook) {
  constexpr double m = 1.3, big = 0.8, l = 0.7, k = 0.5, g = 9.81, a0 = 2.1, b0 = -0.6;
  const auto rod = [](double angle, double length) {
    return Vector3(length * std::sin(angle), -length * std::cos(angle), 0);
  };
  core::Scene scene;
  scene.bodies.resize(2);
  scene.bodies[0].mass = m, scene.bodies[1].mass = big;
  for (core::Body& body : scene.bodies) body.inertia = Vector3::Constant(1e-2).asDiagonal();
  scene.bodies[0].initial.position = rod(a0, l), scene.bodies[1].initial.position = rod(a0, l) + rod(b0, k);
  scene.forces.emplace_back(core::UniformGravity{{0, -g, 0}});
  scene.joints = {{.type = core::JointType::distance, .body = 0, .to = core::world, .length = l},
                  {.type = core::JointType::distance, .body = 0, .to = 1, .length = k}};
  const Solution known = solution(scene, 1.0);
  const core::Truth& truth = known.truth;
  const auto instant = [&](double t, int joint) -> Vector3 {
    const core::State s = truth.state(t);
    const Vector3 x = s[0].position, d = s[1].position - x, v = s[0].velocity, u = s[1].velocity - v;
    const double a = std::atan2(x.x(), -x.y()), b = std::atan2(d.x(), -d.y());
    const double a1 = (x.x() * v.y() - x.y() * v.x()) / (l * l),
                 b1 = (d.x() * u.y() - d.y() * u.x()) / (k * k);
    const double c = std::cos(a - b), e = std::sin(a - b);
    Eigen::Matrix2d left;
    left << (m + big) * l, big * k * c, l * c, k;
    const Eigen::Vector2d right(-(m + big) * g * std::sin(a) - big * k * b1 * b1 * e,
                                -g * std::sin(b) + l * a1 * a1 * e);
    const Eigen::Vector2d second = left.inverse() * right;
    const auto pulled = [](double angle, double length, double rate, double spin_up) {
      return Vector3(length * (spin_up * std::cos(angle) - rate * rate * std::sin(angle)),
                     length * (spin_up * std::sin(angle) + rate * rate * std::cos(angle)), 0);
    };
    const Vector3 first = pulled(a, l, a1, second[0]), other = first + pulled(b, k, b1, second[1]),
                  up(0, g, 0);
    const Vector3 below = big * (other + up);
    return joint == 0 ? Vector3(m * (first + up) + below)
                      : Vector3(-below);  // the second names the upper one first
  };
  for (const double end : {0.3, 0.9})
    for (const int joint : {0, 1}) {
      const double h = 1e-3;
      const Vector3 mean =
          (instant(end - h, joint) + 4 * instant(end - h / 2, joint) + instant(end, joint)) / 6;
      const auto f = core::required_joint_forces({.quantity = core::Quantity::joint_force, .joint = joint},
                                                 scene, truth, end, h);
      const auto n = core::required_joint_forces({.quantity = core::Quantity::joint_torque, .joint = joint},
                                                 scene, truth, end, h);
      EXPECT_LT((f.values.at(0).head<3>() - mean).norm(), 1e-8 * mean.norm()) << end << ", joint " << joint;
      EXPECT_LT(f.error, 1e-6 * mean.norm());
      EXPECT_LT(n.values.at(0).norm(), 1e-8 * mean.norm()) << "a rod has no torque";
    }
}

}  // namespace
}  // namespace cylon::certified
