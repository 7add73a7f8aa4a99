// MuJoCo's own model ten_J3.xml, imported, ended the worker by SIGABRT: joints that stand at their stops have a row of
// constraints each, and the room that the adapter asked MuJoCo for (njmax) counted contacts and loops alone.  Bodies on a
// rail and in a chain, each of which falls against its stop, in one scene.
#include "tests/conformance/adapters_fixture.h"

namespace cylon::conformance {
namespace {

// Three arms at a lower stop, in a chain, and a weight on a rail, which rubs.
core::Scene at_their_stops() {
  core::Scene scene;
  const auto body = [&](const char* name, const core::Vector3& position) {
    core::Body& one = scene.bodies.emplace_back();
    one.name = name, one.mass = 0.3, one.inertia = core::Vector3(2e-3, 3e-3, 4e-3).asDiagonal();
    one.initial.position = position;
  };
  body("weight", {-0.03, 0.175, 0}), body("arm", {0.05, 0.3, 0});
  body("forearm", {0.15, 0.3, 0}), body("hand", {0.25, 0.3, 0});
  core::Joint rail{.type = core::JointType::slider, .body = 0, .axis = {0, 1, 0}};
  rail.point = {-0.03, 0.2, 0};
  rail.displacements.push_back({{.lower = 0.0, .upper = 60.0, .friction = 0.1}});
  scene.joints = {rail};
  for (int i = 1; i < 4; ++i) {
    core::Joint hinge{.type = core::JointType::hinge, .body = i, .axis = {0, 0, 1}};
    hinge.to = i == 1 ? core::world : i - 1;
    hinge.point = {0.1 * (i - 1), 0.3, 0};
    hinge.angles.push_back({{.lower = 0.0, .upper = 1.05}});
    scene.joints.push_back(hinge);
  }
  scene.forces = {core::UniformGravity{{0, -9.81, 0}}};
  return scene;
}

TEST(MujocoTenJ3, HasRoomForJointsAtTheirStops) {
  for (const char* id : {"mujoco", "mujoco/path=as-expert"}) {
    const auto engine = process::parse_engine(id, process::default_engines(binary_dir));
    if (process::missing(engine.row)) continue;
    process::RunRequest request;
    const core::Scene scene = at_their_stops();
    request.scene = &scene, request.setup.dt = 1e-3, request.steps = 300;
    const process::RunOutcome outcome = process::run(engine, request, limits);
    ASSERT_TRUE(outcome.recording) << id << ": " << outcome.reason;
    // Soft stops: they give way by millimetres, and hold.
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
      EXPECT_LT((outcome.recording->states.back()[i].position - scene.bodies[i].initial.position).norm(),
                0.02)
          << id << ", " << scene.bodies[i].name;
  }
}

}  // namespace
}  // namespace cylon::conformance
