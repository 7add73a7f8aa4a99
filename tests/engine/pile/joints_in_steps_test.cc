// Joints in fixed steps were closed by sixteen sweeps, which left most of them open by 1e-9 to 1e-6 m, and a diagnostic said
// so of nearly every step.
#include "tests/engine/diagnostic_scenes.h"
#include "tests/engine/joint_scenes.h"

namespace cylon::engine {
namespace {

Options by_steps(Time dt) {
  Options options = with("auto", dt);
  options.path = "stepping";
  return options;
}

// The end of a run by steps, and whether joints stayed open.
struct Jointed {
  std::vector<Motion> motions;
  bool drifted = false;
};
Jointed after_steps(const Model& model, Time dt, int steps) {
  EXPECT_EQ(unsupported(model, by_steps(dt)), "");
  World world(model, by_steps(dt));
  for (int k = 0; k < steps; ++k) world.step();
  const auto told = world.diagnostics();
  return {world.motions(), std::ranges::any_of(told, [](const Diagnostic& d) {
            return d.kind == DiagnosticKind::joints_drifted;
          })};
}

// Chains that fall on a floor, and each kind of joint with a limit that it meets.
TEST(JointsInSteps, AreClosedToRounding) {
  for (const Time dt : {0.02, 0.005}) {
    const Model chain = chain_of_boxes(8);
    const int steps = static_cast<int>(std::lround(1 / dt));
    const Jointed end = after_steps(chain, dt, steps);
    for (const Joint& joint : chain.joints)
      EXPECT_LT(opened(end.motions, joint), 1e-13) << dt;  // 2 to 9 m away
    EXPECT_FALSE(end.drifted) << dt;
  }
  for (const JointKind& kind : joint_kinds) {
    if (kind.type.couples) continue;  // not stepped
    for (const bool to_world : {false, true}) {
      JointScene scene = joint_scene(kind.type, to_world);
      scene.model.forces.gravity = {0.2, -9.81, 0.4};
      CoordinateLaw law;
      law.at = kind.type.place == Joint::Place::together ? scene.angle() : scene.displacement(scene.axis);
      if (kind.type.place == Joint::Place::in_plane) law.at = scene.displacement(scene.second);
      law.lower = -0.05, law.upper = 0.05, law.friction = 0.1;
      scene.model.forces.coordinate_laws.push_back(law);
      scene.model.planes = {{Vector3::UnitY(), -40}};
      make_touchable(scene.model, 0);
      const Jointed end = after_steps(scene.model, 0.005, 200);
      EXPECT_LT(opened(end.motions, scene.joint()), 1e-13) << kind.name << to_world;
      EXPECT_FALSE(end.drifted) << kind.name << to_world;
    }
  }
}

}  // namespace
}  // namespace cylon::engine
