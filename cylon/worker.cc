#include "cylon/worker.h"

#include "harness/process/worker_loop.h"

#include <unistd.h>

#include <cstdio>

namespace cylon::worker {

int run(std::unique_ptr<core::Simulator> (*make)(), const Layout& layout) {
  if (layout != layout_here) {
    std::fputs(
        "cylon: the engine and the library lay out a scene in two ways: compile the engine's sources that "
        "include "
        "cylon/worker.h with what the target cylon::simulator sets, and without _GLIBCXX_DEBUG\n",
        stderr);
    return 2;
  }
  // The protocol keeps the real stdout; whatever the engine prints goes to stderr, line by line.
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::unique_ptr<core::Simulator> simulator = make();
  return process::serve(*simulator, STDIN_FILENO, out);
}

}  // namespace cylon::worker
