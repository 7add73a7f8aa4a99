// MuJoCo's integrators: Runge-Kutta 4 of order 4 where nothing turns, or turns about a fixed axis, and of order 2 where
// a body turns freely; Euler and the implicit scheme of order 1.  What a run says of its order is what it shows.
#include "reference/certified/truth.h"
#include "reference/exact/solutions.h"
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <functional>

namespace cylon::conformance {
namespace {

class Mujoco : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto reason = process::missing(engine("").row)) GTEST_SKIP() << *reason;
  }
  static process::EngineChoice engine(const std::string& variant) {
    return process::parse_engine("mujoco" + variant, process::default_engines(binary_dir));
  }
};

// A scene, how long, and its exact end.
struct Motion {
  const char* name;
  core::Scene scene;
  double duration;
  core::State end;
  int order;  // of Runge-Kutta 4
};

core::Scene top() {
  core::Scene scene = exact::RandomScenes(22).scene("free_asymmetric_top");
  scene.forces.clear();
  return scene;
}

// Springs between centres, to a pin, drag, a drive and attraction, on bodies that do not turn.
core::Scene pulled() {
  core::Scene scene = three_bodies(151);
  for (core::Body& body : scene.bodies) body.initial.angular_velocity.setZero();
  scene.forces = {core::UniformGravity{{3.3, -8.1, 4.6}},
                  core::Spring{0, Vector3::Zero(), 1, Vector3::Zero(), 17, 0.4, 1.9},
                  core::Spring{2, Vector3::Zero(), core::world, {0.8, -1.4, 0.5}, 17, 0.4, 1.9},
                  core::Drag{2, 0.7, 0, 0}, core::Attraction{0, 2, 4.2}};
  return scene;
}

// A body on a hinge, turned and off its axis.
core::Scene swing(core::JointType type) {
  core::Scene scene = three_bodies(65);
  scene.bodies.resize(1);
  core::Body& body = scene.bodies[0];
  const Vector3 point = body.initial.position + Vector3(0.3, -0.2, 0.4), axis = Vector3(1, 2, -2) / 3;
  body.initial.angular_velocity = 1.3 * axis;
  body.initial.velocity = body.initial.angular_velocity.cross(body.initial.position - point);
  scene.forces = {core::UniformGravity{{1.2, -8.7, 3.1}}};
  scene.joints = {{type, 0, core::world, point, axis}};
  return scene;
}

Motion certified_motion(const char* name, const core::Scene& scene, double duration, int order) {
  return {name, scene, duration, certified::solution(scene, duration).truth.state(duration), order};
}

std::vector<Motion> motions() {
  const core::Scene free = top();
  std::vector<Motion> all = {
      {"a free top", free, 0.5, exact::free_asymmetric_top(free, 0.5).state(0.5), 2},
      certified_motion("a hinge", swing(core::JointType::hinge), 0.5, 4),
      certified_motion("a ball joint", swing(core::JointType::ball), 0.5, 2),
      certified_motion("forces at the centres", pulled(), 0.5, 4),
  };
  return all;
}

// The slope between two steps, and what the run states.
TEST_F(Mujoco, HasTheOrderThatItStates) {
  for (const Motion& motion : motions())
    for (const auto& [scheme, own] : {std::pair{"rk4", motion.order}, {"euler", 1}, {"implicit", 1}}) {
      const process::EngineChoice choice = engine(fmt::format("/integrator={}", scheme));
      const auto error = [&](std::int64_t steps) {
        return difference(last(choice, motion.scene, motion.duration / static_cast<double>(steps), steps),
                          motion.end);
      };
      const double coarse = error(50), fine = error(200);
      const double slope = std::log(coarse / fine) / std::log(4);
      EXPECT_NEAR(slope, own, 0.25) << motion.name << ", " << scheme << ": " << coarse << ", " << fine;
      const core::Recording run = play(choice, motion.scene, 1e-3, 1);
      EXPECT_EQ(run.terms.order, own) << motion.name << ", " << scheme;
    }
}

// With contacts and with a mass that changes no scheme is of more than first order.
TEST_F(Mujoco, StatesFirstOrderWhereNothingIsSmooth) {
  core::Scene resting = three_bodies(5);
  resting.bodies.resize(1);
  resting.bodies[0].shape = core::Sphere{0.2}, resting.bodies[0].collide = true;
  resting.planes = {{"floor", Vector3::UnitY(), -20}};
  resting.materials = {{{"*", "*"}, 0, 0.3}};
  core::Scene burning = three_bodies(6);
  burning.forces = {core::Thrust{.body = 0, .mass_rate = -0.1, .exhaust_velocity = Vector3(0, 1, 0)}};
  for (const core::Scene& scene : {resting, burning})
    EXPECT_EQ(play(engine("/integrator=rk4"), scene, 1e-3, 1).terms.order, 1);
}

// The rule of the expert: Runge-Kutta where all is smooth, the cone itself and no slip where surfaces rub.
TEST_F(Mujoco, ExpertChoosesByTheScene) {
  const core::Recording smooth = play(engine("/path=as-expert"), top(), 1e-3, 1);
  EXPECT_EQ(smooth.terms.integrator, "rk4");
  core::Scene rubbing = three_bodies(5);
  rubbing.bodies.resize(1);
  rubbing.bodies[0].shape = core::Sphere{0.2}, rubbing.bodies[0].collide = true;
  rubbing.planes = {{"floor", Vector3::UnitY(), -20}};
  rubbing.materials = {{{"*", "*"}, 0, 0.3}};
  const core::Recording rough = play(engine("/path=as-expert"), rubbing, 1e-3, 1);
  EXPECT_EQ(rough.terms.integrator, "euler");
  const auto value = [&](const char* name) {
    const auto& all = rough.terms.settings;
    const auto found = std::ranges::find(all, name, &core::Setting::name);
    return found == all.end() ? std::string("none") : found->value;
  };
  EXPECT_EQ(value("cone"), "elliptic");
  EXPECT_EQ(value("noslip_iterations"), "10");
}

// A block that slides is slowed by mu times the impulse of the floor, m (g t + v_y' - v_y), each by its own mu, whether
// MuJoCo is given one for all or a list of pairs.  (Not by mu g t alone: a sliding body hops.)
TEST_F(Mujoco, SlowsEachPairByItsOwnFriction) {
  const double g = 9.81, time = 0.4;
  for (const std::vector<double>& coefficients : {std::vector{0.3, 0.3}, {0.2, 0.5}, {0.0, 0.4}}) {
    core::Scene scene;
    scene.planes = {{"floor", Vector3::UnitY(), 0}};
    scene.forces = {core::UniformGravity{{0, -g, 0}}};
    for (std::size_t i = 0; i < 2; ++i) {
      core::Body body;
      body.name = i == 0 ? "a" : "b";
      body.shape = core::Box{{0.5, 0.05, 0.5}}, body.collide = true;
      body.mass = 2, body.inertia = Vector3(110, 130, 120).asDiagonal();  // which hardly rocks
      body.initial.position = {0, 0.05, 5.0 * static_cast<double>(i)};
      body.initial.velocity = {6, 0, 0};
      scene.bodies.push_back(body);
      scene.materials.push_back({{body.name, "floor"}, 0, coefficients[i]});
    }
    scene.materials.push_back({{"a", "b"}, 0, coefficients[0]});
    const core::Recording run = play(engine("/cone=elliptic"), scene, 1e-3, 800);
    for (std::size_t i = 0; i < 2; ++i) {
      const Vector3 change = run.states[800][i].velocity - run.states[400][i].velocity;
      const double expected = -coefficients[i] * (g * time + change.y());
      EXPECT_NEAR(change.x(), expected, 1e-9) << coefficients[i];
    }
  }
}

}  // namespace
}  // namespace cylon::conformance
