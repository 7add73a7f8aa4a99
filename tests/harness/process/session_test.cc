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

RunOutcome in(Session& session, const core::Scene& scene) {
  return session.run({.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100});
}

TEST(Sessions, GiveTheBitsOfRunsInWorkersOfTheirOwn) {
  for (const std::string& id : compared_engines()) {
    Session session(engine(id.c_str()), {});
    for (const double speed : {0.5, 1.5, 0.5}) {
      const core::Scene scene = thrown(speed);
      const RunOutcome together = in(session, scene),
                       alone = run(engine(id.c_str()),
                                   {.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100});
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

TEST(Sessions, GoOnAfterARunThatDoesNotPass) {
  Session session(engine("ode"), {});
  core::Scene refused = thrown(1);
  core::Joint screw{.type = core::JointType::screw};  // ODE has none
  screw.pitch = 1;
  refused.joints = {screw};
  const core::Scene scene = thrown(1);
  const RunOutcome first = in(session, scene);
  EXPECT_EQ(in(session, refused).status, results::Status::unsupported);
  const RunOutcome again = in(session, scene);
  ASSERT_TRUE(first.recording && again.recording) << first.reason << again.reason;
  EXPECT_EQ(first.recording->states.back()[0].position, again.recording->states.back()[0].position);
}

// How often a worker was started, by a wrapper that notes it.
TEST(KeptWorkers, ServeRunsOfTheirThreadAsLongAsTheyLive) {
  const TemporaryFolder folder;
  const std::string notes = folder.path() / "notes";
  EngineChoice noted = engine("ode");
  noted.row.command.insert(noted.row.command.begin(),
                           {"sh", "-c", "echo >>" + notes + "; exec \"$@\"", "sh"});
  const auto started = [&] {
    std::ifstream file(notes);
    return std::count(std::istreambuf_iterator<char>(file), {}, '\n');
  };
  const core::Scene scene = thrown(1);
  const RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100};
  const auto end = [&] { return run(noted, request).recording.value().states.back()[0].position; };
  const core::Vector3 alone = end();
  EXPECT_EQ(started(), 1);
  {
    const KeptWorkers kept;
    for (int i = 0; i < 3; ++i) EXPECT_EQ(end(), alone);
    EXPECT_EQ(started(), 2);
    std::thread(end).join();  // not its thread
    EXPECT_EQ(started(), 3);
    RunRequest timed = request;
    timed.repetitions = 1;
    EXPECT_EQ(run(noted, timed).repetitions.size(), 1u);
    EXPECT_EQ(started(), 4);
    {
      const KeptWorkers inner;
      EXPECT_EQ(end(), alone);
      EXPECT_EQ(started(), 5);
    }
    EXPECT_EQ(end(), alone);
    EXPECT_EQ(started(), 5);
  }
  EXPECT_EQ(end(), alone);
  EXPECT_EQ(started(), 6);
}

// A choice that was changed after its id was read had the worker, and the options, of the first one.
TEST(KeptWorkers, TellChoicesOfOneIdApart) {
  const core::Scene scene = thrown(1);
  const RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 300, .every = 100};
  const EngineChoice plain = engine("bullet");
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
}

TEST(Sessions, SayWhyThereIsNoWorkerAndRefuseRepetitions) {
  EngineChoice none = engine("ode");
  none.row.command = {"/no/such/worker"};
  Session session(none, {});
  const core::Scene scene = thrown(1);
  EXPECT_EQ(in(session, scene).status, results::Status::unsupported);
  RunRequest request{.scene = &scene, .setup = {.dt = 0.002}, .steps = 1};
  request.repetitions = 1;
  EXPECT_THROW(session.run(request), std::invalid_argument);
  Session impossible(engine("ode/integrator=none-such"), {});
  EXPECT_THROW(in(impossible, scene), core::InputError);
}

}  // namespace
}  // namespace cylon::process
