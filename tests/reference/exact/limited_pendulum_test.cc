// A pendulum between two stops is that of small steps of another method, keeps its energy between stops, turns its rate
// round at them, and is refused where that is not the whole motion.
#include "tests/reference/exact/smooth_scenes.h"

#include "harness/core/joint_coordinates.h"
#include "reference/exact/catalogue.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

namespace cylon::exact {
namespace {

constexpr double horizon = 4;

core::Truth make(const core::Scene& scene, std::string_view name = "limited_pendulum") {
  for (const Solution& solution : catalogue())
    if (solution.name == name) return solution.make(scene, horizon);
  throw std::runtime_error("no such solution");
}

// Two pendulums, the first slow and the second fast; the stops are asymmetric.
core::Scene pendulums(unsigned seed, double restitution) {
  RandomScenes random(seed);
  core::Scene s = SmoothScenes(seed).scene("physical_pendulum");
  std::get<core::UniformGravity>(s.forces[0]).acceleration *= 2;
  for (core::Joint& joint : s.joints) {
    core::JointAngle law;
    // From the lowest position by arms in the plane across the axis.
    const core::Body& body = s.bodies[static_cast<std::size_t>(joint.body)];
    const auto across = [&](const core::Vector3& v) -> core::Vector3 {
      return (v - joint.axis.dot(v) * joint.axis).normalized();
    };
    const core::Vector3 down = across(core::gravity(s)), arm = across(body.initial.position - joint.point);
    const double here = std::atan2(joint.axis.dot(down.cross(arm)), down.dot(arm));
    law.start = random.between(-1, 1);
    law.lower = law.start + std::max(-random.between(0.3, 1.2), -3.1 - here);
    law.upper = law.start + std::min(random.between(0.3, 1.2), 3.1 - here);
    law.restitution = restitution;
    joint.angles.push_back(law);
  }
  return s;
}

double angle(const core::Scene& scene, const core::Joint& joint, const core::State& state) {
  return joint.angles[0].start +
         core::joint_angle(core::held_joint(scene, joint), core::Ordinal::first, state);
}

// J a'' = axis.(arm x m g) by the classical Runge-Kutta scheme, from the definition of the torque.
class BySteps {
 public:
  BySteps(const core::Scene& scene, const core::Joint& joint) : joint_(joint), law_(joint.angles[0]) {
    const core::Body& body = scene.bodies[static_cast<std::size_t>(joint.body)];
    arm_ = body.initial.position - joint.point;
    weight_ = body.mass * core::gravity(scene);
    inertia_ = joint.axis.dot(core::world_inertia(body, body.initial.orientation) * joint.axis) +
               body.mass * joint.axis.cross(arm_).squaredNorm();
    a = law_.start, w = joint.axis.dot(body.initial.angular_velocity);
  }

  double a, w;
  int strikes = 0;

  void go(double h) {
    while (h > 0) {
      const auto [end, rate] = after(h);
      if (held_ || !over(end, rate)) {
        if (!held_) a = end, w = rate;
        return;
      }
      double early = 0, late = h;
      for (int i = 0; i < 60; ++i) {
        const double middle = (early + late) / 2;
        const auto [x, u] = after(middle);
        (over(x, u) ? late : early) = middle;
      }
      std::tie(a, w) = after(late);
      h -= late;
      ++strikes;
      const bool upper = w > 0;
      w *= -law_.restitution;
      held_ = w == 0 && (upper ? pull(a) > 0 : pull(a) < 0);
    }
  }

 private:
  double pull(double x) const {
    const core::Vector3 arm = Eigen::AngleAxisd(x - law_.start, joint_.axis) * arm_;
    return joint_.axis.dot(arm.cross(weight_)) / inertia_;
  }
  std::pair<double, double> after(double h) const {
    const double a1 = pull(a), w2 = w + h / 2 * a1, a2 = pull(a + h / 2 * w), w3 = w + h / 2 * a2,
                 a3 = pull(a + h / 2 * w2), w4 = w + h * a3, a4 = pull(a + h * w3);
    return {a + h / 6 * (w + 2 * w2 + 2 * w3 + w4), w + h / 6 * (a1 + 2 * a2 + 2 * a3 + a4)};
  }
  bool over(double x, double u) const { return (x > *law_.upper && u > 0) || (x < *law_.lower && u < 0); }

  const core::Joint& joint_;
  const core::JointAngle& law_;
  core::Vector3 arm_, weight_;
  double inertia_ = 0;
  bool held_ = false;
};

class LimitedPendulum : public testing::TestWithParam<double> {};

TEST_P(LimitedPendulum, MovesAsBySmallSteps) {
  int strikes = 0;
  for (unsigned seed = 1; seed <= 6; ++seed) {
    SCOPED_TRACE(seed);
    const core::Scene scene = pendulums(seed, GetParam());
    const core::Truth truth = make(scene);
    EXPECT_LE(truth.error.position, 1e-9);
    EXPECT_LE(truth.error.velocity, 1e-8);
    for (const core::Joint& joint : scene.joints) {
      BySteps steps(scene, joint);
      for (int i = 1; i <= 40; ++i) {
        for (int k = 0; k < 400; ++k) steps.go(horizon / 40 / 400);
        const core::State state = truth.state(i * horizon / 40);
        ASSERT_NEAR(std::remainder(angle(scene, joint, state) - steps.a, 2 * std::numbers::pi), 0, 1e-8)
            << "at " << i * horizon / 40;
        EXPECT_LE(core::open_by(scene, joint, state), 1e-12);
      }
      strikes += steps.strikes;
    }
  }
  EXPECT_GT(strikes, 6);
}
INSTANTIATE_TEST_SUITE_P(Restitutions, LimitedPendulum, testing::Values(1.0, 0.9, 0.0));

// Negative control, and the sense of the stops: without reaching them it is the free pendulum, and else it is not.
TEST(LimitedPendulum, IsFreeBetweenWideStops) {
  core::Scene scene = pendulums(3, 0.8);
  scene.bodies.resize(1), scene.joints.resize(1);
  core::Scene free = scene;
  free.joints[0].angles.clear();
  const core::Truth limited = make(scene), swings = make(free, "physical_pendulum");
  double here = scene.joints[0].angles[0].start, least = here, most = here, apart = 0;
  for (int i = 0; i <= 400; ++i) {
    const core::State state = swings.state(horizon * i / 400);
    here += std::remainder(angle(scene, scene.joints[0], state) - here, 2 * std::numbers::pi);
    least = std::min(least, here), most = std::max(most, here);
    apart = std::max(apart, (state[0].position - limited.state(horizon * i / 400)[0].position).norm());
  }
  EXPECT_GT(apart, 0.01);
  scene.joints[0].angles[0].lower = least - 0.01, scene.joints[0].angles[0].upper = most + 0.01;
  const core::Truth wide = make(scene);
  for (int i = 0; i <= 400; ++i)
    EXPECT_LE(
        (swings.state(horizon * i / 400)[0].position - wide.state(horizon * i / 400)[0].position).norm(),
        1e-12);
}

TEST(LimitedPendulum, RefusesWithTheReason) {
  using S = core::Scene;
  const std::pair<void (*)(S&), const char*> rows[] = {
      {[](S& s) { s.joints[0].angles.clear(); }, "has not two stops"},
      {[](S& s) { s.joints[0].angles[0].upper.reset(); }, "has not two stops"},
      {[](S& s) { s.joints[0].angles[0].damping = 0.1; }, "something acts along the hinge"},
      {[](S& s) { s.joints[0].angles[0].friction = 0.1; }, "something acts along the hinge"},
      {[](S& s) { s.joints[0].angles[0].upper = s.joints[0].angles[0].start + 7; }, "within half a turn"},
      {[](S& s) { s.joints[0].angles[0].upper = s.joints[0].angles[0].start; }, "starts at a stop"},
      {[](S& s) { s.forces.clear(); }, "is no pendulum"},
      {[](S& s) { s.joints[0].type = core::JointType::cylindrical; }, "is not a hinge"},
      {[](S& s) { s.joints.erase(s.joints.begin()); }, "must have exactly one joint"},
  };
  for (const auto& [change, reason] : rows) {
    core::Scene scene = pendulums(3, 0.8);
    change(scene);
    try {
      make(scene);
      ADD_FAILURE() << reason;
    } catch (const core::OutOfDomain& refusal) {
      EXPECT_NE(std::string(refusal.what()).find(reason), std::string::npos) << refusal.what();
    }
  }
}

}  // namespace
}  // namespace cylon::exact
