// A pile shrinks from its top to its foot, also past heights that do not show the fault.
#include "harness/hunt/shrink.h"

#include <gtest/gtest.h>

#include <cstddef>
#include <string>
#include <vector>

namespace cylon::hunt {
namespace {

// ODE drops towers of 3, 5, 6 and 10 cubes, and holds one of 4: taking one cube at a time ends at 5.
TEST(Shrink, FindsASmallPileBehindOneThatStands) {
  Trial trial;
  for (int i = 0; i < 10; ++i) {
    core::Body cube;
    cube.name = "b" + std::to_string(i + 1), cube.shape = core::Box{{0.5, 0.5, 0.5}};
    cube.initial.position.y() = i + 0.5;
    trial.scene.bodies.push_back(cube);
  }
  const auto is_dropped = [](const Trial& one) {
    const std::vector<core::Body>& bodies = one.scene.bodies;
    for (std::size_t i = 0; i < bodies.size(); ++i)
      if (bodies[i].initial.position.y() != static_cast<double>(i) + 0.5 || bodies[i].mass != 1) return false;
    return bodies.size() >= 5 || bodies.size() == 3;
  };
  const Trial least = shrink(trial, is_dropped);
  ASSERT_EQ(least.scene.bodies.size(), 3u);
  EXPECT_EQ(least.scene.bodies[2].name, "b3");
}

}  // namespace
}  // namespace cylon::hunt
