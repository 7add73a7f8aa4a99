// How the cost of a step grows with the number of bodies N = 1, 10, 100, 316, … 10^6: five kinds of scenes
// (bench/scaling/kinds.cc), this engine, Bullet and ODE side by side, 60 steps of 1/60 s each, whatever N.
// Every cell is a process of its own that links its engine (bench/scaling/cell.cc) and has so many seconds of
// CPU time for all that it does, making the scene and loading it included; an engine's row ends where the
// next cell would need more, or did.  A speed never travels without its error and the work done.  The
// exponents are fitted over N >= 100, with their standard errors.
//   scaling_bench [KIND…]      all otherwise; about four minutes
#include "bench/scaling/kinds.h"
#include "bench/scaling/power_law.h"
#include "harness/process/child.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace cylon;
using bench::scaling::Kind;

constexpr double seconds = 8;         // of CPU time for a cell
constexpr double wall_seconds = 300;  // backstop, on a machine that is busy

constexpr std::int64_t sizes[] = {1, 10, 100, 316, 1'000, 3'162, 10'000, 31'623, 100'000, 316'228, 1'000'000};

// Fixed steps everywhere: what grows is the scene, not the accuracy asked for.  In piles Bullet and ODE's
// QuickStep have 10 iterations, as this engine has 10 sweeps.
struct Engine {
  const char *label, *build, *path, *integrator;
  bool in_piles, in_smooth, has_iterations;
};
constexpr Engine engines[] = {
    {"in-house", "in-house", "-", "velocity-verlet", false, true, false},
    {"in-house", "in-house", "-", "-", true, false, false},
    {"in-house-float", "in-house-f32", "-", "velocity-verlet", false, true, false},
    {"in-house-float", "in-house-f32", "-", "-", true, false, false},
    {"bullet", "bullet-f64", "-", "-", true, true, true},
    {"bullet-float", "bullet-f32", "-", "-", true, true, true},
    {"ode", "ode", "step", "-", true, true, false},
    {"ode-quick", "ode", "quick", "-", true, false, true},
};

struct Cell {
  double ns = 0, error = 0, contacts = 0, bytes = 0;
  double cpu = 0;  // of all that it did [s]
};

// The CPU time of all children that were waited for.
double children_cpu() {
  rusage used{};
  getrusage(RUSAGE_CHILDREN, &used);
  const auto in_seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return in_seconds(used.ru_utime) + in_seconds(used.ru_stime);
}

/// Throws process::Failure, also where the cell needed too long.
Cell run(const std::filesystem::path& folder, const Kind& kind, const Engine& engine, std::int64_t size) {
  std::vector<std::string> command = {(folder / fmt::format("scaling-cell-{}", engine.build)).string(),
                                      kind.name,
                                      std::to_string(size),
                                      fmt::format("{:.0f}", seconds),
                                      engine.path,
                                      engine.integrator};
  if (kind.contacts && engine.has_iterations) command.emplace_back("iterations=10");
  const double before = children_cpu();
  Cell cell;
  {
    process::Child child(command, std::size_t{8} << 30);
    child.set_deadline(wall_seconds, "a cell");
    while (child.receive()) continue;
    const std::string said(child.output());
    if (std::sscanf(said.c_str(), "%lf %lf %lf %lf", &cell.ns, &cell.error, &cell.contacts, &cell.bytes) != 4)
      throw child.ending();
    child.finish(5);
  }
  cell.cpu = children_cpu() - before;
  return cell;
}

struct Fitted {
  std::string what;
  double from, to;
  bench::scaling::PowerLaw law;
};

Fitted row(const std::filesystem::path& folder, const Kind& kind, const Engine& engine) {
  std::vector<std::pair<double, double>> points;  // from 100 bodies on: N, ns per step
  double last_size = 0, last_cpu = 0;
  for (const std::int64_t size : sizes) {
    const auto n = static_cast<double>(size);
    // At least in proportion to N.
    if (last_cpu > 1 && last_cpu * n / last_size > seconds) break;
    Cell cell;
    try {
      cell = run(folder, kind, engine, size);
    } catch (const process::Failure& failure) {
      const std::string why = failure.what();
      fmt::print(
          "{:>8}  {:<15} {}\n", size, engine.label,
          why.find("SIGXCPU") == why.npos ? why : fmt::format("more than {:.0f} s of CPU time", seconds));
      break;
    }
    last_size = n, last_cpu = cell.cpu;
    fmt::print("{:>8}  {:<15} {:>12.4g} {:>12.2e} {:>9.0f} {:>9}\n", size, engine.label, cell.ns, cell.error,
               cell.contacts, size < 10'000 ? "" : fmt::format("{:.0f}", cell.bytes));
    if (size >= 100) points.emplace_back(n, cell.ns * n);
  }
  return {fmt::format("{:<8} {}", kind.name, engine.label), points.empty() ? 0 : points.front().first,
          points.empty() ? 0 : points.back().first, bench::scaling::fit(points)};
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto folder = std::filesystem::canonical("/proc/self/exe").parent_path();
  const std::vector<std::string> wanted(arguments + 1, arguments + count);
  std::vector<Fitted> fitted;
  for (const Kind& kind : bench::scaling::kinds()) {
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), kind.name) == wanted.end()) continue;
    fmt::print("\n{}: {}, {} steps of 1/60 s\n", kind.name, kind.what, bench::scaling::steps);
    fmt::print("{:>8}  {:<15} {:>12} {:>12} {:>9} {:>9}\n", "bodies", "engine", "ns/(b*s)",
               fmt::format("{} [{}]", kind.error, kind.unit), "contacts", "bytes/b");
    for (const Engine& engine : engines)
      if (kind.contacts ? engine.in_piles : engine.in_smooth) fitted.push_back(row(folder, kind, engine));
  }
  fmt::print("\n{:<26} {:>8} {:>8}   {}\n", "cost of a step ~ N^p", "p", "+-", "over N");
  for (const Fitted& f : fitted) {
    if (!(f.from < f.to)) continue;
    fmt::print("{:<26} {:>8.3f} {:>8}   {:.0f} to {:.0f}\n", f.what, f.law.exponent,
               std::isfinite(f.law.standard_error) ? fmt::format("{:.3f}", f.law.standard_error) : "-",
               f.from, f.to);
  }
}
