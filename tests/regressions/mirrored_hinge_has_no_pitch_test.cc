// A mirrored scene gave each joint the pitch -0, also a hinge, and the writer of the protocol, which keeps the sign of a
// zero, sent it. An engine that knows no screws answered with an error: `cylon run --metamorphic` and `cylon hunt` ended,
// the latter without its cards, where an engine in JavaScript was asked about a joint.
#include "harness/process/scene_json.h"
#include "harness/study/restate.h"

#include <gtest/gtest.h>

namespace cylon::process {
namespace {

TEST(MirroredHinge, HasNoPitch) {
  study::Restatement mirror;
  mirror.turn.diagonal() << -1, 1, 1;
  mirror.own = mirror.turn;
  for (const core::JointKind& kind : core::joint_kinds) {
    core::Scene scene;
    scene.bodies.resize(1);
    scene.bodies[0].name = "a";
    core::Joint joint;
    joint.type = kind.type, joint.body = 0, joint.axis = {1, 0, 0}, joint.axis_2 = {0, 1, 0};
    if (kind.screws) joint.pitch = 0.5;
    scene.joints.push_back(joint);
    const nlohmann::json sent = to_json(mirror(scene));
    EXPECT_EQ(sent["joint"][0].contains("pitch"), kind.screws) << sent["joint"][0];
    if (kind.screws) {
      EXPECT_EQ(sent["joint"][0]["pitch"], -0.5);
    }
  }
}

}  // namespace
}  // namespace cylon::process
