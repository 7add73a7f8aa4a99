// What the in-house engine says of its runs as data: through its worker, with the names of the scene.
#include "tests/conformance/adapters_fixture.h"
#include "tests/paths.h"

namespace cylon::conformance {
namespace {

core::Body ball(const char* name, double x, double mass = 1, double height = 0.5) {
  core::Body body;
  body.name = name;
  body.mass = mass;
  body.inertia = 0.1 * mass * core::Matrix3::Identity();
  body.initial.position = {x, height, 0};
  body.shape = core::Sphere{0.5};
  body.collide = true;
  return body;
}

core::Scene on_floor(std::vector<core::Body> bodies) {
  core::Scene scene;
  scene.bodies = std::move(bodies);
  scene.planes = {{"floor", Vector3::UnitY(), 0}};
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    scene.materials.push_back({{scene.bodies[i].name, "floor"}, 0, 0.5});
    for (std::size_t k = i + 1; k < scene.bodies.size(); ++k)
      scene.materials.push_back({{scene.bodies[i].name, scene.bodies[k].name}, 0, 0.5});
  }
  scene.forces = {core::UniformGravity{}};
  return scene;
}

std::vector<told::Diagnostic> diagnostics(const char* id, const core::Scene& scene, bool force = false) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1. / 240;
  request.setup.force = force;
  request.steps = 24;
  const process::RunOutcome outcome =
      process::run(process::parse_engine(id, process::default_engines(binary_dir)), request, limits);
  EXPECT_TRUE(outcome.recording) << id << ": " << outcome.reason;
  if (!outcome.recording) return {};
  // Each has its sentence among the remarks.
  std::vector<std::string> texts;
  for (const told::Diagnostic& d : outcome.recording->diagnostics) texts.push_back(d.text);
  EXPECT_EQ(outcome.recording->remarks, texts);
  return outcome.recording->diagnostics;
}

const told::Diagnostic* find(const std::vector<told::Diagnostic>& all, const std::string& kind) {
  const auto at = std::find_if(all.begin(), all.end(), [&](const auto& d) { return d.kind == kind; });
  EXPECT_NE(at, all.end()) << kind;
  return at == all.end() ? nullptr : &*at;
}

// What strikes is of first order; what has rested so far is solved to second order, as nothing in it jumped.
TEST(InHouseDiagnostics, NameBodiesMethodAndOrder) {
  struct Case {
    const char* id;
    double height;
    int order;
  };
  for (const auto& [id, height, order] :
       {Case{"in-house/path=stepping", 0.52, 1}, Case{"in-house-float/path=stepping", 0.52, 1},
        Case{"in-house/path=stepping", 0.5, 2}}) {
    const auto all = diagnostics(id, on_floor({ball("left", 0, 1, height), ball("right", 50, 1, height)}));
    ASSERT_EQ(all.size(), 2u);
    for (std::size_t k = 0; k < 2; ++k) {
      EXPECT_EQ(all[k].kind, "error-not-controlled");
      EXPECT_EQ(all[k].bodies, std::vector<std::string>{k == 0 ? "left" : "right"});
      EXPECT_EQ(all[k].body_count, 1u);
      EXPECT_EQ(all[k].method, "fixed steps with impulses");
      EXPECT_EQ(all[k].order, order) << id << " from " << height << " m";
    }
  }
}

TEST(InHouseDiagnostics, TellADeepOverlapAndItsDepth) {
  const auto all = diagnostics("in-house", on_floor({ball("left", 0), ball("right", 0.7)}));
  const told::Diagnostic* found = find(all, "deep-overlap");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->bodies, (std::vector<std::string>{"left", "right"}));
  EXPECT_NEAR(found->reached.value(), 0.3, 1e-12);
  EXPECT_NEAR(found->limit.value(), 0.1, 1e-12);
  EXPECT_EQ(found->unit, "m");
}

// Two arms that hang on one pin of a third body and overlap there: contact would press where joints hold, and joints
// opened by kilometres.
TEST(InHouseDiagnostics, TellAnOverlapOfJointedBodies) {
  core::Scene scene = on_floor({ball("left", 0), ball("right", 0.7), ball("base", 5)});
  for (core::Body& body : scene.bodies) body.initial.position.y() = 9;
  for (int i = 0; i < 2; ++i)
    scene.joints.push_back({.type = core::JointType::hinge,
                            .body = i,
                            .to = 2,
                            .point = {0.35, 9, 0},
                            .axis = Vector3::UnitZ(),
                            .name = i == 0 ? "left pin" : "right pin"});
  const auto all = diagnostics("in-house", scene);
  const told::Diagnostic* found = find(all, "jointed-overlap");
  ASSERT_TRUE(found);
  EXPECT_EQ(found->bodies, (std::vector<std::string>{"left", "right"}));
  EXPECT_NEAR(found->reached.value(), 0.3, 1e-12);
  for (const told::Diagnostic& d : all) EXPECT_NE(d.kind, "deep-overlap");
}

// Refused, since the light ball could have to carry the heavy one; forced, it runs and says so.
TEST(InHouseDiagnostics, TellAForcedRun) {
  const core::Scene scene = on_floor({ball("light", 0), ball("heavy", 1.5, 1e18)});
  const auto all = diagnostics("in-house", scene, true);
  const told::Diagnostic* found = find(all, "forced");
  ASSERT_TRUE(found);
  EXPECT_NE(found->text.find("else refused: "), std::string::npos);
  EXPECT_TRUE(found->bodies.empty());
}

}  // namespace
}  // namespace cylon::conformance
