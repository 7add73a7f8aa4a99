// A scene's gravity lost the sign of its zeros on the way to a worker: the writer began its sum with +0, and
// 0 + -0 = 0. An engine that branches on signs, or a comparison bit by bit, then saw another scene than the
// one asked for.
#include "harness/process/scene_json.h"

#include <gtest/gtest.h>

#include <cmath>

namespace cylon::process {
namespace {

TEST(NegativeZeroGravity, ReachesWorkerUnchanged) {
  core::Scene scene;
  scene.bodies.resize(1);
  scene.bodies[0].name = "a";
  scene.forces.emplace_back(core::UniformGravity{{-0.0, -9.81, 0.0}});
  const std::string text = to_json(scene).dump();
  const core::Scene back = scene_from_json(nlohmann::json::parse(text));
  ASSERT_EQ(back.forces.size(), 1u);
  const core::Vector3& g = std::get<core::UniformGravity>(back.forces[0]).acceleration;
  EXPECT_TRUE(std::signbit(g.x())) << text;
  EXPECT_FALSE(std::signbit(g.z())) << text;
  EXPECT_EQ(g, core::Vector3(0, -9.81, 0));
}

}  // namespace
}  // namespace cylon::process
