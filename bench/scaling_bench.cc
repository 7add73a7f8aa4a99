// How the cost of a step grows with the number of bodies: ns of thread CPU time per body and step, the
// workers timing their own steps, and the exponent p of cost ~ N^p fitted over N >= 100.  Three scenes that
// grow: spinning boxes that fly freely, beads on a line of springs, spheres dropped as a lattice into an open
// box.  A speed never travels without its error: the largest turn missed against the closed form, the
// energy's drift, the deepest overlap.
#include "bench/free_cloud.h"
#include "bench/pile.h"
#include "harness/cli/context.h"
#include "harness/core/measure.h"
#include "harness/core/observable.h"
#include "harness/process/client.h"
#include "reference/exact/catalogue.h"
#include "scenarios/scenario.h"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <vector>

namespace {

using namespace cylon;

constexpr double dt = 1. / 240;

core::Scene boxes(std::int64_t count) {
  return scenarios::parse(
             "title = \"Boxes\"\nstory = \"Free flight\"\nduration = 1.0\nstep = \"1/240\"\n"
             "gravity = [0, -9.81, 0]\n" +
                 bench::free_cloud(count, "[0.2, 0.3, 0.4]", "[0.3, 1.1, -0.4]") +
                 "[[claim]]\nconserves = \"energy\"\ntolerance = { relative = 1, reason = \"rounding\" }\n",
             "boxes.toml")
      .scene;
}

core::Body body_at(std::int64_t i, const core::Vector3& position) {
  core::Body body;
  body.name = fmt::format("body{}", i);
  body.mass = 1;
  body.inertia = core::Matrix3::Identity() * 0.1;
  body.initial.position = position;
  return body;
}

// Beads at rest length between two walls, every tenth of them pushed.
core::Scene beads(std::int64_t count) {
  core::Scene scene;
  for (std::int64_t i = 0; i < count; ++i) {
    scene.bodies.push_back(body_at(i, {1.0 * static_cast<double>(i + 1), 0, 0}));
    if (i % 10 == 0) scene.bodies.back().initial.velocity = {0.5, 0, 0};
  }
  for (std::int64_t i = 0; i <= count; ++i) {
    core::Spring spring;
    spring.body = static_cast<int>(std::min(i, count - 1));
    spring.to = i == 0 || i == count ? core::world : static_cast<int>(i - 1);
    if (i == 0) spring.to_anchor = {0, 0, 0};
    if (i == count) spring.to_anchor = {1.0 * static_cast<double>(count + 1), 0, 0};
    spring.stiffness = 100, spring.rest_length = 1;
    scene.forces.push_back(spring);
  }
  return scene;
}

core::Scene pile(std::int64_t count) {
  const auto side = static_cast<std::int64_t>(std::ceil(std::cbrt(static_cast<double>(count))));
  return bench::pile(count, side, 0.505, 1.009);
}

// The largest turn missed [rad]: the same bodies by the closed form.
double turn_missed(const core::Scene& scene, const core::Recording& r) {
  core::Observable q;
  q.quantity = core::Quantity::orientation;
  double worst = 0;
  const std::size_t looked_at = std::min<std::size_t>(scene.bodies.size(), 20);
  for (const exact::Solution& s : exact::catalogue()) {
    if (s.name != "free_asymmetric_top") continue;
    for (std::size_t i = 0; i < looked_at; ++i) {
      core::Scene one;
      one.bodies = {scene.bodies[i]};
      const double end = r.time(r.states.size() - 1);
      core::Values ours, truth;
      core::evaluate(q, one, {r.states.back()[i]}, ours);
      core::evaluate(q, one, s.make(one, end).state(end), truth);
      worst = std::max(worst, core::distance(q, ours, truth));
    }
  }
  return worst;
}

double energy_drift(const core::Scene& scene, const core::Recording& r) {
  core::Observable q;
  q.quantity = core::Quantity::energy;
  core::Values before, after;
  core::evaluate(q, scene, r.states.front(), before);
  core::evaluate(q, scene, r.states.back(), after);
  return core::distance(q, before, after) / core::energy_scale(scene, r.states.front());
}

double overlap(const core::Scene& scene, const core::Recording& r) {
  return bench::overlap(scene, r.states.back());
}

struct Growing {
  const char* name;
  core::Scene (*scene)(std::int64_t);
  double (*error)(const core::Scene&, const core::Recording&);
  const char* error_name;
  std::int64_t most;  // bodies
  std::int64_t work;  // body-steps of a run
};
constexpr Growing scenes[] = {
    {"boxes", boxes, turn_missed, "missed_rad", 100'000, 1'000'000},
    {"beads", beads, energy_drift, "drift_of_E", 100'000, 1'000'000},
    {"pile", pile, overlap, "overlap_m", 10'000, 100'000},
};
// A fixed step everywhere: what grows is the scene, not the accuracy asked for.
constexpr const char* engines[] = {"in-house/integrator=velocity-verlet",
                                   "in-house-float/integrator=velocity-verlet",
                                   "bullet-float",
                                   "bullet",
                                   "ode",
                                   "ode-quick"};

// ns per step by number of bodies, in the order of the benchmarks.
std::map<std::string, std::vector<std::pair<double, double>>> grown;

void step(benchmark::State& state, const Growing& growing, const std::string& id) {
  const std::int64_t count = state.range(0);
  const core::Scene scene = growing.scene(count);
  const auto choice = process::parse_engine(id, cli::make_context().engines);
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = request.every = std::clamp<std::int64_t>(growing.work / count, 4, 20'000);
  request.repetitions = 2;
  double least = INFINITY, error = 0;
  for (auto _ : state) {
    const process::RunOutcome outcome = process::run(choice, request, {.run_seconds = 120});
    if (!outcome.recording) return state.SkipWithError(outcome.reason.c_str());
    double seconds = INFINITY;
    for (const process::Repetition& r : outcome.repetitions) seconds = std::min(seconds, r.step_seconds);
    state.SetIterationTime(seconds);
    least = std::min(least, seconds);
    error = growing.error(scene, *outcome.recording);
  }
  const double steps = static_cast<double>(request.steps), ns = 1e9 * least / steps;
  state.counters["ns_per_body_step"] = ns / static_cast<double>(count);
  state.counters["steps"] = steps;
  state.counters[growing.error_name] = error;
  grown[fmt::format("{}/{}", growing.name, id)].emplace_back(static_cast<double>(count), ns);
}

// Least squares of log(ns per step) over log N.
void print_exponents() {
  fmt::print("\n{:<52} {:>9} {:>8}\n", "cost of a step ~ N^p, fitted over N >= 100", "p", "points");
  for (const auto& [name, points] : grown) {
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (const auto& [count, ns] : points) {
      if (count < 100) continue;
      const double u = std::log(count), v = std::log(ns);
      ++n, x += u, y += v, xx += u * u, xy += u * v;
    }
    if (n >= 2) fmt::print("{:<52} {:>9.3f} {:>8.0f}\n", name, (n * xy - x * y) / (n * xx - x * x), n);
  }
}

}  // namespace

int main(int argc, char** argv) {
  benchmark::Initialize(&argc, argv);
  if (benchmark::ReportUnrecognizedArguments(argc, argv)) return 2;
  for (const Growing& growing : scenes)
    for (std::int64_t count = 1; count <= growing.most; count *= 10)
      for (const char* id : engines)
        benchmark::RegisterBenchmark(fmt::format("{}/{}", growing.name, id).c_str(),
                                     [&growing, id](benchmark::State& state) { step(state, growing, id); })
            ->Arg(count)
            ->Iterations(2)
            ->UseManualTime()
            ->Unit(benchmark::kMillisecond);
  benchmark::RunSpecifiedBenchmarks();
  benchmark::Shutdown();
  print_exponents();
}
