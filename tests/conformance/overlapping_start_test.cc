// Bodies that are in one another at t = 0: the in-house engine takes them, and a remark names both bodies and the
// depth of a deep overlap; Bullet and ODE take all, each with what it makes of them.
#include "tests/conformance/adapters_fixture.h"
#include "tests/paths.h"

namespace cylon::conformance {
namespace {

const core::Box box = {{0.5, 0.3, 0.4}};
const core::Sphere ball = {0.3};
const core::Capsule capsule = {0.2, 0.5};
const core::Hull brick = {{{-0.5, -0.3, -0.4},
                           {0.5, -0.3, -0.4},
                           {-0.5, 0.3, -0.4},
                           {0.5, 0.3, -0.4},
                           {-0.5, -0.3, 0.4},
                           {0.5, -0.3, 0.4},
                           {-0.5, 0.3, 0.4},
                           {0.5, 0.3, 0.4}}};

struct Row {
  const char* name;
  core::Shape one, other;  // monostate: a plane
  Vector3 way;             // from one to the other, along which they overlap
  double reach;            // the distance at which they touch [m]
  double depth;            // [m]
  bool deep;
  const char* said = "";  // the depth, in words
  bool locked = false;    // both of them
};

// A tenth of the width of the thinner: 0.06 m of a box or a ball, 0.04 m of a capsule.
const Row rows[] = {
    {"boxes", box, box, Vector3::UnitY(), 0.6, 0.1, true, "0.1 m"},
    {"boxes, a little", box, box, Vector3::UnitY(), 0.6, 0.05, false},
    {"boxes, rounding", box, box, Vector3::UnitY(), 0.6, 1e-9, false},
    {"boxes, coincident", box, box, Vector3::UnitY(), 0.6, 0.6, true, "0.6 m"},
    {"boxes, locked", box, box, Vector3::UnitY(), 0.6, 0.2, false, "", true},
    {"balls", ball, ball, Vector3(2, 3, -6) / 7, 0.6, 0.07, true, "0.07 m"},
    {"balls, a little", ball, ball, Vector3(2, 3, -6) / 7, 0.6, 0.05, false},
    {"balls, rounding", ball, ball, Vector3(2, 3, -6) / 7, 0.6, 1e-9, false},
    {"balls, coincident", ball, ball, Vector3::UnitX(), 0.6, 0.6, true, "0.6 m"},
    {"capsules", capsule, capsule, Vector3::UnitX(), 0.4, 0.05, true, "0.05 m"},
    {"capsules, a little", capsule, capsule, Vector3::UnitX(), 0.4, 0.03, false},
    {"capsules, coincident", capsule, capsule, Vector3::UnitX(), 0.4, 0.4, true, "0.4 m"},
    {"hull on box", brick, box, Vector3::UnitY(), 0.6, 0.08, true, "0.08 m"},
    {"hull on box, a little", brick, box, Vector3::UnitY(), 0.6, 0.02, false},
    {"ball in a box", ball, box, Vector3::UnitY(), 0.6, 0.6, true, "0.6 m"},
    {"box in a plane", box, core::Shape(), -Vector3::UnitY(), 0.3, 0.07, true, "0.07 m"},
    {"box in a plane, a little", box, core::Shape(), -Vector3::UnitY(), 0.3, 0.01, false},
};

// Turned as a whole, so that nothing is along an axis.
core::Scene scene_of(const Row& row) {
  const Quaternion turn = Quaternion(0.8, 0.3, -0.4, 0.33).normalized();
  core::Scene scene;
  const auto add = [&](const char* name, const core::Shape& shape, const Vector3& at) {
    core::Body body;
    body.name = name;
    body.mass = 1.3;
    body.inertia = Vector3(0.05, 0.06, 0.07).asDiagonal();
    body.initial.position = turn * at;
    body.initial.orientation = turn;
    body.shape = shape;
    body.collide = true;
    body.locked = row.locked;
    scene.bodies.push_back(body);
  };
  const double apart = row.reach - row.depth;
  add("upper", row.one, Vector3::Zero());
  if (std::holds_alternative<std::monostate>(row.other))
    scene.planes = {{"lower", -(turn * row.way), -apart}};
  else
    add("lower", row.other, apart * row.way);
  scene.materials = {{{"upper", "lower"}, 0, 0.5}};
  scene.forces = {core::UniformGravity{}};
  return scene;
}

process::RunOutcome outcome_of(const char* id, const core::Scene& scene) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = 1. / 240;
  request.steps = 24;
  return process::run(process::parse_engine(id, process::default_engines(binary_dir)), request, limits);
}

// It was refused, though other engines run it.
TEST(OverlappingStart, StaysFiniteAndADeepOneIsRemarked) {
  for (const Row& row : rows)
    for (const char* id : {"in-house", "in-house/path=stepping", "in-house-float"}) {
      const process::RunOutcome outcome = outcome_of(id, scene_of(row));
      ASSERT_TRUE(outcome.recording) << row.name << ", " << id << ": " << outcome.reason;
      for (const core::BodyState& body : outcome.recording->states.back())
        EXPECT_TRUE(body.position.allFinite() && body.velocity.norm() < 10) << row.name << ", " << id;
      std::string remarks;
      for (const std::string& remark : outcome.recording->remarks) remarks += remark + "; ";
      EXPECT_EQ(remarks.find("overlap by") != std::string::npos, row.deep) << row.name << ", " << id;
      if (!row.deep) continue;
      for (const char* word : {"'upper'", "'lower'", row.said})
        EXPECT_NE(remarks.find(word), std::string::npos) << row.name << ", " << id << ": " << remarks;
    }
}

TEST(OverlappingStart, OtherEnginesAcceptIt) {
  for (const Row& row : rows)
    for (const char* id : {"bullet", "ode"}) {
      const bool hull = std::holds_alternative<core::Hull>(row.one);
      if (hull && std::string(id) == "ode") continue;  // it collides no hulls at all
      const process::RunOutcome outcome = outcome_of(id, scene_of(row));
      EXPECT_NE(results::name(outcome.status), "unsupported")
          << row.name << ", " << id << ": " << outcome.reason;
    }
}

}  // namespace
}  // namespace cylon::conformance
