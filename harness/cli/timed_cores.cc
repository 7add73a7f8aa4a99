#include "harness/cli/timed_cores.h"

#include "harness/cli/cores.h"
#include "harness/cli/patience.h"

#include <fmt/format.h>

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <filesystem>
#include <iostream>
#include <string>
#include <system_error>

namespace cylon::cli {
namespace {

// First as it is: of a file of somebody else in a folder of all, O_CREAT may be refused.
int opened(const std::string& file) {
  constexpr int how = O_RDONLY | O_CLOEXEC | O_NOFOLLOW;
  const int fd = ::open(file.c_str(), how);
  return fd >= 0 ? fd : ::open(file.c_str(), how | O_CREAT, 0644);
}

void wait_for(int fd) {
  while (::flock(fd, LOCK_EX) != 0 && errno == EINTR) {
  }
}

constexpr const char* advice = "give each process a core of its own (taskset, srun --cpu-bind=cores)";

}  // namespace

// In the order of the cores, so that of two who wait one has all.
TimedCores::TimedCores(Taken taken) {
  std::error_code error;
  const std::filesystem::path folder = std::filesystem::temp_directory_path(error);
  if (error) return;
  const Cores own = own_cores();
  bool said = false;
  for (const int core : own.cores) {
    const int fd = opened((folder / fmt::format("cylon-core-{}-{}.lock", own.host, core)).string());
    if (fd < 0) continue;
    files_.push_back(fd);
    // Where the file system has no locks there is none to wait for.
    if (locks_in_a_moment([&] { return ::flock(fd, LOCK_EX | LOCK_NB) == 0 || errno != EWOULDBLOCK; }))
      continue;
    if (!said)
      std::cerr << fmt::format(
                       "another cylon measures times on core {} of {}: {}; {}\n", core, own.host,
                       taken == Taken::wait ? "this one waits for its end" : "times are those of two at once",
                       advice)
                << std::flush;
    said = true;
    if (taken == Taken::warn) return;
    wait_for(fd);
  }
}

TimedCores::~TimedCores() {
  for (const int fd : files_) ::close(fd);
}

}  // namespace cylon::cli
