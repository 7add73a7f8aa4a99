// A worker: the one engine build that is linked here, behind the protocol.
#include "harness/core/simulator.h"
#include "harness/process/worker_loop.h"

#include <unistd.h>

#include <cstdio>
#include <memory>

int main() {
  // The protocol keeps the real stdout; whatever the engine prints goes to stderr, line by line.
  const int out = dup(STDOUT_FILENO);
  if (out < 0 || dup2(STDERR_FILENO, STDOUT_FILENO) < 0) return 1;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::unique_ptr<cylon::core::Simulator> simulator = cylon::core::make_simulator();
  return cylon::process::serve(*simulator, STDIN_FILENO, out);
}
