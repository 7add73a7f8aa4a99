// Which joints Simbody's adapter takes: all in a tree, four kinds where they close a loop.
#include "reference/simulators/simbody/simbody_limits.h"

#include "harness/core/joint_kinds.h"
#include "tests/reference/simulators/refusals.h"

namespace cylon::simulators {
namespace {

using core::JointType;

core::Joint full(JointType type, int body, int to) {
  core::Joint one = joint(type, body, to);
  if (core::kind_of(type).has_second_axis()) one.axis_2 = Vector3::UnitX();
  if (core::kind_of(type).screws) one.pitch = 0.1;
  return one;
}

TEST(SimbodyLimits, CloseLoopsByFourKinds) {
  struct Row {
    JointType type;
    bool closes;
  };
  for (const Row& row : {Row{JointType::ball, true},
                         {JointType::hinge, true},
                         {JointType::fixed, true},
                         {JointType::distance, true},
                         {JointType::slider, false},
                         {JointType::cylindrical, false},
                         {JointType::planar, false},
                         {JointType::universal, false},
                         {JointType::screw, false}}) {
    Scene scene = taken();
    for (core::Body& body : scene.bodies) body.collide = false;
    scene.joints = {full(row.type, 2, core::world)};
    EXPECT_FALSE(simbody_limit(scene)) << core::kind_of(row.type).name;
    scene.joints = {joint(JointType::ball, 0, core::world), joint(JointType::ball, 2, core::world),
                    full(row.type, 2, 0)};
    const auto reason = simbody_limit(scene);
    EXPECT_EQ(!reason.has_value(), row.closes) << core::kind_of(row.type).name;
    EXPECT_TRUE(row.closes || reason.value_or("").find("closes a loop") != std::string::npos)
        << reason.value_or("");
  }
}

}  // namespace
}  // namespace cylon::simulators
