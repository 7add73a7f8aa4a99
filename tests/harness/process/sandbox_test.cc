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

namespace cylon::process {
namespace {

const Limits limits = {30, 30, std::size_t{1} << 30};

class Sandbox : public testing::Test {
 protected:
  void SetUp() override {
    if (std::system("command -v bwrap >/dev/null") != 0) GTEST_SKIP() << "bubblewrap is not installed";
    std::ofstream(folder_ / "secret") << "x";
    ::setenv("SPY_FILE", (folder_ / "secret").c_str(), 1);
    socket_ = ::socket(AF_INET, SOCK_STREAM, 0);
    sockaddr_in address = {};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    socklen_t size = sizeof address;
    ASSERT_EQ(::bind(socket_, reinterpret_cast<const sockaddr*>(&address), size), 0);
    ASSERT_EQ(::listen(socket_, 4), 0);
    ASSERT_EQ(::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size), 0);
    ::setenv("SPY_PORT", std::to_string(ntohs(address.sin_port)).c_str(), 1);
  }
  void TearDown() override {
    sandboxing() = false;
    std::filesystem::remove("written_by_worker");
    if (socket_ >= 0) ::close(socket_);
  }

  const TemporaryFolder own_;
  const std::filesystem::path& folder_ = own_.path();
  int socket_ = -1;
};

TEST_F(Sandbox, HidesFilesNetworkAndProcesses) {
  const core::Scene scene = two_bodies();
  const RunOutcome open = run(scripted("spies_in_load"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(open.status, results::Status::pass) << open.reason;
  for (const char* found : {"reads ", "writes written_by_worker", "connects"})
    EXPECT_NE(open.stderr_tail.find(found), std::string::npos) << found << open.stderr_tail;

  require_sandbox();
  sandboxing() = true;
  const RunOutcome closed = run(scripted("spies_in_load"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(closed.status, results::Status::pass) << closed.reason << closed.stderr_tail;
  EXPECT_NE(closed.stderr_tail.find("found: \n"), std::string::npos) << closed.stderr_tail;
  for (std::size_t i = 0; i < open.recording->states.size(); ++i)
    EXPECT_EQ(closed.recording->states[i][1].position, open.recording->states[i][1].position);
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
  outcome = run(scripted("loop_in_run"), request_of(scene, 100, 10), {30, 2, 0});
  EXPECT_EQ(results::name(outcome.status), "timeout") << outcome.reason;
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace cylon::process
