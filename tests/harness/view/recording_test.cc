// A recorded session as a scenario: it validates, the same engine passes it, and another scene fails it.
#include "harness/view/record_file.h"

#include "harness/core/input_error.h"
#include "harness/view/command.h"
#include "harness/view/host.h"
#include "tests/harness/view/fixture.h"
#include "tests/temporary_folder.h"

#include <fmt/format.h>
#include <unistd.h>

#include <filesystem>

namespace cylon::view {
namespace {

namespace fs = std::filesystem;

class RecordingTest : public testing::Test {
 protected:
  const TemporaryFolder own_;
  const fs::path& folder_ = own_.path();
};

// Kicked in mid-flight, recorded, loaded, run again: the same engine's motion to the last bit, and another
// that the claims tell from it.
TEST_F(RecordingTest, SameEnginePassesItsRecording) {
  for (const char* id : {"ode", "bullet", "in-house"}) {
    for (const bool jointed : {false, true}) {
      Session session(scenario(jointed ? hinged_pair() : ball_on_floor(0.4, {0.3, 0, 0}, 0.7)),
                      options(id, std::string(id) == "in-house" ? "rk4" : "", "1/120"));
      advance_to(session, 0.25);
      session.apply(Kick{0, {0.4, 1.5, -0.2}});
      advance_to(session, 1);
      const fs::path path =
          save_recording(session.recorder(), session.scenario(), folder_ / (std::string(id) + ".toml"));
      const scenario::Scenario saved = scenario::load(path);
      EXPECT_NEAR(saved.duration, 0.75, 0.01);
      ASSERT_EQ(saved.claims.size(), 2u);
      process::RunRequest request{&saved.scene, setup(saved.step, session.options().lane.integrator)};
      request.steps = core::whole_steps(saved.duration, saved.step);
      request.every = 1;
      const process::RunOutcome again = run(engine(id), request, limits);
      ASSERT_EQ(again.status, results::Status::pass) << id << again.reason;
      const core::Truth& truth = *saved.claims[0].truth;
      double worst = 0;
      for (const double t : truth.times) {
        const auto step = static_cast<std::size_t>(std::lround(t / saved.step));
        const core::State told = truth.state(t);
        for (std::size_t b = 0; b < told.size(); ++b)
          worst = std::max(worst, (told[b].position - again.recording->states[step][b].position).norm());
      }
      // The loader makes velocities fit the joints in their last digits.
      EXPECT_LE(worst, jointed ? 1e-9 : 0.0) << id;
    }
  }
}

TEST_F(RecordingTest, ExistingFilesAreKept) {
  Session session(scenario(ball_on_floor(2, {0.3, 0, 0}, 0.7)), options("ode"));
  advance_to(session, 0.2);
  const fs::path wanted = folder_ / "what.toml";
  EXPECT_EQ(save_recording(session.recorder(), session.scenario(), wanted), wanted);
  EXPECT_EQ(save_recording(session.recorder(), session.scenario(), wanted), folder_ / "what-2.toml");
  EXPECT_TRUE(fs::exists(folder_ / "what-2.json"));
  EXPECT_THROW(save_recording(session.recorder(), session.scenario(), folder_ / "no" / "folder.toml"),
               core::InputError);
}

// Neither through a link that leads nowhere, nor over the motion of another scenario.
TEST_F(RecordingTest, LinksAndDataAreKept) {
  Session session(scenario(ball_on_floor(2, {0.3, 0, 0}, 0.7)), options("ode"));
  advance_to(session, 0.2);
  fs::create_symlink("elsewhere", folder_ / "what.toml");
  fs::create_symlink("elsewhere", folder_ / "what-2.json");
  EXPECT_EQ(save_recording(session.recorder(), session.scenario(), folder_ / "what.toml"),
            folder_ / "what-3.toml");
  EXPECT_FALSE(fs::exists(folder_ / "elsewhere"));
}

// Memory is bounded: of a long run every other sample goes, again and again, and the end is always there.
TEST_F(RecordingTest, LongRunIsThinned) {
  core::Scene scene;
  for (int i = 0; i < 400; ++i)
    scene.bodies.push_back(process::point("b" + std::to_string(i), {1.5 * i, 0, 0}, {0, 1, 0}));
  Session session(scenario(scene), options("in-house", "rk4"));
  advance_to(session, 0.01);
  for (int i = 0; i < 500; ++i) {
    session.apply(StepOnce{});
    session.advance(0);
  }
  const Recorder& recorder = session.recorder();
  EXPECT_EQ(recorder.last_step(), 501);
  EXPECT_LE(recorder.states().size() * 400, Recorder::most + 400);
  EXPECT_GE(recorder.states().size(), 40u);
  EXPECT_EQ(recorder.steps().front(), 0);
  EXPECT_GE(recorder.steps().back(), 480);
}

// On reset and at the end; nothing where nothing moved.
TEST_F(RecordingTest, TheHostSavesOnResetAndAtTheEnd) {
  std::vector<std::string> said;
  SessionOptions settings = options("ode");
  settings.playing = false;
  {
    Host host(std::make_unique<Session>(scenario(ball_on_floor(2, {0.3, 0, 0}, 0.7)), settings),
              folder_ / "r.toml", [&](const std::string& line) { said.push_back(line); });
    host.command(R"({"do": "reset"})");
    EXPECT_TRUE(said.empty());
    const std::uint64_t before = host.states();
    host.command(R"({"do": "play"})");
    while (host.states() < before + 20) std::this_thread::yield();
    host.command(R"({"do": "reset"})");
    EXPECT_EQ(said.size(), 1u);
    while (host.states() < before + 40) std::this_thread::yield();
    host.stop();
  }
  ASSERT_EQ(said.size(), 2u);
  EXPECT_EQ(said[1], "recorded " + (folder_ / "r-2.toml").string());
  EXPECT_EQ(scenario::load(folder_ / "r-2.toml").claims.size(), 2u);
}

}  // namespace
}  // namespace cylon::view
