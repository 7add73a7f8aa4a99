// Engines that have no gyroscopic torque: they are held to what they have.  Where a scene has none of what they lack, they
// are as exact as their roundings of masses; where it has, their path `stand-in` leaves it out and no other says nothing.
#include "tests/conformance/adapters_fixture.h"
#include "tests/conformance/adapters_refused_scenes.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <string_view>

namespace cylon::conformance {
namespace {

struct Lacking {
  const char* id;
  bool single;
  double masses;  // relative rounding of inverse masses and moments
  const char* says;

  double unit() const { return single ? 0x1p-24 : 0x1p-53; }
  process::EngineChoice choice(const std::string& setting = "") const {
    return process::parse_engine(std::string(id) + setting, process::default_engines(binary_dir));
  }
};
void PrintTo(const Lacking& engine, std::ostream* out) { *out << engine.id; }

const Lacking lacking[] = {
    {"havok", true, 0x1p-8, "Havok has no gyroscopic torque"},
    {"cannon-es", false, 0x1p-52, "cannon-es has no gyroscopic torque"},
};

class LeftOut : public testing::TestWithParam<Lacking> {
 protected:
  void SetUp() override {
    if (const auto reason = process::missing(GetParam().choice().row)) GTEST_SKIP() << *reason;
  }
};

std::string lacking_name(const testing::TestParamInfo<Lacking>& engine) {
  std::string name = engine.param.id;
  std::ranges::replace(name, '-', '_');
  return name;
}
INSTANTIATE_TEST_SUITE_P(Adapters, LeftOut, testing::ValuesIn(lacking), lacking_name);

constexpr double dt = 1. / 512;
constexpr int steps = 256;

// What a body would do whose every axis is a principal one:  w stays,  q' = exp(w t) q,  x' = x + v t.
core::State as_spheres(const core::Scene& scene, double t) {
  core::State state = core::initial_state(scene);
  for (core::BodyState& s : state) {
    const double rate = s.angular_velocity.norm();
    s.orientation = Quaternion(Eigen::AngleAxisd(rate * t, s.angular_velocity / rate)) * s.orientation;
    s.position += t * s.velocity;
  }
  return state;
}

TEST_P(LeftOut, StartIsReadBack) {
  const core::Scene scene = three_bodies(161);
  const core::State start = last(GetParam().choice("/path=stand-in"), scene, dt, 0);
  expect_within(fmt::format("start, {}", GetParam().id), difference(start, core::initial_state(scene)),
                32 * GetParam().unit());  // Havok keeps a rotation as a matrix
}

TEST_P(LeftOut, FreeBodiesKeepTheirSpin) {
  const core::Scene scene = three_bodies(162);
  const core::State end = last(GetParam().choice("/path=stand-in"), scene, dt, steps);
  // A quaternion q + (w dt/2) q, made a unit again, turns by 2 atan(w dt/2): less by (w dt)^3/12 in each step.
  double fastest = 0;
  for (const core::Body& body : scene.bodies)
    fastest = std::max(fastest, body.initial.angular_velocity.norm());
  const double turn = steps * std::pow(fastest * dt, 3) / 12;
  expect_within(fmt::format("free motion, {}", GetParam().id), difference(end, as_spheres(scene, dt * steps)),
                turn + 64 * steps * GetParam().unit());
  EXPECT_GT(
      (end[0].angular_velocity -
       last(process::parse_engine("in-house", process::default_engines(binary_dir)), scene, dt, steps)[0]
           .angular_velocity)
          .norm(),
      1e-2)
      << "a motion that tells the torque from its absence";
}

// v = v0 + F t/m of a constant force:  to the rounding of the mass.
TEST_P(LeftOut, ForcesActToTheRoundingOfMasses) {
  core::Scene scene = three_bodies(163);
  for (core::Body& body : scene.bodies) body.initial.angular_velocity.setZero();
  const Vector3 gravity(0.4, -9.1, 0.3);
  scene.forces.emplace_back(core::UniformGravity{gravity});
  const Vector3 force(0.7, 2, -1.1);
  scene.forces.emplace_back(core::Drive{1, force, 0});
  const core::State end = last(GetParam().choice("/path=stand-in"), scene, dt, steps);
  for (std::size_t i = 0; i < 3; ++i) {
    Vector3 gained = dt * steps * gravity;
    if (i == 1) gained += dt * steps * force / scene.bodies[1].mass;
    expect_within(fmt::format("velocity of body {}, {}", i, GetParam().id),
                  (end[i].velocity - scene.bodies[i].initial.velocity - gained).norm(),
                  GetParam().masses * dt * steps * force.norm() / scene.bodies[1].mass +
                      64 * steps * GetParam().unit());
  }
}

core::Scene of_one(const core::Matrix3& inertia, const Vector3& spin) {
  core::Scene scene = three_bodies(164);
  scene.bodies.resize(1);
  scene.bodies[0].inertia = inertia;
  scene.bodies[0].initial.orientation = Quaternion::Identity();
  scene.bodies[0].initial.angular_velocity = spin;
  return scene;
}

// Bodies at two ends of a rod, one of which hangs from the world by another: as gravity moves them without rods they are 0.6 m
// away.  Havok's rods were refused: SetAxisMode answers RESULT_INVALIDARGS to their axis, and sets the mode.
TEST_P(LeftOut, RodsKeepTheirLengths) {
  core::Scene scene = jointed(core::JointType::distance, 0, -1);
  scene.joints.push_back(jointed(core::JointType::distance, 1, 0).joints[0]);
  for (core::Body& body : scene.bodies) body.inertia = 0.3 * core::Matrix3::Identity();
  scene.forces = {core::UniformGravity{{0.4, -9.1, 0.3}}};
  const process::EngineChoice exact = process::parse_engine("in-house", process::default_engines(binary_dir));
  const auto farthest = [&](const core::State& a, const core::State& b) {
    return std::max((a[0].position - b[0].position).norm(), (a[1].position - b[1].position).norm());
  };
  const core::State truth = last(exact, scene, dt, steps);
  const core::State end = last(GetParam().choice("/path=stand-in"), scene, dt, steps);
  EXPECT_NEAR((end[0].position - scene.joints[0].point).norm(), scene.joints[0].length, 1e-3);
  EXPECT_NEAR((end[1].position - end[0].position).norm(), scene.joints[1].length, 1e-3);
  // Semi-implicit Euler is g dt T/2 off in free fall; rods that swing bend the path by as much again.
  EXPECT_LE(farthest(end, truth), 9.1 * dt * dt * steps);
  scene.joints.clear();
  EXPECT_GT(farthest(last(exact, scene, dt, steps), truth), 0.3);
}

// Taken where it turns about a principal axis, refused where it does not.
TEST_P(LeftOut, TorqueIsRefusedWhereItIs) {
  const core::Matrix3 inertia = Vector3(0.2, 0.3, 0.4).asDiagonal();
  EXPECT_NO_THROW(last(GetParam().choice(), of_one(inertia, {0, 2, 0}), dt, 5));
  EXPECT_NO_THROW(last(GetParam().choice(), of_one(0.3 * core::Matrix3::Identity(), {1, 2, 3}), dt, 5));
  try {
    last(GetParam().choice(), of_one(inertia, {0.1, 2, 0}), dt, 5);
    ADD_FAILURE() << "ran";
  } catch (const std::runtime_error& error) {
    EXPECT_NE(std::string_view(error.what()).find(GetParam().says), std::string_view::npos) << error.what();
  }
}

}  // namespace
}  // namespace cylon::conformance
