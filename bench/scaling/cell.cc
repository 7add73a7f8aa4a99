// One cell of scaling_bench: the engine build that is linked here on one kind of scene of one size.
//   scaling-cell-BUILD KIND BODIES SECONDS PATH INTEGRATOR [KEY=VALUE…]
// prints: ns of thread CPU time per body and step, the error, the contacts, resident bytes that the engine
// takes per body.  The kernel ends it at SECONDS of CPU time.  A path or an integrator of "-" is the
// engine's own.
#include "bench/cpu_time.h"
#include "bench/scaling/kinds.h"
#include "harness/core/simulator.h"

#include <fmt/format.h>
#include <malloc.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>
#include <vector>

namespace {

using namespace cylon;

double resident_bytes() {
  long size = 0, pages = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(f, "%ld %ld", &size, &pages) != 2) pages = 0;
    std::fclose(f);
  }
  return static_cast<double>(pages) * static_cast<double>(sysconf(_SC_PAGESIZE));
}

const bench::scaling::Kind& kind_of(const std::string& name) {
  for (const bench::scaling::Kind& kind : bench::scaling::kinds())
    if (kind.name == name) return kind;
  throw std::invalid_argument(fmt::format("no kind '{}'", name));
}

core::Setup setup_of(const std::vector<std::string>& arguments) {
  core::Setup setup;
  setup.dt = bench::scaling::dt;
  if (arguments[3] != "-") setup.path = arguments[3];
  if (arguments[4] != "-") setup.integrator = arguments[4];
  for (std::size_t i = 5; i < arguments.size(); ++i) {
    const std::size_t equals = arguments[i].find('=');
    setup.options[arguments[i].substr(0, equals)] = arguments[i].substr(equals + 1);
  }
  return setup;
}

int measure(const std::vector<std::string>& arguments) {
  const bench::scaling::Kind& kind = kind_of(arguments[0]);
  const std::int64_t bodies = std::stoll(arguments[1]);
  const rlim_t seconds = std::stoul(arguments[2]);
  const rlimit limit{seconds, seconds + 2};  // SIGXCPU, then SIGKILL
  setrlimit(RLIMIT_CPU, &limit);
  // The engine may print; the numbers have the real stdout for themselves.
  std::FILE* out = fdopen(dup(STDOUT_FILENO), "w");
  dup2(STDERR_FILENO, STDOUT_FILENO);

  const core::Setup setup = setup_of(arguments);
  const core::Scene scene = kind.scene(bodies);
  const std::unique_ptr<core::Simulator> simulator = core::make_simulator();
  if (const auto reason = simulator->unsupported(scene, setup)) throw std::invalid_argument(*reason);
  malloc_trim(0);
  const double before = resident_bytes();
  double least = INFINITY, bytes = 0;
  // The least of runs of 0.3 s together; a first one only warms where it took less than 1 s.
  const double start = bench::cpu_now();
  for (int run = 0; run < 200; ++run) {
    const double spent = bench::cpu_now() - start;
    if (run > 0 && spent > (run == 1 ? 1 : 0.3)) break;
    if (run == 1) least = INFINITY;
    simulator->load(scene, setup);
    const double begun = bench::cpu_now();
    simulator->advance(bench::scaling::steps);
    least = std::min(least, bench::cpu_now() - begun);
    if (run == 0) malloc_trim(0), bytes = resident_bytes() - before;
  }
  core::State end(scene.bodies.size());
  simulator->read(end);
  const bench::scaling::Seen seen = kind.look(scene, end);
  fmt::print(out, "{:.6g} {:.6g} {} {:.6g}\n",
             1e9 * least / static_cast<double>(bench::scaling::steps * bodies), seen.error, seen.contacts,
             bytes / static_cast<double>(bodies));
  std::fclose(out);
  return 0;
}

}  // namespace

int main(int count, char** arguments) try {
  return measure({arguments + 1, arguments + count});
} catch (const std::exception& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 1;
}
