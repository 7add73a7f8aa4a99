#include "harness/tracking/baseline.h"

#include "harness/cli/command_line.h"
#include "harness/cli/folders.h"
#include "harness/core/input_error.h"
#include "harness/process/child.h"

#include <fmt/format.h>

#include <sys/wait.h>

#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <iterator>
#include <set>

namespace cylon::tracking {

using namespace cli;  // commands are written in the words of the command line

namespace {

namespace fs = std::filesystem;

constexpr const char* worker_prefix = "cylon-worker-";

/// Runs a command with its output added to a file; whether it succeeded.  Throws process::Interrupted.
bool run_logged(const std::vector<std::string>& command, const fs::path& log) {
  const std::string line = shell_command(command) + " >>" + shell_word(log.string()) + " 2>&1 </dev/null";
  const int status = std::system(line.c_str());
  const bool stopped = (WIFSIGNALED(status) && WTERMSIG(status) == SIGINT) ||
                       (WIFEXITED(status) && WEXITSTATUS(status) == 128 + SIGINT);
  if (stopped || process::interrupted()) throw process::Interrupted();
  return WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

/// The first line that a command prints; "" where it fails.
std::string first_line_of(const std::vector<std::string>& command) {
  try {
    process::Child child(command, 0);
    child.set_deadline(30, command.front());
    while (child.receive()) {
    }
    const std::string text(child.output());
    return text.substr(0, text.find('\n'));
  } catch (const process::Failure&) {
    return "";
  }
}

/// Whether the build failed because the revision has no such program, in Ninja's words or Make's.
bool is_unknown_target(const fs::path& log, const std::string& target) {
  std::ifstream in(log);
  const std::string text{std::istreambuf_iterator<char>(in), {}};
  return text.find(fmt::format("unknown target '{}'", target)) != std::string::npos ||
         text.find(fmt::format("No rule to make target '{}'", target)) != std::string::npos;
}

fs::path sources(const Context& context) { return fs::absolute(context.scenarios / "..").lexically_normal(); }

/// A worktree of that revision, made where it is missing or was left half done.
void check_out(const Context& context, const std::string& word, const std::string& sha, const fs::path& tree,
               const fs::path& log) {
  if (first_line_of({"git", "-C", tree.string(), "rev-parse", "HEAD"}) == sha &&
      fs::exists(tree / "CMakeLists.txt"))
    return;
  const std::string repository = sources(context).string();
  std::cerr << fmt::format("checking out {} in {}\n", plain(word), tree.string());
  fs::remove_all(tree);
  run_logged({"git", "-C", repository, "worktree", "prune"}, log);
  if (!run_logged({"git", "-C", repository, "worktree", "add", "--detach", "--force", tree.string(), sha},
                  log))
    throw core::InputError(fmt::format("--baseline {}: cannot be checked out, see {}", word, log.string()));
}

}  // namespace

study::Side side_of_folder(const std::string& name, const fs::path& folder) {
  return {name, process::default_engines(folder)};
}

std::optional<fs::path> worker_folder(const std::string& word) {
  std::error_code ignored;
  if (fs::is_regular_file(word, ignored)) return folders_of(fs::absolute(word)).workers;
  if (!fs::is_directory(word, ignored)) return std::nullopt;
  const fs::path workers = workers_below(word);
  if (workers.empty())
    throw core::InputError(
        fmt::format("--baseline {}: there is no cylon-worker-* in this folder or its libexec/cylon", word));
  return workers;
}

std::optional<std::string> revision_of(const Context& context, const std::string& word) {
  if (word.empty() || word.starts_with('-')) return std::nullopt;
  // An installation may lie inside a repository of somebody else, whose revisions are not ours to build.
  if (!fs::exists(sources(context) / "CMakePresets.json")) return std::nullopt;
  const std::string sha = first_line_of(
      {"git", "-C", sources(context).string(), "rev-parse", "--verify", "--quiet", word + "^{commit}"});
  return sha.empty() ? std::nullopt : std::optional(sha);
}

study::Side side_of_revision(const Context& context, const std::string& word, const std::string& sha,
                             const std::vector<study::Cell>& cells) {
  const fs::path root = fs::absolute(".cylon/baselines"), tree = root / sha,
                 build = tree / "build" / "release";
  const fs::path log = root / (sha + ".log");
  fs::create_directories(root);
  std::ofstream(log, std::ios::trunc).flush();  // what an earlier build said
  check_out(context, word, sha, tree, log);
  // Found again by ccache whatever folder it lies in.
  ::setenv("CCACHE_BASEDIR", tree.c_str(), 1);
  ::setenv("CCACHE_NOHASHDIR", "1", 1);
  std::cerr << fmt::format("building {} ({}); log: {}\n", plain(word), sha.substr(0, 12), log.string());
  const auto refuse = [&](const std::string& what) {
    return core::InputError(fmt::format("--baseline {}: {}, see {}", word, what, log.string()));
  };
  if (!run_logged({"cmake", "--preset", "release", "-S", tree.string(), "-B", build.string()}, log))
    throw refuse("cannot be configured");
  std::set<std::string> wanted;
  for (const study::Cell& cell : cells)
    if (!cell.engine.row.command.empty()) wanted.insert(fs::path(cell.engine.row.command.front()).filename());
  for (const std::string& worker : wanted)
    if (worker.starts_with(worker_prefix) &&
        !run_logged({"cmake", "--build", build.string(), "--target", worker}, log) &&
        !is_unknown_target(log, worker))
      throw refuse(worker + " cannot be built");
  return side_of_folder(fmt::format("{} = {}", word, sha.substr(0, 12)), build);
}

}  // namespace cylon::tracking
