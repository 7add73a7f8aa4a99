// What the engine is held to: scenes of Cylon, by name, and a scene of its own, by file.
#include <cylon/gtest.h>

#include <gtest/gtest-spi.h>

TEST(MyEngine, FliesTheParabola) { EXPECT_CONFORMS(MY_ENGINE, "projectile"); }
TEST(MyEngine, FliesItInC) { EXPECT_CONFORMS(MY_ENGINE_C, "projectile"); }
TEST(MyEngine, FallsByTheGravityOfEachBody) { EXPECT_CONFORMS(MY_ENGINE, SCENES "/two_stones.toml"); }

// A control: an engine of first order misses the parabola by g dt T/2, and the test sees it.
TEST(MyEngine, IsCaughtWithExplicitEuler) {
  const cylon::judge::Engine euler({MY_ENGINE}, "integrator=euler");
  const cylon::judge::Asked coarse{.dt = 0.01};
  EXPECT_NONFATAL_FAILURE(EXPECT_CONFORMS(euler, "projectile", coarse), "position follows projectile: fail");
}

// What it cannot do is no pass either.
TEST(MyEngine, SaysThatItHasNoRotation) {
  EXPECT_NONFATAL_FAILURE(EXPECT_CONFORMS(MY_ENGINE_C, "heavy_top"), "the engine does not take joints");
}
