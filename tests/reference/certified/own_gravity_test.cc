// A body's own gravity stands in place of the scene's in the certified equations.
#include "reference/certified/truth.h"

#include <gtest/gtest.h>

namespace cylon::certified {
namespace {

//   p = p0 + v0 t + g t^2/2 with the body's own g.
TEST(OwnGravity, IsCertified) {
  core::Scene scene;
  scene.forces.emplace_back(core::UniformGravity{{0.2, -9.81, 0.3}});
  const core::Vector3 falls[] = {{0.2, -9.81, 0.3}, {1.1, 0.4, -0.6}, {0, 0, 0}};
  for (int i = 0; i < 3; ++i) {
    core::Body body;
    body.name = std::to_string(i), body.mass = 0.7 + i;
    body.initial.position = {0.1, 0.2 * i, 0.3}, body.initial.velocity = {1, 0.5, 0.2 * i};
    if (i > 0) body.gravity = falls[i];
    scene.bodies.push_back(body);
  }
  const core::State end = solution(scene, 1, 1e9).truth.state(1);
  for (std::size_t i = 0; i < 3; ++i) {
    const core::BodyState& s = scene.bodies[i].initial;
    EXPECT_LE((end[i].position - (s.position + s.velocity + falls[i] / 2)).norm(), 1e-13) << i;
    EXPECT_LE((end[i].velocity - (s.velocity + falls[i])).norm(), 1e-13) << i;
  }
}

}  // namespace
}  // namespace cylon::certified
