// Programs against engines' own APIs: each is compiled and run, and prints what Cylon measures.
#include "harness/hunt/program/program.h"

#include "harness/core/solid.h"
#include "harness/hunt/hunt.h"
#include "harness/hunt/oracle.h"
#include "harness/process/engine_table.h"
#include "harness/process/session.h"
#include "harness/scenario/scenario.h"
#include "harness/study/cell.h"
#include "harness/study/runner.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <optional>
#include <ostream>

namespace cylon::hunt {
namespace {

namespace fs = std::filesystem;
using core::Vector3;

process::EngineChoice engine(const std::string& id) {
  return process::parse_engine(id, process::default_engines(binary_dir));
}

// ---- Scenes of general values -----------------------------------------------------------------------------

void add(Trial& trial, const core::Shape& shape, double mass, const Vector3& at, const Vector3& v,
         const Vector3& w, bool touches) {
  core::Body body;
  body.name = fmt::format("b{}", trial.scene.bodies.size() + 1);
  body.shape = shape, body.mass = mass, body.collide = touches;
  body.inertia = core::mass_properties(shape, mass).inertia;
  body.initial = {at, core::Quaternion(0.8, 0.36, 0.48, 0), v, w};
  trial.scene.bodies.push_back(body);
}

Trial over_floor(Trial trial, double restitution, double friction) {
  trial.scene.planes = {core::Plane{"floor", Vector3(0.1, 1, 0.05).normalized(), -0.2, {}, {}}};
  trial.scene.materials = {core::Material{{"*", "*"}, restitution, friction}};
  trial.scene.forces.emplace_back(core::UniformGravity{{0.2, -9.7, 0.1}});
  return trial;
}

Trial spinning_box() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 1.3, {0.2, 0.1, 0}, {0.3, 1, -0.2}, {1, 6, 2}, false);
  return trial;
}

Trial springs() {
  Trial trial{{}, 0.01, 80};
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 1.3, {0.2, 0.1, 0}, {0.3, 1, -0.2}, {1, 2, 0.5}, false);
  add(trial, core::Sphere{0.25}, 2.1, {1.4, 0.3, 0.2}, {0, 0.4, 0.1}, {0.3, 0, 1}, false);
  trial.scene.forces = {core::UniformGravity{{0.1, -9.7, 0.3}},
                        core::Spring{0, {0.05, 0.1, 0.02}, core::world, {0.1, 1.2, 0.3}, 45, 0.4, 0},
                        core::Spring{1, {0, 0.1, 0}, 0, {0.1, 0, 0}, 60, 0, 0}, core::Attraction{0, 1, 0.7}};
  return trial;
}

Trial damped_springs() {
  Trial trial = springs();
  std::get<core::Spring>(trial.scene.forces[1]).damping = 1.5;
  trial.scene.forces.emplace_back(core::Drag{1, 0.4, 0.02, 0.3});
  core::Thrust thrust;
  thrust.force = {0.5, 0.2, -1};
  trial.scene.forces.emplace_back(thrust);
  trial.scene.forces.emplace_back(core::Drive{1, {1, 2, 0.5}, 3});
  return trial;
}

Trial pendulum() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 1.3, {0.2, 0.1, 0}, {0, 0, 0}, {0, 0, 0}, false);
  add(trial, core::Sphere{0.25}, 2.1, {1.1, 0.3, 0.2}, {0, 0, 0}, {0, 0, 0}, false);
  trial.scene.forces = {core::UniformGravity{{0.1, -9.7, 0.3}}};
  trial.scene.joints = {
      core::Joint{core::JointType::hinge, 0, core::world, {0, 0.5, 0.1}, Vector3(0.6, 0, 0.8), 0},
      core::Joint{core::JointType::ball, 1, 0, {0.7, 0.2, 0.1}, Vector3::UnitY(), 0}};
  return trial;
}

// Two trees: joints of the world and of bodies, which move as they let them.
Trial branches() {
  Trial trial{{}, 0.01, 80};
  const auto joined = [&](const core::Shape& shape, core::JointType type, int to, const Vector3& point,
                          const Vector3& away, const Vector3& spin) {
    const int body = static_cast<int>(trial.scene.bodies.size());
    core::BodyState of_world, *on = &of_world;
    if (to != core::world) on = &trial.scene.bodies[static_cast<std::size_t>(to)].initial;
    const Vector3 w = on->angular_velocity + spin;
    const Vector3 v = on->velocity + on->angular_velocity.cross(point - on->position) + w.cross(away);
    add(trial, shape, 1.3 + 0.4 * body, point + away, v, w, false);
    trial.scene.bodies.back().initial.orientation =
        core::Quaternion(0.5 + body, 0.36, -0.48, 0.1 * body).normalized();
    trial.scene.joints.push_back(core::Joint{type, body, to, point, Vector3(0.6, 0, 0.8), 0});
  };
  using enum core::JointType;
  const core::Box box{{0.1, 0.3, 0.2}};
  joined(box, hinge, core::world, {0, 0.5, 0.1}, {0.2, -0.4, 0}, Vector3(0.6, 0, 0.8) * 1.5);
  joined(core::Sphere{0.25}, ball, 0, {0.4, 0.1, 0.1}, {0.5, -0.1, 0.2}, {1, 2, -0.5});
  joined(box, hinge, 1, {1, 0.2, 0.3}, {0.3, 0.1, -0.3}, Vector3(0.6, 0, 0.8) * -2.5);
  joined(box, fixed, 0, {0.1, -0.3, 0.4}, {0.1, -0.2, 0.3}, {0, 0, 0});
  joined(box, ball, core::world, {2, 0, 0}, {-0.2, 0.4, 0.3}, {1, -2, 0.5});
  joined(box, fixed, core::world, {5, 0, 0}, {0.2, 0.4, 0.3}, {0, 0, 0});
  add(trial, box, 2.1, {0.7, 1.9, 0.2}, {0.1, 0.4, 0.1}, {0.3, 3, 1}, false);
  trial.scene.forces = {core::UniformGravity{{0.1, -9.7, 0.3}},
                        core::Spring{2, {0.05, 0.1, 0.02}, 6, {0.1, 0, 0.3}, 45, 0.4, 0}};
  return trial;
}

Trial falling_balls() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Sphere{0.2}, 1.3, {0, 0.5, 0}, {0.5, 0, 0.2}, {1, 2, 3}, true);
  add(trial, core::Sphere{0.25}, 2.1, {0.9, 0.6, 0.1}, {-1, 0.4, 0.1}, {0.3, 0, 1}, true);
  return over_floor(trial, 0.5, 0.3);
}

// For the oracles that have a motion of their own: level, from the floor and from above it.
Trial on_level_floor(const core::Shape& shape, double height, const Vector3& v, double restitution,
                     double friction) {
  Trial trial{{}, 0.01, 25};
  add(trial, shape, 1.3, {0.3, height, -0.2}, v, {0, 0, 0}, true);
  trial.scene.bodies[0].initial.orientation = core::Quaternion::Identity();
  trial.scene.planes = {core::Plane{"floor", Vector3::UnitY(), -0.2, {}, {}}};
  trial.scene.materials = {core::Material{{"*", "*"}, restitution, friction}};
  trial.scene.forces.emplace_back(core::UniformGravity{{0, -9.7, 0}});
  return trial;
}
Trial sliding_box() { return on_level_floor(core::Box{{0.3, 0.1, 0.2}}, -0.1, {1.1, 0, -2.3}, 0, 0.4); }
Trial dropped_ball() { return on_level_floor(core::Sphere{0.2}, 0.2, {0.4, -1, 0.3}, 0.7, 0); }

Trial turning_balls() {
  Trial trial{{}, 0.01, 20};
  add(trial, core::Sphere{0.2}, 1.3, {0, 0.5, 0}, {0.5, 0, 0.2}, {30, 80, -20}, false);
  add(trial, core::Sphere{0.3}, 2.1, {2, 0.5, 0}, {0, 0, 0}, {0, 0, 0}, false);
  return trial;
}

Trial falling_box() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 1.3, {0, 0.6, 0}, {0.5, 0, 0.2}, {1, 2, 3}, true);
  return over_floor(trial, 0, 0.4);
}

// Which do not touch each other.
Trial falling_links() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Sphere{0.2}, 1.3, {0, 0.5, 0}, {0.5, 0, 0.2}, {0, 0, 0}, true);
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 2.1, {0.4, 0.6, 0.1}, {0.5, 0, 0.2}, {0, 0, 0}, true);
  trial.scene.joints = {core::Joint{core::JointType::ball, 1, 0, {0.2, 0.6, 0.1}, Vector3::UnitY(), 0}};
  return over_floor(trial, 0.5, 0.3);
}

Trial falling_solids() {
  Trial trial{{}, 0.01, 60};
  add(trial, core::Capsule{0.15, 0.4}, 1.3, {0, 0.6, 0}, {0.5, 0, 0.2}, {1, 2, 3}, true);
  add(trial, core::Cylinder{0.2, 0.3}, 1.7, {0.7, 0.6, 0.1}, {-0.6, 0.1, 0.2}, {1, -2, 3}, true);
  add(trial, core::Box{{0.1, 0.3, 0.2}}, 1.3, {0, 0.6, 0.8}, {0.5, 0, -0.2}, {-1, 2, 3}, true);
  add(trial, core::Sphere{0.2}, 1.1, {0.8, 0.5, 0.9}, {-0.5, 0, -0.4}, {1, 2, 3}, true);
  return over_floor(trial, 0, 0.4);
}

Trial two_fixed() {
  Trial trial = pendulum();
  trial.scene.joints[1].type = core::JointType::fixed;
  return trial;
}

struct Case {
  const char* engine;
  const char* oracle;
  Trial (*scene)();
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.engine << ", " << c.oracle; }

// A program does the same in another order of operations.  In single precision each step rounds places of some metres and
// energies of some hundred joules.
double allowed(const Case& c, const Program& program, std::int64_t steps) {
  const double size = std::string(program.unit) == "J" ? 100 : 1;
  const std::string_view id = c.engine, engine = id.substr(0, id.find('/'));
  const bool single =
      engine.starts_with("rapier") || engine == "jolt" || engine == "physx" || engine == "havok";
  return 1e-6 * program.prints + (single ? 6e-8 * size * static_cast<double>(steps) : 0);
}

const Case cases[] = {
    {"ode", "angular momentum", spinning_box},
    {"ode/path=as-shipped", "turn", spinning_box},
    {"ode", "energy", springs},
    {"ode", "place", damped_springs},
    {"ode", "joint gap", pendulum},
    {"ode", "energy from nowhere", springs},
    {"ode/path=quick", "penetration", falling_box},
    {"ode", "relation rotation", falling_box},
    {"bullet/gyro=none", "angular momentum", spinning_box},
    {"bullet", "energy", springs},
    {"bullet", "place", damped_springs},
    {"bullet", "joint gap", pendulum},
    {"bullet/path=as-shipped", "penetration", falling_balls},
    {"bullet", "energy from nowhere", springs},
    {"rapier", "energy", springs},
    {"rapier", "penetration", falling_balls},
    {"rapier-deterministic", "penetration", falling_balls},
    {"rapier-simd", "penetration", falling_balls},
    {"rapier", "joint gap", pendulum},
    {"rapier", "energy from nowhere", springs},
    {"jolt", "energy", springs},
    {"jolt/path=as-shipped", "angular momentum", spinning_box},
    {"jolt", "penetration", falling_balls},
    {"jolt", "energy", falling_solids},
    {"jolt", "joint gap", pendulum},
    {"jolt", "relation rotation", falling_box},
    {"jolt", "energy from nowhere", springs},
    {"mujoco3", "energy", springs},
    {"mujoco3/integrator=rk4", "angular momentum", spinning_box},
    {"mujoco3", "penetration", falling_box},
    {"mujoco3", "energy from nowhere", springs},
    {"mujoco3", "relation rotation", falling_box},
    {"mujoco3/cone=elliptic,solref-time=0.05", "energy", falling_solids},
    {"havok/path=stand-in", "energy", springs},
    {"havok/path=stand-in", "penetration", falling_box},
    {"havok/path=stand-in", "energy", falling_solids},
    {"havok/path=stand-in", "energy from nowhere", springs},
    {"havok/path=stand-in", "relation rotation", falling_box},
    {"havok/path=stand-in", "joint gap", pendulum},
    {"havok/path=stand-in", "joint gap", two_fixed},
    {"physx", "energy", springs},
    {"physx/path=as-shipped,gyro=on", "penetration", falling_box},
    {"physx", "energy", falling_solids},
    {"physx/solver=tgs", "joint gap", pendulum},
    {"physx", "joint gap", two_fixed},
    {"physx", "energy from nowhere", springs},
    {"crashcat", "energy", springs},
    {"crashcat/path=as-shipped", "energy", falling_box},
    {"crashcat", "energy", falling_solids},
    {"crashcat", "joint gap", pendulum},
    {"crashcat", "relation rotation", falling_box},
    {"cannon-es/path=stand-in", "energy", springs},
    {"cannon-es/path=stand-in", "penetration", falling_box},
    {"cannon-es/path=as-shipped", "penetration", falling_balls},
    {"cannon-es/path=stand-in", "joint gap", pendulum},
    {"cannon-es/path=stand-in", "energy from nowhere", springs},
    {"cannon-es/path=stand-in", "relation rotation", falling_box},
    {"bullet-multibody", "slide", sliding_box},
    {"bullet-multibody", "penetration", falling_box},
    {"bullet-multibody", "place", damped_springs},
    {"ode", "slide", sliding_box},
    {"mujoco", "slide", sliding_box},
    {"dart", "slide", sliding_box},
    {"jolt", "slide", sliding_box},
    {"rapier", "slide", sliding_box},
    {"bullet", "spin", turning_balls},
    {"jolt", "spin", turning_balls},
    {"bullet/path=as-shipped", "rebound", dropped_ball},
    {"crashcat/path=as-shipped", "rebound", dropped_ball},
    {"mujoco/path=as-expert", "place", damped_springs},
    {"mujoco", "energy", branches},
    {"mujoco/path=as-expert", "penetration", falling_box},
    {"mujoco", "relation rotation", falling_solids},
    {"simbody", "place", damped_springs},
    {"simbody/path=as-expert", "energy", branches},
    {"dart", "energy", branches},
    {"dart/path=as-expert,solver=pgs", "penetration", falling_links},
    {"siconos/integrator=moreau-jean-implicit", "place", damped_springs},
    {"siconos/path=as-expert", "penetration", falling_balls},
};

// What Cylon measures, as the first number of a fault, or as that at a quarter of the step.
Card measured_by_cylon(const Case& c, std::size_t halved = 0) {
  Card card;
  card.engine = c.engine, card.trial = c.scene(), card.fault.oracle = c.oracle, card.fault.says = "a test";
  card.signature = signature(card.fault, card.trial.scene);
  const auto oracle = std::ranges::find(oracles(), c.oracle, &Oracle::name);
  if (oracle == oracles().end()) return card;  // of a relation
  if (oracle->read) {
    process::RunOutcome last;
    const core::Recording run = study::worker_runner(engine(c.engine), {}, &last)(
        card.trial.scene, card.trial.step, card.trial.steps, 1);
    card.fault.measured[0] = oracle->read(card.trial.scene, run).value().measured;
    return card;
  }
  card.fault.claim =
      fmt::format("[[claim]]\n{}\ntolerance = {{ absolute = 1e-3, reason = \"a test\" }}\n", oracle->claim);
  const scenario::Scenario scenario = scenario::parse(to_toml(card.trial, card.fault.claim), "test.toml");
  study::Cell cell;
  cell.scenario = &scenario, cell.engine = engine(c.engine),
  cell.dt = std::ldexp(card.trial.step, -static_cast<int>(halved)), cell.dt_text = "test";
  card.fault.measured[halved] = study::run(cell, {}, {}).at(0).measured;
  return card;
}

std::string output_of(const std::string& command) {
  std::string out;
  FILE* pipe = popen(command.c_str(), "r");
  std::array<char, 256> part{};
  while (std::fgets(part.data(), part.size(), pipe)) out += part.data();
  EXPECT_EQ(pclose(pipe), 0) << command;
  return out;
}

std::string name_of(const testing::TestParamInfo<Case>& info) {
  std::string name = fmt::format("{}_{}_{}", info.index, info.param.engine, info.param.oracle);
  std::ranges::replace_if(
      name, [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
  return name;
}

// What it prints, compiled and run.
std::string printed_by(const Program& program) {
  const TemporaryFolder own;
  const fs::path& folder = own.path();
  std::ofstream(folder / program.file) << program.text;
  const fs::path modules = fs::path(source_dir) / "reference/simulators/js/node_modules";
  if (program.file.ends_with(".mjs")) fs::create_directory_symlink(modules, folder / "node_modules");
  return output_of(
      fmt::format("PATH={}/tests/cached:$PATH; cd {} && {}", source_dir, folder.string(), program.command));
}

// The cases keep one worker for each engine: that an engine carries nothing over is tested elsewhere
// (tests/harness/process/session_test.cc), and a process of Node starts for longer than a run takes.
class ProgramOf : public testing::TestWithParam<Case> {
 public:
  static void SetUpTestSuite() { kept_.emplace(); }
  static void TearDownTestSuite() { kept_.reset(); }

 private:
  static inline std::optional<process::KeptWorkers> kept_;
};
TEST_P(ProgramOf, PrintsWhatCylonMeasures) {
  const Case& c = GetParam();
  const process::EngineChoice subject = engine(c.engine);
  if (process::missing(subject.row)) GTEST_SKIP() << *process::missing(subject.row);
  const Card card = measured_by_cylon(c);
  const Written written = write_program(card, subject, {});
  ASSERT_TRUE(written.program) << written.none;
  const Program& program = *written.program;
  EXPECT_GT(program.prints, 2 * allowed(c, program, card.trial.steps));  // a number to agree with
  EXPECT_GT(program.prints, 1e-6);
  const std::string out = printed_by(program);
  EXPECT_NEAR(std::strtod(out.c_str(), nullptr), program.prints, allowed(c, program, card.trial.steps))
      << out << program.text;
  EXPECT_TRUE(out.ends_with(program.unit + "\n")) << out;
}
INSTANTIATE_TEST_SUITE_P(All, ProgramOf, testing::ValuesIn(cases), name_of);

// A fault that only fine steps have is shown with one of them.
TEST(ProgramOf, AFaultOfFineStepsHasSuchAStep) {
  Card card = measured_by_cylon({"ode", "energy", springs}, 2);
  card.fault.allowed = card.fault.measured[2] / 2;
  const Written written = write_program(card, engine("ode"), {});
  ASSERT_TRUE(written.program) << written.none;
  EXPECT_EQ(written.program->prints, card.fault.measured[2]);
  EXPECT_NEAR(std::strtod(printed_by(*written.program).c_str(), nullptr), card.fault.measured[2],
              1e-6 * card.fault.measured[2]);
}

// What has no row is told, and gets no program that shows something else.
TEST(ProgramOf, SaysWhatItCannotExpress) {
  const auto why = [](const std::string& id, const std::string& oracle,
                      const std::function<void(Trial&)>& change) {
    Card card;
    card.engine = id, card.trial = falling_box(), card.fault.oracle = oracle;
    change(card.trial);
    const Written written = write_program(card, engine(id), {});
    EXPECT_FALSE(written.program);
    return written.none;
  };
  const auto nothing = [](Trial&) {};
  EXPECT_EQ(why("in-house", "energy", nothing), "no table of texts for the API of in-house");
  EXPECT_EQ(why("ode", "statics", nothing), "the oracle 'statics' takes more than a few lines");
  EXPECT_EQ(why("ode", "rest",
                [](Trial& t) {
                  t.scene.bodies[0].shape = core::Capsule{0.1, 0.2};
                }),
            "no line for the shape capsule");
  EXPECT_EQ(why("ode", "rest", [](Trial& t) { t.scene.bodies[0].locked = true; }), "a body is locked");
  EXPECT_EQ(why("bullet/solver=nncg", "rest", nothing), "no line for the setting constraint solver = nncg");
  EXPECT_EQ(why("ode/path=as-expert", "rest", nothing),
            "no line for the setting contact_mode = dContactApprox1 | dContactBounce | dContactFDir1");
  EXPECT_EQ(why("dart/sweeps=7", "rest", nothing),
            "no line for the setting PgsBoxedLcpSolver::Option::mMaxIteration = 7");
  EXPECT_EQ(why("mujoco", "energy",
                [](Trial& t) {
                  t = pendulum();
                  std::swap(t.scene.joints[1].body, t.scene.joints[1].to);
                }),
            "a joint hangs an earlier body from a later one");
  EXPECT_EQ(why("mujoco", "energy",
                [](Trial& t) {
                  t = pendulum();
                  t.scene.joints.push_back(t.scene.joints[1]);
                  t.scene.joints.back().to = core::world;
                }),
            "a joint closes a loop");
}

}  // namespace
}  // namespace cylon::hunt
