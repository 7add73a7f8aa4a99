// Simbody's integrators: what a run says of its order is what it shows, on free tops, joints, loops and forces; with
// error control the error follows the tolerance; each run gives the same bits.
#include "reference/certified/truth.h"
#include "reference/exact/solutions.h"
#include "tests/conformance/adapters_fixture.h"

#include <cmath>

namespace cylon::conformance {
namespace {

class Simbody : public testing::Test {
 protected:
  void SetUp() override {
    if (const auto reason = process::missing(engine("").row)) GTEST_SKIP() << *reason;
  }
  static process::EngineChoice engine(const std::string& variant) {
    return process::parse_engine("simbody" + variant, process::default_engines(binary_dir));
  }
};

struct Motion {
  const char* name;
  core::Scene scene;
  core::State end;
};
constexpr double duration = 0.5;

core::Scene top() {
  core::Scene scene = exact::RandomScenes(22).scene("free_asymmetric_top");
  scene.forces.clear();
  return scene;
}

core::Scene pulled() {
  core::Scene scene = three_bodies(151);
  for (core::Body& body : scene.bodies) body.initial.angular_velocity.setZero();
  scene.forces = {core::UniformGravity{{3.3, -8.1, 4.6}},
                  core::Spring{0, Vector3::Zero(), 1, Vector3::Zero(), 17, 0.4, 1.9},
                  core::Spring{2, Vector3::Zero(), core::world, {0.8, -1.4, 0.5}, 17, 0.4, 1.9},
                  core::Drag{2, 0.7, 0, 0}, core::Attraction{0, 2, 4.2}};
  return scene;
}

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

Motion certified_motion(const char* name, const core::Scene& scene) {
  return {name, scene, certified::solution(scene, duration).truth.state(duration)};
}

std::vector<Motion> motions() {
  const core::Scene free = top();
  return {{"a free top", free, exact::free_asymmetric_top(free, duration).state(duration)},
          certified_motion("a hinge", swing(core::JointType::hinge)),
          certified_motion("a ball joint", swing(core::JointType::ball)),
          certified_motion("forces at the centres", pulled())};
}

// The slope between two steps, and what the run states.
TEST_F(Simbody, HasTheOrderThatItStates) {
  const std::pair<const char*, int> schemes[] = {
      {"semi-explicit-euler", 1}, {"semi-explicit-euler-2", 1}, {"verlet", 2},
      {"runge-kutta-3", 3},       {"runge-kutta-merson", 4},    {"runge-kutta-feldberg", 4}};
  for (const Motion& motion : motions())
    for (const auto& [scheme, order] : schemes) {
      const process::EngineChoice choice = engine(fmt::format("/integrator={}", scheme));
      const auto error = [&](std::int64_t steps) {
        return difference(last(choice, motion.scene, duration / static_cast<double>(steps), steps),
                          motion.end);
      };
      const int most = order < 4 ? 200 : 80;  // above rounding
      const double coarse = error(most / 4), fine = error(most);
      const double slope = std::log(coarse / fine) / std::log(4);
      const std::string what = fmt::format("{}, {}: {}, {}", motion.name, scheme, coarse, fine);
      EXPECT_GT(slope, order - 0.3) << what;
      EXPECT_LT(slope, order + 1.3) << what;  // one term may all but cancel
      EXPECT_EQ(play(choice, motion.scene, 1e-3, 1).terms.order, order) << motion.name << ", " << scheme;
    }
}

TEST_F(Simbody, StatesFirstOrderWhereAMassChanges) {
  core::Scene burning = three_bodies(6);
  burning.forces = {core::Thrust{.body = 0, .mass_rate = -0.1, .exhaust_velocity = Vector3(0, 1, 0)}};
  EXPECT_EQ(play(engine(""), burning, 1e-3, 1).terms.order, 1);
}

// Its own steps: the error falls with the tolerance, and is not that of the samples' step.
TEST_F(Simbody, KeepsToTheTolerance) {
  for (const Motion& motion : motions())
    for (const char* scheme : {"runge-kutta-merson", "runge-kutta-feldberg", "runge-kutta-3"}) {
      const auto error = [&](double tolerance) {
        process::RunRequest request;
        request.scene = &motion.scene;
        request.setup.dt = duration, request.setup.tolerance = tolerance;
        request.steps = 1;
        const process::RunOutcome outcome = process::run(
            engine(fmt::format("/integrator={}-adaptive,interpolation=disable", scheme)), request, limits);
        EXPECT_TRUE(outcome.recording) << outcome.reason;
        return outcome.recording ? difference(outcome.recording->states.back(), motion.end) : 1.0;
      };
      const double coarse = error(1e-4), fine = error(1e-8);
      expect_within(fmt::format("{}, {}, 1e-8", motion.name, scheme), fine, 1e-6);
      EXPECT_GT(coarse, 10 * fine) << motion.name << ", " << scheme;
    }
}

// Without error control there is one step in a dt: two steps of half the size are another motion.
TEST_F(Simbody, RefusesToleranceOfFixedStep) {
  const core::Scene scene = top();
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = 0.01, request.setup.tolerance = 1e-6, request.steps = 1;
  EXPECT_ANY_THROW(process::run(engine("/integrator=verlet"), request, limits));
}

// Another process, the same bits; and the expert's path is another run.
TEST_F(Simbody, GivesTheSameBits) {
  const core::Scene scene = pulled();
  for (const char* variant : {"", "/integrator=verlet", "/integrator=runge-kutta-feldberg-adaptive"})
    EXPECT_EQ(difference(last(engine(variant), scene, 0.01, 50), last(engine(variant), scene, 0.01, 50)), 0);
  const core::Recording expert = play(engine("/path=as-expert"), scene, 0.01, 1);
  EXPECT_EQ(expert.terms.integrator, "runge-kutta-feldberg");
}

// Of a body on two ball joints the second is a constraint: left alone below its tolerance, and kept closer by the expert.
TEST_F(Simbody, ExpertKeepsLoopsClosed) {
  core::Scene scene = swing(core::JointType::ball);
  scene.joints.push_back(scene.joints[0]);
  scene.joints[1].point += 0.4 * Vector3(1, 2, -2) / 3;
  const Vector3 arm = scene.joints[1].point - scene.bodies[0].initial.position;
  const Vector3 own = scene.bodies[0].initial.orientation.conjugate() * arm;
  for (const char* path : {"as-shipped", "as-expert"}) {
    const core::State end = last(engine(fmt::format("/path={}", path)), scene, 0.01, 100);
    const Vector3 point = end[0].position + end[0].orientation * own;
    EXPECT_LE((point - scene.joints[1].point).norm(), path == std::string("as-expert") ? 1e-9 : 1e-4) << path;
  }
}

}  // namespace
}  // namespace cylon::conformance
