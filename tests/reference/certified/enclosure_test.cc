// The enclosure contains the solution, does not grow by itself, and excludes wrong solutions.
#include "reference/certified/flow.h"
#include "reference/certified/solve.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace cylon::certified {
namespace {

core::Body body(const std::string& name, const core::Vector3& position, const core::Vector3& velocity) {
  core::Body result;
  result.name = name;
  result.mass = 1.3;
  result.inertia = core::Vector3(0.21, 0.34, 0.41).asDiagonal();
  result.initial.position = position;
  result.initial.velocity = velocity;
  return result;
}

// Two bodies that tumble on a damped spring between points off their centres, one of them hung from the
// world.
core::Scene tumblers() {
  core::Scene scene;
  scene.bodies = {body("a", {0.3, -0.2, 0.5}, {0, 0, 0}), body("b", {1.4, 0.6, -0.3}, {0.2, -0.7, 0.4})};
  scene.bodies[0].initial.angular_velocity = {0.4, -1.1, 0.7};
  scene.bodies[1].initial.angular_velocity = {-0.9, 0.3, 1.6};
  scene.bodies[1].initial.orientation = core::Quaternion(0.8, 0.1, -0.5, 0.3).normalized();
  scene.forces.emplace_back(core::UniformGravity{{0.4, -9.7, 0.2}});
  scene.forces.emplace_back(core::Spring{0, {0.2, 0.1, -0.1}, 1, {-0.3, 0.2, 0.1}, 23.0, 0.7, 0.4});
  scene.forces.emplace_back(core::Drag{1, 0.1, 0.05, 0.02});
  scene.joints.push_back({core::JointType::ball, 0, core::world, {0.1, 0.3, 0.2}});
  return scene;
}

// A chain: a hinge to the world, a ball, and a rod of fixed length.
core::Scene chain() {
  core::Scene scene;
  const core::Vector3 still = core::Vector3::Zero();  // {} would be a vector of no set numbers
  scene.bodies = {body("a", {0.4, 0, 0.1}, still), body("b", {1.2, -0.1, 0.1}, still),
                  body("c", {1.9, 0.4, 0.3}, still)};
  scene.forces.emplace_back(core::UniformGravity{});
  scene.joints.push_back({core::JointType::hinge, 0, core::world, {0, 0, 0}, core::Vector3(0, 0.6, 0.8)});
  scene.joints.push_back({core::JointType::ball, 1, 0, {0.8, 0.1, 0}});
  scene.joints.push_back({core::JointType::distance,
                          2,
                          1,
                          {0, 0, 0},
                          core::Vector3::UnitY(),
                          (scene.bodies[2].initial.position - scene.bodies[1].initial.position).norm()});
  return scene;
}

// Four joints in a loop that leave it one freedom: 17 equations for three bodies.
core::Scene loop() {
  core::Scene scene;
  const core::Vector3 still = core::Vector3::Zero();
  scene.bodies = {body("a", {0.5, 0.1, 0.2}, still), body("b", {1.1, 0.4, 0.1}, still),
                  body("c", {1.5, 0.2, 0.6}, still)};
  scene.forces.emplace_back(core::UniformGravity{{0.7, -9.81, 1.3}});
  const auto join = [&](core::JointType type, int body, int to, const core::Vector3& point,
                        const core::Vector3& axis) {
    scene.joints.push_back({type, body, to, point, axis.normalized()});
  };
  join(core::JointType::hinge, 0, core::world, {0, 0, 0}, {0.2, 0.1, 1});
  join(core::JointType::planar, 1, 0, {0.8, 0.2, 0.1}, {0.3, 1, 0.2});
  scene.joints.back().axis_2 = core::Vector3(1, -0.3, 0).normalized();
  join(core::JointType::screw, 2, 1, {1.3, 0.3, 0.4}, {1, 0.2, -0.3});
  scene.joints.back().pitch = 0.1;
  join(core::JointType::universal, 2, core::world, {2, 0.1, 0.7}, {0.3, 1, 0});
  scene.joints.back().axis_2 = core::Vector3(1, -0.3, 0).normalized();
  return scene;
}

// A free body in a turning frame, driven and attracted.
core::Scene carousel() {
  core::Scene scene;
  scene.bodies = {body("a", {0.7, 0.2, -0.4}, {0.3, 0.1, -0.2}),
                  body("b", {-0.6, 0.4, 0.5}, {-0.1, 0.2, 0.3})};
  scene.bodies[0].initial.angular_velocity = {1.2, 0.3, -0.4};
  scene.forces.emplace_back(core::Attraction{0, 1, 0.3});
  scene.forces.emplace_back(core::Drive{0, {0.3, -0.2, 0.5}, 2.7});
  scene.forces.emplace_back(
      core::Thrust{1, {0.2, 0.1, -0.3}, 0.05, std::nullopt, core::Vector3(0.4, 0, 0.1)});
  scene.frame = core::Frame{{0.3, 0, 0}, {0.2, 0.5, -0.3}};
  return scene;
}

// States of all bodies at the end of [0, time].
std::vector<Ball> end_of(const core::Scene& scene, double time, const Effort& effort) {
  const Model model = make_model(scene, time, effort.bits);
  std::vector<Ball> result;
  follow(model, time, effort, [&](const Step& step) {
    if (step.start + step.length < time) return true;
    for (const BodyNodes& b : model.bodies) {
      for (const int node : b.position) result.push_back(step.at(node, time));
      for (const int node : b.velocity) result.push_back(step.at(node, time));
      for (const int node : b.orientation) result.push_back(step.at(node, time));
      for (const int node : b.angular_velocity) result.push_back(step.at(node, time));
    }
    return false;
  });
  return result;
}

// How many of `coarse` do not hold `fine`.
int missed(const std::vector<Ball>& coarse, const std::vector<Ball>& fine) {
  int count = 0;
  for (std::size_t i = 0; i < fine.size(); ++i) count += !arb_overlaps(coarse[i].get(), fine[i].get());
  return count;
}

double largest_radius(const std::vector<Ball>& balls) {
  double radius = 0;
  for (const Ball& x : balls) radius = std::max(radius, x.radius());
  return radius;
}

struct Case {
  const char* name;
  core::Scene (*scene)();
  double time;
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

class Enclosures : public testing::TestWithParam<Case> {};

constexpr Effort coarse{.step_error = 1e-12, .bits = 128}, fine{.step_error = 1e-34, .bits = 192};

// The fine enclosure is some 1e-30 wide: where it meets the coarse one, that one holds the solution to 1e-30.
TEST_P(Enclosures, ContainTheSolution) {
  const std::vector<Ball> truth = end_of(GetParam().scene(), GetParam().time, fine),
                          rough = end_of(GetParam().scene(), GetParam().time, coarse);
  EXPECT_LT(largest_radius(truth), 1e-27);
  EXPECT_LT(largest_radius(rough), 1e-5);  // some 1e6 times what a step leaves out
  EXPECT_EQ(missed(rough, truth), 0);
}

// Negative control: what the polynomials leave out, left out of the bound.
TEST_P(Enclosures, ExcludeSolutionWithoutRemainderTerm) {
  Effort blind = coarse;
  blind.remainder = false;
  const std::vector<Ball> truth = end_of(GetParam().scene(), GetParam().time, fine),
                          rough = end_of(GetParam().scene(), GetParam().time, blind);
  EXPECT_GT(missed(rough, truth), 10);
}

// Negative control: a mass that is off by 1e-9.
TEST_P(Enclosures, ExcludeSolutionOfOtherScene) {
  core::Scene other = GetParam().scene();
  other.bodies[0].mass *= 1 + 1e-9;
  const Effort middling{.step_error = 1e-20, .bits = 128};
  EXPECT_GT(
      missed(end_of(other, GetParam().time, middling), end_of(GetParam().scene(), GetParam().time, fine)),
      10);
}

// The state moves as its rate says: central differences of positions are the velocities, to h^2 times a third
// derivative of some hundreds.
TEST_P(Enclosures, KeepPositionAndVelocityCorrelated) {
  constexpr double h = 1e-6;
  const double t = GetParam().time;
  const Certificate found = certify(GetParam().scene(), std::vector<double>{t - h, t, t + h});
  for (std::size_t b = 0; b < found.samples[1].bodies.size(); ++b)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto at = [&](std::size_t k) { return found.samples[k].bodies[b].position[i].middle(); };
      EXPECT_NEAR((at(2) - at(0)) / (2 * h), found.samples[1].bodies[b].velocity[i].middle(), 2e-9);
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, Enclosures,
                         testing::Values(Case{"tumblers", tumblers, 1.5}, Case{"chain", chain, 0.2},
                                         Case{"carousel", carousel, 2.0}, Case{"loop", loop, 0.1}),
                         [](const auto& parameter) { return parameter.param.name; });

// Eliminated as they come, the equations of the loop multiply what a series leaves out a millionfold, and took 547 steps.
TEST(Enclosure, LoopTakesStepsOfItsMotion) {
  const Certificate found = certify(loop(), std::vector{0.25}, {.radius = 1e-10});
  EXPECT_TRUE(found.reached);
  EXPECT_LT(found.steps, 60);
}

// The energy of the loop, whose freedom it rules, stays: 1e-12 of 30 J.
TEST(Enclosure, LoopKeepsItsEnergy) {
  const core::Scene scene = loop();
  const Certificate found = certify(scene, std::vector{0.0, 0.4}, {.radius = 1e-10});
  const auto vector = [](const std::array<Ball, 3>& x) {
    return core::Vector3(x[0].middle(), x[1].middle(), x[2].middle());
  };
  const auto place = [&](const Sampled& sample, std::size_t i) { return vector(sample.bodies[i].position); };
  const auto energy = [&](const Sampled& sample) {
    double sum = 0;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const core::Body& b = scene.bodies[i];
      const auto& q = sample.bodies[i].orientation;
      const core::Quaternion turn(q[0].middle(), q[1].middle(), q[2].middle(), q[3].middle());
      const core::Vector3 v = vector(sample.bodies[i].velocity),
                          w = turn.conjugate() * vector(sample.bodies[i].angular_velocity);
      sum += b.mass * v.squaredNorm() / 2 + w.dot(b.inertia * w) / 2 -
             b.mass * core::Vector3(0.7, -9.81, 1.3).dot(place(sample, i));
    }
    return sum;
  };
  EXPECT_NEAR(energy(found.samples[1]), energy(found.samples[0]), 3e-11);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i)  // all of them move
    EXPECT_GT((place(found.samples[1], i) - place(found.samples[0], i)).norm(), 0.03);
}

// A thousand periods turn the set a thousand times; a box with fixed axes would grow by e^(2 pi) in each.
TEST(Enclosure, OscillatorHasNoWrappingEffect) {
  core::Scene scene;
  scene.bodies = {body("bob", {0.3, -0.8, 0.5}, {0.7, 0.2, -0.9})};
  constexpr double stiffness = 7.1;
  scene.forces.emplace_back(core::Spring{0, {0, 0, 0}, core::world, {0, 0, 0}, stiffness});
  const double time = 1000 * 2 * std::numbers::pi / std::sqrt(stiffness / scene.bodies[0].mass);
  const std::vector<Ball> end = end_of(scene, time, {.step_error = 1e-28, .bits = 160});
  EXPECT_LT(largest_radius(end), 1e-23);  // some thousand steps of 1e-28, none amplified

  constexpr slong bits = 256;  // p0 cos wt + v0/w sin wt
  Ball w(stiffness), c, s;
  arb_div(w.get(), w.get(), Ball(scene.bodies[0].mass).get(), bits);
  arb_sqrt(w.get(), w.get(), bits);
  arb_mul(c.get(), w.get(), Ball(time).get(), bits);
  arb_sin_cos(s.get(), c.get(), c.get(), bits);
  arb_div(s.get(), s.get(), w.get(), bits);
  for (std::size_t i = 0; i < 3; ++i) {
    const auto k = static_cast<Eigen::Index>(i);
    Ball exact, x(scene.bodies[0].initial.velocity[k]);
    arb_mul(exact.get(), c.get(), Ball(scene.bodies[0].initial.position[k]).get(), bits);
    arb_addmul(exact.get(), s.get(), x.get(), bits);
    EXPECT_TRUE(arb_contains(end[i].get(), exact.get())) << i;
  }
}

// Numbers of the scene that are known to a radius widen the result by what the motion makes of it, not less.
TEST(Enclosure, ContainsAllScenesWithinTheirRadii) {
  const double t[] = {1.0};
  const Certificate wide = certify(tumblers(), t, {}, [](double x) {
    Ball ball(x);
    if (x == 23.0) ball.widen(1e-9);
    return ball;
  });
  core::Scene other = tumblers();
  std::get<core::Spring>(other.forces[1]).stiffness += 0.9e-9;
  const Certificate inside = certify(other, t);
  EXPECT_FALSE(wide.reached);
  EXPECT_TRUE(inside.reached);
  EXPECT_TRUE(arb_contains(wide.samples[0].bodies[1].position[0].get(),
                           inside.samples[0].bodies[1].position[0].get()));
  std::get<core::Spring>(other.forces[1]).stiffness += 1e-4;  // negative control
  const Certificate outside = certify(other, t);
  EXPECT_FALSE(arb_overlaps(wide.samples[0].bodies[1].position[0].get(),
                            outside.samples[0].bodies[1].position[0].get()));
}

}  // namespace
}  // namespace cylon::certified
