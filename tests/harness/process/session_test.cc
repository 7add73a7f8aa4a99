// Many runs in one worker: the bits of runs in workers of their own, and a fresh worker after one that broke.
#include "harness/process/session.h"

#include "harness/core/input_error.h"
#include "harness/process/engine_table.h"
#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <thread>
#include <vector>

namespace cylon::process {
namespace {

core::Scene thrown(double speed) {
  core::Scene scene;
  core::Body box;
  box.name = "box", box.collide = true;
  box.shape = core::Box{core::Vector3::Constant(0.1)};
  box.inertia = 2.0 / 300 * core::Matrix3::Identity();
  box.initial.position = {0, 0.3, 0};
  box.initial.velocity = {speed, -1, 0.2};
  box.initial.angular_velocity = {1, 2, 3};
  scene.bodies = {box};
  scene.planes = {core::Plane{.name = "floor"}};
  scene.forces = {core::UniformGravity{}};
  scene.materials = {core::Material{{"box", "floor"}, 0.2, 0.3}};
  return scene;
}

EngineChoice engine(const char* id) { return parse_engine(id, default_engines(binary_dir)); }

RunOutcome in(Session& session, const EngineChoice& choice, const core::Scene& scene) {
  return session.run(choice, {.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100});
}

// An engine whose starts are counted, by a wrapper that notes them.
class Noted {
 public:
  explicit Noted(const char* id) : choice(engine(id)) {
    choice.row.command.insert(choice.row.command.begin(),
                              {"sh", "-c", "echo >>" + notes_ + "; exec \"$@\"", "sh"});
  }
  std::ptrdiff_t started() const {
    std::ifstream file(notes_);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  }

 private:
  const TemporaryFolder folder_;
  const std::string notes_ = folder_.path() / "notes";

 public:
  EngineChoice choice;
};

TEST(Sessions, GiveTheBitsOfRunsInWorkersOfTheirOwn) {
  for (const std::string& id : compared_engines()) {
    const EngineChoice choice = engine(id.c_str());
    Session session(choice.row, {});
    for (const double speed : {0.5, 1.5, 0.5}) {
      const core::Scene scene = thrown(speed);
      const RunOutcome together = in(session, choice, scene),
                       alone =
                           run(choice, {.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100});
      ASSERT_TRUE(together.recording) << id << ": " << together.reason;
      ASSERT_TRUE(alone.recording) << id << ": " << alone.reason;
      ASSERT_EQ(together.recording->states.size(), alone.recording->states.size());
      for (std::size_t i = 0; i < alone.recording->states.size(); ++i) {
        EXPECT_EQ(together.recording->states[i][0].position, alone.recording->states[i][0].position) << id;
        EXPECT_EQ(together.recording->states[i][0].orientation.coeffs(),
                  alone.recording->states[i][0].orientation.coeffs())
            << id;
      }
      EXPECT_EQ(together.recording->engine.name, alone.recording->engine.name);
    }
  }
}

// A joint that the engine does not know, and one that its adapter refuses.
TEST(Sessions, KeepTheirWorkerWhereASceneIsRefused) {
  const Noted ode("ode");
  Session session(ode.choice.row, {});
  const core::Scene scene = thrown(1);
  const RunOutcome first = in(session, ode.choice, scene);
  core::Scene unknown = scene, refused = scene;
  unknown.joints = {core::Joint{.type = core::JointType::screw}};
  unknown.joints[0].pitch = 1;
  refused.joints = {core::Joint{.type = core::JointType::gimbal, .axis_2 = core::Vector3::UnitY()}};
  refused.joints[0].angles = {{core::JointCoordinate{.upper = 1}}};
  const RunOutcome of_unknown = in(session, ode.choice, unknown),
                   of_refused = in(session, ode.choice, refused);
  EXPECT_EQ(of_unknown.status, results::Status::unsupported);
  EXPECT_NE(of_unknown.reason.find("screw_joints"), std::string::npos) << of_unknown.reason;
  EXPECT_EQ(of_refused.status, results::Status::unsupported);
  EXPECT_NE(of_refused.reason.find("ODE's ball has no limits"), std::string::npos) << of_refused.reason;
  const RunOutcome again = in(session, ode.choice, scene);
  ASSERT_TRUE(first.recording && again.recording) << first.reason << again.reason;
  EXPECT_EQ(first.recording->states.back()[0].position, again.recording->states.back()[0].position);
  EXPECT_EQ(ode.started(), 1);
}

TEST(Sessions, StartAfreshAfterAFailure) {
  const Noted ode("ode");
  Session session(ode.choice.row, {});
  const core::Scene scene = thrown(1);
  EXPECT_TRUE(in(session, ode.choice, scene).recording);
  EngineChoice impossible = ode.choice;
  impossible.integrator = "none-such";
  EXPECT_THROW(in(session, impossible, scene), core::InputError);
  EXPECT_TRUE(in(session, ode.choice, scene).recording);
  EXPECT_EQ(ode.started(), 2);
}

TEST(KeptWorkers, ServeRunsOfTheirThreadAsLongAsTheyLive) {
  const Noted noted("ode");
  const core::Scene scene = thrown(1);
  const RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100};
  const auto end = [&] { return run(noted.choice, request).recording.value().states.back()[0].position; };
  const core::Vector3 alone = end();
  EXPECT_EQ(noted.started(), 1);
  {
    const KeptWorkers kept;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(end(), alone);
    EXPECT_EQ(noted.started(), 2);
    std::thread(end).join();  // not its thread
    EXPECT_EQ(noted.started(), 3);
    RunRequest timed = request;
    timed.repetitions = 1;
    EXPECT_EQ(run(noted.choice, timed).repetitions.size(), 1u);
    EXPECT_EQ(noted.started(), 4);
    {
      const KeptWorkers inner;
      EXPECT_EQ(end(), alone);
      EXPECT_EQ(noted.started(), 5);
    }
    EXPECT_EQ(end(), alone);
    EXPECT_EQ(noted.started(), 5);
  }
  EXPECT_EQ(end(), alone);
  EXPECT_EQ(noted.started(), 6);
}

// A choice that was changed after its id was read had the options of the first one.  All are of one worker.
TEST(KeptWorkers, TellChoicesOfOneIdApart) {
  const Noted noted("bullet");
  const core::Scene scene = thrown(1);
  const RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100};
  const EngineChoice plain = noted.choice;
  EngineChoice other = plain;
  other.options["gyro"] = "none";
  const auto end = [&](const EngineChoice& choice) {
    return run(choice, request).recording.value().states.back()[0].orientation.coeffs().eval();
  };
  const auto first = end(plain), second = end(other);
  EXPECT_NE(first, second);
  const KeptWorkers kept;
  EXPECT_EQ(end(plain), first);
  EXPECT_EQ(end(other), second);
  EXPECT_EQ(end(plain), first);
  EXPECT_EQ(noted.started(), 3);
}

TEST(Sessions, SayWhyThereIsNoWorkerAndRefuseRepetitions) {
  EngineChoice none = engine("ode");
  none.row.command = {"/no/such/worker"};
  Session session(none.row, {});
  const core::Scene scene = thrown(1);
  EXPECT_EQ(in(session, none, scene).status, results::Status::unsupported);
  RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 1};
  request.repetitions = 1;
  EXPECT_THROW(session.run(none, request), std::invalid_argument);
}

}  // namespace
}  // namespace cylon::process
