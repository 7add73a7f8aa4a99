// What `cylon hunt` found and docs/hunt.md tells with numbers, beside engines that are right.
#include "harness/scenario/scenario.h"
#include "tests/conformance/adapters_fixture.h"

#include <cmath>
#include <filesystem>
#include <numbers>

namespace cylon::conformance {
namespace {

core::Scene scene_of(const char* name) {
  return scenario::load(std::filesystem::path(source_dir) / "tests/data/found" /
                        (std::string(name) + ".toml"))
      .scene;
}

struct Row {
  const char* engine;
  double dt, told, within;
};

// Sets `got` after so long, where the engine is here.
bool runs(const Row& row, const core::Scene& scene, double time, core::State& got) {
  const process::EngineChoice choice =
      process::parse_engine(row.engine, process::default_engines(binary_dir));
  if (process::missing(choice.row)) return false;
  got = last(choice, scene, row.dt, static_cast<int>(std::lround(time / row.dt)));
  return true;
}

// It leaves with the speed of 1 m/s with which it came.  Of n iterations each halves what joint and contact still lack.
TEST(FoundFaults, OfAWeldedBall) {
  const core::Scene scene = scene_of("welded_ball");
  for (const Row& row :
       {Row{"in-house", 0.01, 1, 1e-12}, Row{"ode", 0.001, 1, 1e-3}, Row{"physx", 0.001, 0.9375, 1e-4},
        Row{"physx/position-iterations=1", 0.001, 0.5, 1e-4},
        Row{"physx/position-iterations=2", 0.001, 0.75, 1e-4},
        Row{"physx/position-iterations=8", 0.001, 1 - 1. / 256, 1e-4},
        Row{"bullet", 0.001, 1 - 1. / 512, 1e-4}, Row{"bullet/iterations=4", 0.001, 0.875, 1e-4},
        Row{"jolt", 0.001, 1 - 1. / 512, 1e-4}, Row{"jolt/velocity-steps=4", 0.001, 0.875, 1e-4},
        Row{"rapier", 0.01, 0.62, 0.01}, Row{"rapier", 0.001, 0.22, 0.01}, Row{"havok", 0.01, 1.13, 0.01},
        Row{"havok", 0.001, 1.17, 0.01}}) {
    core::State end;
    if (!runs(row, scene, 1.5, end)) continue;
    for (const core::BodyState& body : end)
      EXPECT_NEAR(body.velocity.y(), row.told, row.within) << row.engine;
  }
}

// v - mu g t = 0.814214 m/s are left of sqrt(2) m/s, whichever way.
TEST(FoundFaults, OfFrictionAlongTheDiagonal) {
  const double left = std::numbers::sqrt2 - 0.6;
  const core::Scene diagonal = scene_of("diagonal_slide");
  core::Scene straight = diagonal;
  straight.bodies[0].initial.velocity = {std::numbers::sqrt2, 0, 0};
  for (const Row& row : {Row{"in-house", 0.01, left, 1e-12}, Row{"physx", 0.0005, left, 5e-4},
                         Row{"jolt", 0.0005, 0.8159, 2e-4}, Row{"jolt", 0.01, 0.8159, 2e-4},
                         Row{"rapier", 0.0005, 0.8159, 2e-4}, Row{"rapier", 0.01, 0.8159, 2e-4}}) {
    core::State end;
    if (!runs(row, diagonal, 0.6, end)) continue;
    EXPECT_NEAR(end[0].velocity.norm(), row.told, row.within) << row.engine;
    runs(row, straight, 0.6, end);
    EXPECT_NEAR(end[0].velocity.norm(), left, 5e-4) << row.engine;
  }
}

// Of 80, and of 300 rad/s, a quarter of pi in a step of 0.01 s is left.
TEST(FoundFaults, OfAFastSpin) {
  core::Scene scene = scene_of("fast_spin");
  for (const double spin : {80., 300.}) {
    scene.bodies[0].initial.angular_velocity.z() = spin;
    for (const Row& row :
         {Row{"in-house", 0.01, spin, 1e-11}, Row{"physx", 0.01, spin, 1e-3}, Row{"jolt", 0.01, spin, 1e-3},
          Row{"rapier", 0.01, std::numbers::pi / 4 / 0.01, 1e-3}}) {
      core::State end;
      if (!runs(row, scene, 0.1, end)) continue;
      EXPECT_NEAR(end[0].angular_velocity.z(), row.told, row.within) << row.engine;
    }
  }
}

// A free ball below 0.1 m/s is braked, and above it is not.
TEST(FoundFaults, OfSlowBodiesOnHavok) {
  core::Scene scene = scene_of("fast_spin");
  scene.bodies[0].initial.angular_velocity.setZero();
  for (const auto& [speed, havok] : {std::pair(0.15, 0.15), std::pair(0.09, 0.0597)}) {
    scene.bodies[0].initial.velocity = {0, 0, speed};
    for (const Row& row : {Row{"in-house", 0.01, speed, 1e-12}, Row{"physx", 0.01, speed, 1e-6},
                           Row{"jolt", 0.01, speed, 1e-6}, Row{"rapier", 0.01, speed, 1e-6},
                           Row{"havok", 0.01, havok, 1e-4}}) {
      core::State end;
      if (!runs(row, scene, 0.1, end)) continue;
      EXPECT_NEAR(end[0].velocity.z(), row.told, row.within) << row.engine;
    }
  }
}

}  // namespace
}  // namespace cylon::conformance
