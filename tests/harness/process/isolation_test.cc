// For every fault of a worker, the harness reports the fault and leaves no process behind.  That it does so in time
// needs no clock: a fault that is seen only at the deadline is a timeout, and so another verdict.
#include "harness/core/input_error.h"
#include "tests/harness/process/fixture.h"

#include <gtest/gtest.h>

#include <dirent.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

namespace cylon::process {
namespace {

using results::Status;

// Longer than any machine under load takes; only what is to run into a deadline gets a short one.
const Limits limits = {300, 300, std::size_t{200} << 20};

struct Misdeed {
  const char* mode;
  Status status;
  const char* reason;  // must occur in it
};

void PrintTo(const Misdeed& misdeed, std::ostream* out) { *out << misdeed.mode; }

class Isolation : public testing::TestWithParam<Misdeed> {};

// Processes that run the script in this mode, orphans included.
int running(const std::string& mode) {
  int count = 0;
  DIR* proc = opendir("/proc");
  while (const dirent* entry = readdir(proc)) {
    std::ifstream file(std::string("/proc/") + entry->d_name + "/cmdline");
    std::ostringstream read;
    read << file.rdbuf();  // of a process that ends meanwhile nothing; an iterator would throw
    const std::string line = read.str();
    if (line.find("scripted_worker.py") != std::string::npos && line.ends_with('\0' + mode + '\0')) ++count;
  }
  closedir(proc);
  return count;
}

TEST_P(Isolation, IsAVerdict) {
  const Misdeed& misdeed = GetParam();
  const core::Scene scene = two_bodies();
  Limits these = limits;
  const std::string expected = misdeed.reason;
  if (misdeed.status == Status::timeout)
    (expected.find("hello") != std::string::npos ? these.hello_seconds : these.run_seconds) = 2;
  const RunOutcome outcome = run(scripted(misdeed.mode), request_of(scene, 100, 10), these);
  EXPECT_EQ(results::name(outcome.status), results::name(misdeed.status)) << outcome.reason;
  EXPECT_NE(outcome.reason.find(misdeed.reason), std::string::npos) << outcome.reason;
  EXPECT_FALSE(outcome.recording.has_value());
  EXPECT_LE(outcome.stderr_tail.size(), 4096u);
  EXPECT_FALSE(has_children());
  // A killed orphan goes when it next gets a processor; one that was not killed stays until the test's own limit.
  while (running(misdeed.mode) > 0) std::this_thread::sleep_for(std::chrono::milliseconds(20));
}

constexpr Misdeed misdeeds[] = {
    {"abort_in_hello", Status::crash, "killed by SIGABRT: Assertion 'mass > 0' failed"},
    {"abort_in_load", Status::crash, "killed by SIGABRT: Assertion 'mass > 0' failed"},
    {"abort_in_run", Status::crash, "killed by SIGABRT: Assertion 'mass > 0' failed"},
    {"exit_0_in_hello", Status::crash, "exited 0 before done"},
    {"exit_0_in_run", Status::crash, "exited 0 before done"},
    {"exit_7_in_load", Status::crash, "exited 7 before done"},
    {"error_in_run", Status::crash, "stopped after step 50: Jacobian is singular"},
    {"orphan_in_run", Status::crash, "exited 3 before done"},
    {"stray_in_load", Status::crash, "exited 3 before done"},
    {"stray_in_run", Status::crash, "exited 3 before done"},
    {"regroups_in_run", Status::timeout, "'run' did not end within 2 s"},
    {"family_memory_in_load", Status::crash, "memory limit"},
    {"file_memory_in_load", Status::crash, "memory limit"},
    {"loop_in_hello", Status::timeout, "'hello' did not end within 2 s"},
    {"loop_in_load", Status::timeout, "'load' did not end within 2 s"},
    {"loop_in_run", Status::timeout, "'run' did not end within 2 s"},
    {"ignore_terminate_in_run", Status::timeout, "within 2 s"},
    {"slow_hello", Status::timeout, "'hello' did not end within 2 s"},
    {"garbage_in_hello", Status::protocol, "neither a JSON line nor a frame: 'Warning: friction too high'"},
    {"garbage_in_run", Status::protocol, "neither a JSON line nor a frame: 'Warning: friction too high'"},
    {"not_json_in_hello", Status::protocol, "not JSON at byte 2"},
    {"close_stdout_in_run", Status::protocol, "closed its output before the end and kept running"},
    {"huge_line_in_hello", Status::protocol, "a line of more than 16 MiB"},
    {"huge_line_in_run", Status::protocol, "a line of more than 16 MiB"},
    {"deep_line_in_hello", Status::protocol, "nested more than 64 deep at byte"},
    {"deep_line_in_load", Status::protocol, "nested more than 64 deep at byte"},
    {"deep_line_in_run", Status::protocol, "nested more than 64 deep at byte"},
    {"memory_in_load", Status::crash, "emory"},
    {"bad_magic", Status::protocol, "neither a JSON line nor a frame: 'CYLG"},
    {"wrong_bodies", Status::protocol,
     "a frame of 312 bytes for 1 states of 2 bodies, where 208 are expected"},
    {"wrong_count", Status::protocol, "a frame of 208 bytes for 1000 states"},
    {"torn_frame", Status::crash, "exited 0 before done"},
    {"garbage_in_frame", Status::protocol, ""},
    {"backward", Status::protocol, "a state of step 58 where step 60 was expected"},
    {"unwatched_event", Status::protocol, "an event of a pair that was not to be watched"},
    {"long_version", Status::protocol, "version: longer than 4096 bytes"},
    {"miscounts", Status::protocol, "10 frames came, 11 were announced"},
    {"boasts", Status::protocol, "step_ns: 5 s of CPU time for the steps, but its processes used"},
    {"misspells", Status::protocol, "step_ns: missing"},
    {"protocol_2", Status::protocol, "protocol: this harness speaks 1, the worker 2"},
    {"wrong_start", Status::fail, "initial state read back differs: body 'a' position"},
    {"long_quaternion", Status::fail, "step 60: the orientation of body 'a' has length 1.5, which must be 1"},
    {"unsupported", Status::unsupported, "no bodies at all"},
};
INSTANTIATE_TEST_SUITE_P(Process, Isolation, testing::ValuesIn(misdeeds),
                         [](const auto& misdeed) { return std::string(misdeed.param.mode); });

TEST(IsolationAlone, ChatterOnStderrNeitherBlocksNorGrows) {
  const core::Scene scene = two_bodies();
  const RunOutcome outcome = run(scripted("chatter_in_run"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  EXPECT_TRUE(outcome.stderr_tail.starts_with("solver complains\n"));  // from the start of a line
  EXPECT_TRUE(outcome.stderr_tail.ends_with("last complaint\n"));
  EXPECT_LE(outcome.stderr_tail.size(), 4096u);
  EXPECT_EQ(outcome.recording->complaints, outcome.stderr_tail);
}

// Where times are measured, nothing but steps is done: who tells less than half of what was used hides it.
TEST(IsolationAlone, TimesThatHideWorkAreRefused) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 100, 10);
  EXPECT_EQ(run(scripted("hides"), request, limits).status, Status::pass) << "recording costs what it costs";
  request.repetitions = 1;
  const RunOutcome outcome = run(scripted("hides"), request, limits);
  EXPECT_EQ(outcome.status, Status::protocol);
  EXPECT_NE(outcome.reason.find("step_ns: 0.0001 s of CPU time for the steps, but its processes used"),
            std::string::npos)
      << outcome.reason;
  EXPECT_EQ(run(scripted("good"), request, limits).status, Status::pass);
}

// Runs of two milliseconds, of which a tenth is told: too short for the ticks of the kernel.
TEST(IsolationAlone, ShortRunsThatHideWorkAreRefused) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 100, 10);
  request.repetitions = 5;
  const RunOutcome outcome = run(scripted("shaves"), request, limits);
  EXPECT_EQ(outcome.status, Status::protocol);
  EXPECT_NE(outcome.reason.find("more than a run of one step uses"), std::string::npos) << outcome.reason;
  EXPECT_EQ(run(scripted("good"), request, limits).status, Status::pass);
}

// The process that the harness starts is a shell, which does next to nothing.
EngineChoice behind_shell(EngineChoice choice) {
  std::string line;
  for (const std::string& word : choice.row.command) line += "'" + word + "' ";
  choice.row.command = {"sh", "-c", line + "; exit 0"};
  return choice;
}

TEST(IsolationAlone, WorkHiddenBehindAShellIsRefused) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 100, 10);
  request.repetitions = 2;
  const RunOutcome outcome = run(behind_shell(scripted("hides")), request, limits);
  EXPECT_EQ(outcome.status, Status::protocol);
  EXPECT_NE(outcome.reason.find("but its processes used"), std::string::npos) << outcome.reason;
  const RunOutcome good = run(behind_shell(scripted("good")), request, limits);
  EXPECT_EQ(good.status, Status::pass) << good.reason;
}

// A run of 0.2 s that tells them is confirmed.  One of 10 us is not, beside which a request costs more; nor one that hides its
// work, nor one of a process that another one works for.  All of them pass.
TEST(IsolationAlone, CostsThatTheProcessDoesNotConfirmAreNotVerified) {
  const core::Scene scene = two_bodies();
  const auto verified = [&](const EngineChoice& choice) {
    const RunOutcome outcome = run(choice, request_of(scene, 10), limits);
    EXPECT_EQ(outcome.status, Status::pass) << outcome.reason;
    return outcome.recording && outcome.recording->cpu_verified;
  };
  EXPECT_TRUE(verified(scripted("works")));
  EXPECT_FALSE(verified(scripted("good")));
  EXPECT_FALSE(verified(scripted("hides")));
  EXPECT_FALSE(verified(behind_shell(scripted("works"))));
}

TEST(IsolationAlone, NumbersThatAreNotFiniteAreAResult) {
  const core::Scene scene = two_bodies();
  const RunOutcome outcome = run(scripted("nan"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(outcome.status, Status::pass) << outcome.reason;
  const core::Vector3& x = outcome.recording->states.back()[1].position;
  EXPECT_TRUE(std::isnan(x.x()) && std::isinf(x.y()));
  EXPECT_TRUE(outcome.recording->states[5][1].position.allFinite());
}

TEST(IsolationAlone, AWorkerThatMisbehavesAfterTheRunHasRunAllTheSame) {
  const core::Scene scene = two_bodies();
  const RunOutcome crashed = run(scripted("crash_at_quit"), request_of(scene, 100, 10), limits);
  ASSERT_EQ(crashed.status, Status::pass) << crashed.reason;
  EXPECT_EQ(crashed.stderr_tail, "killed by SIGSEGV after the run\n");
  EXPECT_EQ(run(scripted("stay_at_quit"), request_of(scene, 100, 10), limits).status, Status::pass);
  EXPECT_FALSE(has_children());
}

TEST(IsolationAlone, AWorkerThatCannotStartIsUnsupported) {
  const core::Scene scene = two_bodies();
  const auto outcome_of = [&](std::vector<std::string> command) {
    return run({"x", {"x", std::move(command), ""}, "", "", {}}, request_of(scene, 1), limits);
  };
  RunOutcome outcome = outcome_of({"/no/such/worker"});
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_EQ(outcome.reason, "cannot start '/no/such/worker': No such file or directory");
  outcome = outcome_of({"/usr/bin/env", "no-such-interpreter", "worker.js"});
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_NE(outcome.reason.find("no-such-interpreter"), std::string::npos) << outcome.reason;
  outcome = outcome_of({"/dev/null"});
  EXPECT_EQ(outcome.status, Status::unsupported);
  EXPECT_EQ(outcome.reason, "cannot start '/dev/null': Permission denied");
  EXPECT_EQ(outcome_of({}).status, Status::unsupported);
  EXPECT_FALSE(has_children());
}

TEST(IsolationAlone, FloodsOfEventsAndStatesAreRefused) {
  const core::Scene scene = two_bodies();
  RunRequest request = request_of(scene, 100, 10);
  request.watch = {{0, 1, -1}};
  const RunOutcome outcome = run(scripted("event_flood"), request, {300, 300, std::size_t{1} << 30});
  EXPECT_EQ(results::name(outcome.status), "protocol");
  EXPECT_EQ(outcome.reason, "more than 1000000 events");
  EXPECT_THROW(run(scripted("good"), request_of(scene, 9'000'000'000'000'000, 1), limits), core::InputError);
}

TEST(IsolationAlone, InterruptionEndsARunAtOnce) {
  const core::Scene scene = two_bodies();
  std::thread later([] {
    std::this_thread::sleep_for(std::chrono::milliseconds(300));
    interrupted() = true;
  });
  EXPECT_THROW(run(scripted("loop_in_hello"), request_of(scene, 100), {300, 300, 0}), Interrupted);
  later.join();
  interrupted() = false;
  EXPECT_FALSE(has_children());
}

int open_descriptors() {
  int count = 0;
  DIR* fds = opendir("/proc/self/fd");
  while (readdir(fds)) ++count;
  closedir(fds);
  return count;
}

TEST(IsolationAlone, ManyThreadsRunAtOnceAndNoDescriptorLeaks) {
  const core::Scene scene = two_bodies();
  run(scripted("good"), request_of(scene, 1), limits);  // what opens once, is open now
  const int before = open_descriptors();
  std::vector<std::thread> threads;
  std::vector<int> passed(8);
  for (std::size_t i = 0; i < passed.size(); ++i)
    threads.emplace_back([&, i] {
      const bool good = i % 2 == 0;
      const RunOutcome outcome = run(scripted(good ? "good" : "abort_in_run"), request_of(scene, 100),
                                     {30, 30, std::size_t{1} << 30});
      passed[i] = outcome.status == (good ? Status::pass : Status::crash);
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(passed, std::vector<int>(8, 1));
  EXPECT_EQ(open_descriptors(), before);
  EXPECT_FALSE(has_children());
}

}  // namespace
}  // namespace cylon::process
