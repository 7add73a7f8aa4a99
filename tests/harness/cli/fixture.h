// Runs the real binary in a folder of its own and keeps what it printed.
#pragma once

#include "tests/paths.h"
#include "tests/temporary_folder.h"

#include <gtest/gtest.h>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

namespace cylon::cli {

struct Ran {
  int code = -1;  ///< Exit code; 128 + signal where one killed it.
  std::string out, err;
};

class CommandLine : public testing::Test {
 protected:
  // A key that the test may lose; of the bytes of all tests' key, so that what one has certified the others take.
  CommandLine() {
    std::filesystem::copy_file(std::filesystem::path(binary_dir) / "tests_key", folder / ".key");
  }
  void write(const std::string& file, const std::string& text) const {
    std::ofstream(folder / file, std::ios::binary) << text;
  }
  std::string read(const std::filesystem::path& file) const {
    std::ostringstream text;
    text << std::ifstream(file.is_absolute() ? file : folder / file).rdbuf();
    return text.str();
  }
  std::string shipped(const std::string& name) const {
    return read(std::filesystem::path(source_dir) / "scenarios" / (name + ".toml"));
  }

  /// A shell line in the folder, with `cylon` in PATH and no terminal; `signal` as soon as `interrupt_when`
  /// says.
  Ran shell(const std::string& line, const std::function<bool()>& interrupt_when = {},
            int signal = SIGINT) const {
    const std::string script = "cd '" + folder.string() +
                               "' || exit 99; unset GTEST_SHARD_INDEX GTEST_TOTAL_SHARDS TEST_SHARD_INDEX "
                               "TEST_TOTAL_SHARDS ${!SLURM_ARRAY_TASK_*}; "
                               "export CYLON_KEY=\"$PWD/.key\" PATH='" +
                               std::string(binary_dir) + "':\"$PATH\"; " + line;
    const std::string out = (folder / ".out").string(), err = (folder / ".err").string();
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_addopen(&actions, 0, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, 1, out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    posix_spawn_file_actions_addopen(&actions, 2, err.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
    const char* argv[] = {"bash", "-c", script.c_str(), nullptr};
    pid_t pid = -1;
    char* const* const words = const_cast<char**>(argv);  // NOLINT(*-const-cast): POSIX says only read
    EXPECT_EQ(posix_spawnp(&pid, "bash", &actions, nullptr, words, environ), 0);
    posix_spawn_file_actions_destroy(&actions);
    int status = 0;
    bool ended = false;
    while (interrupt_when && !interrupt_when() && !(ended = ::waitpid(pid, &status, WNOHANG) == pid))
      std::this_thread::sleep_for(std::chrono::milliseconds(5));
    if (interrupt_when && !ended) ::kill(pid, signal);
    if (!ended) ::waitpid(pid, &status, 0);
    return {WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status), read(out), read(err)};
  }

  Ran cylon(const std::string& arguments) const { return shell("exec cylon " + arguments); }

  const TemporaryFolder own_;
  const std::filesystem::path folder = own_.path();
};

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

}  // namespace cylon::cli
