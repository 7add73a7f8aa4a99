// What DART has is what the scene says: masses, inertia, places, speeds and freedoms, read from its own bodies; its own
// values of what a run may set; and that no function of Eigen crosses the border.
#include "reference/simulators/dart/dart_scene.h"
#include "reference/simulators/dart/dart_settings.h"
#include "tests/reference/exact/random_scenes.h"

#include <dlfcn.h>
#include <fmt/format.h>
#include <gtest/gtest.h>

namespace cylon::simulators {
namespace {

using core::Scene;
using core::Vector3;
using Type = core::JointType;

constexpr double unit = 0x1p-53;
const Vector3 place(0.2, 0.4, -0.1);

Scene bodies(unsigned seed, int count) {
  exact::RandomScenes random(seed);
  Scene scene;
  for (int i = 0; i < count; ++i) {
    scene.bodies.push_back(
        random.body({random.between(0.3, 0.5), random.between(0.5, 0.7), random.between(0.7, 0.8)}));
    scene.bodies.back().name = fmt::format("body{}", i);
  }
  return scene;
}

core::Joint joint(Type type, int body, int to, const Vector3& point) {
  return {type, body, to, point, Vector3(1, -2, 3).normalized(), 0};
}

dart_border::World world_of(const Scene& scene) {
  const applied::Forest forest = applied::forest_of(scene);
  return {dart_bodies(scene, forest), {}, dart_loops(scene, forest), {}, [](int, int) { return false; }};
}

TEST(DartWorld, HasMassesInertiaAndMotionsOfTheScene) {
  for (unsigned seed = 1; seed <= 6; ++seed) {
    Scene scene = bodies(seed, 5);
    scene.bodies[4].locked = true;
    const bool jointed = seed > 2;
    if (jointed)
      scene.joints = {joint(Type::ball, 0, core::world, {0.3, 0.1, -0.2}),
                      joint(Type::hinge, 1, 0, {0.5, 0.7, 0.2}), joint(Type::fixed, 2, 1, {0.1, -0.7, 0.3}),
                      joint(Type::ball, 3, 4, {0.1, 0.9, 0.3})};
    const dart_border::World world = world_of(scene);
    for (std::size_t i = 0; i < 4; ++i) {
      const core::Body& body = scene.bodies[i];
      EXPECT_EQ(world.mass(i), body.mass);
      const auto inertia = world.inertia(i);
      for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c)
          EXPECT_NEAR(inertia[static_cast<std::size_t>(3 * r + c)], body.inertia(r, c),
                      16 * unit * body.inertia.norm());
      const dart_border::Motion has = world.motion(i);
      const auto& q = has.orientation;
      const core::BodyState& start = body.initial;
      EXPECT_LE((from_dart(has.position) - start.position).norm(), 64 * unit * 5) << seed;
      EXPECT_LE(core::Quaternion(q[0], q[1], q[2], q[3]).angularDistance(start.orientation), 64 * unit)
          << seed;
      if (jointed) continue;  // the speeds of bodies on joints are those that joints allow
      EXPECT_LE((from_dart(has.velocity) - start.velocity).norm(), 64 * unit * start.velocity.norm());
      EXPECT_LE((from_dart(has.spin) - start.angular_velocity).norm(),
                64 * unit * start.angular_velocity.norm());
    }
  }
}

// Where the motion of the scene is one of the mechanism, it is DART's.
TEST(DartWorld, HasTheSpeedsThatJointsAllow) {
  Scene scene = bodies(21, 3);
  const Vector3 pin(0.3, 0.1, -0.2), knee(0.5, 0.7, 0.2), neck(0.1, -0.7, 0.3);
  scene.joints = {joint(Type::ball, 0, core::world, pin), joint(Type::hinge, 1, 0, knee),
                  joint(Type::fixed, 2, 1, neck)};
  const auto speed_at = [](const core::BodyState& s, const Vector3& point) -> Vector3 {
    return s.velocity + s.angular_velocity.cross(point - s.position);
  };
  const auto move_with = [&](core::BodyState& s, const Vector3& point, const Vector3& speed) {
    s.velocity = speed - s.angular_velocity.cross(point - s.position);
  };
  core::BodyState &a = scene.bodies[0].initial, &b = scene.bodies[1].initial, &c = scene.bodies[2].initial;
  move_with(a, pin, Vector3::Zero());
  b.angular_velocity = a.angular_velocity + 1.7 * scene.joints[1].axis;
  move_with(b, knee, speed_at(a, knee));
  c.angular_velocity = b.angular_velocity;
  move_with(c, neck, speed_at(b, neck));
  const dart_border::World world = world_of(scene);
  for (std::size_t i = 0; i < 3; ++i) {
    const core::BodyState& start = scene.bodies[i].initial;
    EXPECT_LE((from_dart(world.motion(i).velocity) - start.velocity).norm(), 64 * unit * 5) << i;
    EXPECT_LE((from_dart(world.motion(i).spin) - start.angular_velocity).norm(), 64 * unit * 5) << i;
  }
}

TEST(DartWorld, HasTheFreedomsThatJointsLeave) {
  const struct {
    const char* name;
    int bodies;
    std::vector<core::Joint> joints;
    std::size_t freedoms;
  } mechanisms[] = {
      {"free", 2, {}, 12},
      {"ball to the world", 1, {joint(Type::ball, 0, core::world, place)}, 3},
      {"hinge to the world", 1, {joint(Type::hinge, 0, core::world, place)}, 1},
      {"fixed to the world", 1, {joint(Type::fixed, 0, core::world, place)}, 0},
      {"afloat", 2, {joint(Type::hinge, 1, 0, place)}, 7},
      {"ring of balls, less the constraint that closes it",
       3,
       {joint(Type::ball, 0, 1, place), joint(Type::ball, 1, 2, place), joint(Type::ball, 2, 0, place)},
       12},
  };
  for (const auto& row : mechanisms) {
    Scene scene = bodies(51, row.bodies);
    scene.joints = row.joints;
    EXPECT_EQ(world_of(scene).freedoms(), row.freedoms) << row.name;
  }
}

// What is printed as DART's own value is DART's own value.
TEST(DartWorld, OptionsHaveDartsOwnValues) {
  const applied::Settings shipped =
      dart_settings(dart_engine("6"), {.dt = 1e-3, .path = "as-shipped"}, {true, true});
  EXPECT_TRUE(shipped.reasons.empty());
  const dart_border::Settings ours = dart_border_settings(shipped, 1e-3, Vector3::Zero());
  const dart_border::Settings own = dart_border::World::defaults();
  EXPECT_EQ(ours.sweeps, own.sweeps);
  EXPECT_EQ(ours.change, own.change);
  EXPECT_EQ(ours.relative_change, own.relative_change);
  EXPECT_EQ(ours.contact_erp, own.contact_erp);
  EXPECT_EQ(ours.contact_correction, own.contact_correction);
  EXPECT_EQ(ours.contact_cfm, own.contact_cfm);
  EXPECT_EQ(ours.loop_erp, own.loop_erp);
  EXPECT_EQ(ours.loop_cfm, own.loop_cfm);
}

// A program that showed its functions of Eigen would give DART's library those of another alignment.  These are three that
// it has; linked without cmake/engines.cmake's list of what it keeps to itself, it shows them.
TEST(DartBorder, ShowsNoFunctionOfEigen) {
  const core::Quaternion turn(core::Matrix3(core::Quaternion(0.5, 0.5, 0.5, 0.5).toRotationMatrix()));
  EXPECT_GT((turn * Vector3(1, 2, 3)).norm(), 1);
  for (const char* name :
       {"_ZN5Eigen8internal15queryCacheSizesERiS1_S1_", "_ZN5Eigen8internal19throw_std_bad_allocEv",
        "_ZNK5Eigen14QuaternionBaseINS_10QuaternionIdLi0EEEE16_transformVectorERKNS_"
        "6MatrixIdLi3ELi1ELi0ELi3ELi1EEE"}) {
    Dl_info where{};
    void* found = dlsym(RTLD_DEFAULT, name);
    if (!found || dladdr(found, &where) == 0) continue;
    EXPECT_NE(std::string(where.dli_fname).find(".so"), std::string::npos) << name << ": " << where.dli_fname;
  }
}

}  // namespace
}  // namespace cylon::simulators
