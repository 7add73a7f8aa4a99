// In the sandbox a worker computes as ever, and sees and touches nothing else; the same worker without it
// does.
#include "harness/process/sandbox.h"

#include "tests/harness/process/fixture.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <arpa/inet.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

namespace cylon::process {
namespace {

const Limits limits = {30, 30, std::size_t{1} << 30};

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v bwrap >/dev/null") != 0) GTEST_SKIP() << "bubblewrap is not installed";
    std::ofstream(folder_ / "secret") << "x";
    ::setenv("SPY_SECRET", "x", 1);
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    ASSERT_EQ(::listen(socket_, 4), 0);
    ASSERT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    port_ = std::to_string(ntohs(address.sin_port));
  }
  void TearDown() override {
    sandboxing() = false;
    hidden_in_sandboxes().clear();
    std::filesystem::remove("written_by_worker");
    if (socket_ >= 0) ::close(socket_);
  }

  // A worker that says what it can see and do.  The sandbox passes little of the environment on, a command all.
  EngineChoice spy(const std::string& files) const {
    EngineChoice choice = scripted("spies_in_load");
    const std::vector<std::string> words = {"env", "SPY_FILES=" + files, "SPY_PORT=" + port_};
    choice.row.command.insert(choice.row.command.begin(), words.begin(), words.end());
    return choice;
  }

  // What a worker in a sandbox finds that has a file of the folder in its command, and so sees the folder.
  std::string found(const std::string& beside, const std::string& files) const {
    EngineChoice choice = spy(files);
    choice.row.command.push_back(beside);
    const core::Scene scene = two_bodies();
    const RunOutcome outcome = run(choice, request_of(scene, 100, 10), limits);
    EXPECT_EQ(outcome.status, results::Status::pass) << outcome.reason;
    return outcome.stderr_tail;
  }

  const TemporaryFolder own_;
  const std::filesystem::path& folder_ = own_.path();
  std::string port_;
  int socket_ = -1;
};

TEST_F(Sandbox, HidesFilesNetworkAndProcesses) {
  const core::Scene scene = two_bodies();
  const RunOutcome open = run(spy(folder_ / "secret"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(open.status, results::Status::pass) << open.reason;
  for (const char* found : {"reads ", "knows", "writes written_by_worker", "connects"})
    EXPECT_NE(open.stderr_tail.find(found), std::string::npos) << found << open.stderr_tail;

  require_sandbox();
  sandboxing() = true;
  const RunOutcome closed = run(spy(folder_ / "secret"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(closed.status, results::Status::pass) << closed.reason << closed.stderr_tail;
  EXPECT_NE(closed.stderr_tail.find("found: \n"), std::string::npos) << closed.stderr_tail;
  for (std::size_t i = 0; i < open.recording->states.size(); ++i)
    EXPECT_EQ(closed.recording->states[i][1].position, open.recording->states[i][1].position);
}

// The process that the harness starts is bubblewrap, which does nothing; the engine has a group of its own.
TEST_F(Sandbox, BelievesTheTimesOfWhoTellsThemRight) {
  sandboxing() = true;
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 100, 10);
  EXPECT_EQ(run(scripted("boasts"), request, limits).status, results::Status::protocol);
  request.repetitions = 2;
  const RunOutcome outcome = run(scripted("works"), request, limits);
  EXPECT_EQ(outcome.status, results::Status::pass) << outcome.reason;
  EXPECT_EQ(run(scripted("hides"), request, limits).status, results::Status::protocol);
  // Runs that are shorter than the requests for them.
  request.repetitions = 50;
  const RunOutcome brief = run(scripted("good"), request, limits);
  EXPECT_EQ(brief.status, results::Status::pass) << brief.reason;
}

TEST_F(Sandbox, HidesAKeyBesideTheEngine) {
  const std::filesystem::path file = std::filesystem::canonical(folder_) / "secret";
  sandboxing() = true;
  EXPECT_EQ(found(file, file), "found: reads " + file.string() + "\n");  // the folder is seen
  hidden_in_sandboxes() = {file};
  EXPECT_EQ(found(file, file), "found: \n");
  EXPECT_EQ(found(file.parent_path() / "../" / file.parent_path().filename() / "secret", file), "found: \n");
}

TEST_F(Sandbox, HidesTheFolderOfTheKeyThroughLinks) {
  const std::filesystem::path real = std::filesystem::canonical(folder_) / "home";
  const std::filesystem::path link = real.parent_path() / "link";
  std::filesystem::create_directories(real / ".config/cylon");
  for (const char* name : {"engine", ".config/cylon/key"}) std::ofstream(real / name) << "x";
  std::filesystem::create_symlink(real, link);
  const std::string key = ".config/cylon/key", seen = (real / key).string() + ":" + (link / key).string();
  sandboxing() = true;
  EXPECT_NE(found(link / "engine", seen), "found: \n");
  // The file within the folder is hidden with it.
  hidden_in_sandboxes() = {real / ".config/cylon", real / key};
  EXPECT_EQ(found(link / "engine", seen), "found: \n");
  EXPECT_EQ(found(real / "engine", seen), "found: \n");
  EXPECT_EQ(found(link / "engine", (link / "engine").string()),
            "found: reads " + (link / "engine").string() + "\n");
}

TEST_F(Sandbox, LeavesNoProcessAndKeepsVerdicts) {
  sandboxing() = true;
  const core::Scene scene = two_bodies();
  RunOutcome outcome = run(scripted("stray_in_run"), request_of(scene, 100, 10), limits);
  EXPECT_EQ(results::name(outcome.status), "crash") << outcome.reason;
  outcome =
      run(scripted("family_memory_in_load"), request_of(scene, 100, 10), {30, 30, std::size_t{200} << 20});
  EXPECT_EQ(results::name(outcome.status), "crash") << outcome.reason;
  EXPECT_NE(outcome.reason.find("memory limit"), std::string::npos) << outcome.reason;
  outcome =
      run(scripted("file_memory_in_load"), request_of(scene, 100, 10), {30, 30, std::size_t{200} << 20});
  EXPECT_EQ(results::name(outcome.status), "crash") << outcome.reason;
  outcome = run(scripted("loop_in_run"), request_of(scene, 100, 10), {30, 2, 0});
  EXPECT_EQ(results::name(outcome.status), "timeout") << outcome.reason;
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace cylon::process
