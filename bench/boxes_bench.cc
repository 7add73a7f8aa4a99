// A lattice of bodies dropped into an open box (friction 0.5, no restitution, steps of 1/60 s for 5 s): the
// in-house engine, Bullet and ODE's QuickStep through the same door, one after another in one run: first with no
// bodies that sleep in any engine, then with those that sleep in the engines that have an option for it (ODE's worker has
// none).  A time never travels without its error: every row says how deep the settled pile overlaps,
// and how far its bodies move in the last half second (the mean of all).  The bodies are cubes of 1 m, or `mixed`:
// spheres, cubes, capsules and cylinders in turn.
//   boxes_bench [mixed] [COUNT…]      100 and 1000 otherwise; 10000 takes about ten minutes
#include "bench/engine_run.h"
#include "bench/pile.h"
#include "bench/scaling/touching.h"
#include "harness/core/solid.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace {

using namespace cylon;

constexpr double step = 1. / 60;
constexpr std::int64_t steps = 300, last = 30;  // the last half second

struct Row {
  std::string id;
  double ns = INFINITY;                         // per body-step
  double overlap = INFINITY, creep = INFINITY;  // [m]; [m/s]
};

core::Shape cube() { return core::Box{core::Vector3::Constant(bench::radius)}; }

// The i-th of the kinds that every engine here has: all fit into the cell of the lattice.
core::Shape in_turn(std::size_t i) {
  constexpr double r = bench::radius;
  const core::Shape kinds[] = {core::Sphere{r}, cube(), core::Capsule{r / 2, r}, core::Cylinder{r * 0.8, r}};
  return kinds[i % std::size(kinds)];
}

core::Scene dropped(std::int64_t count, bool mixed) {
  const auto side = static_cast<std::int64_t>(std::lround(std::cbrt(static_cast<double>(count))));
  core::Scene scene = bench::pile(count, side, 0.6, 1.1);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    core::Body& body = scene.bodies[i];
    body.shape = mixed ? in_turn(i) : cube();
    body.inertia = core::mass_properties(body.shape, bench::mass).inertia;
  }
  return scene;
}

double mean_distance(const core::State& a, const core::State& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i].position - b[i].position).norm();
  return sum / static_cast<double>(a.size());
}

Row row(const std::string& id, const core::Scene& scene, const std::string& directory) {
  const auto recording = bench::run_engine(id, scene, step, steps, last, directory);
  if (!recording) return {id};
  const auto& states = recording->states;
  const double body_steps = static_cast<double>(scene.bodies.size()) * steps;
  const bench::Touching touching = bench::touching(scene, states.back(), 1e-3);
  const Row result{id, 1e9 * recording->cpu_seconds / body_steps, touching.deepest,
                   mean_distance(states.back(), states[states.size() - 2]) / (step * last)};
  fmt::print("{:>7}  {:<38} {:>10.0f} {:>12.3g} {:>12.3g} {:>9}\n", scene.bodies.size(), id, result.ns,
             1e3 * result.overlap, 1e3 * result.creep, touching.pairs);
  return result;
}

const Row* cheapest(std::span<const Row> ours, const Row& theirs, double share) {
  const Row* best = nullptr;
  for (const Row& r : ours)
    if (r.overlap <= share * theirs.overlap && r.creep <= share * theirs.creep && (!best || r.ns < best->ns))
      best = &r;
  return best;
}

// The cheapest of ours that overlaps and creeps by a quarter of theirs, beside each of them; if there is none, the
// cheapest with no more than theirs.
void verdict(std::span<const Row> ours, const Row& theirs, double wanted) {
  if (!std::isfinite(theirs.ns)) return;  // it did not end: no ratio
  if (const Row* best = cheapest(ours, theirs, 0.25))
    return fmt::print(
        "         {} costs {:.2f} of {} at a quarter of its overlap and creep, target {:.1f}: {}\n", best->id,
        best->ns / theirs.ns, theirs.id, wanted, best->ns <= wanted * theirs.ns ? "met" : "NOT MET");
  fmt::print("         beside {}: NOT MET by any of ours: overlap <= {:.3g} mm, creep <= {:.3g} mm/s\n",
             theirs.id, 1e3 * theirs.overlap / 4, 1e3 * theirs.creep / 4);
  if (const Row* best = cheapest(ours, theirs, 1))
    fmt::print("         {} costs {:.2f} of {} at no more than its overlap and creep\n", best->id,
               best->ns / theirs.ns, theirs.id);
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string directory = std::filesystem::canonical("/proc/self/exe").parent_path().string();
  std::vector<std::int64_t> sizes;
  const bool mixed = count > 1 && arguments[1] == std::string_view("mixed");
  for (int i = mixed ? 2 : 1; i < count; ++i) sizes.push_back(std::stoll(arguments[i]));
  if (sizes.empty()) sizes = {100, 1000};
  fmt::print("{:>7}  {:<38} {:>10} {:>12} {:>12} {:>9}\n", mixed ? "bodies" : "cubes", "engine", "ns/(b*s)",
             "overlap mm", "creep mm/s", "contacts");
  for (const std::int64_t size : sizes) {
    const core::Scene scene = dropped(size, mixed);
    std::vector<Row> rows;
    for (const char* id : {"in-house/sleeping=off", "in-house/sleeping=off,sweeps=80",
                           "in-house-float/sleeping=off", "bullet/iterations=10",
                           "bullet-float/iterations=10", "bullet/path=as-expert", "ode-quick/iterations=10"})
      rows.push_back(row(id, scene, directory));
    const std::span all(rows), in_double = all.first(2), in_float = all.subspan(2, 1);
    const double wanted = size < 10'000 ? 0.5 : 0.4;
    verdict(in_double, rows[3], wanted);
    verdict(in_float, rows[4], wanted);
    verdict(in_double, rows[5], wanted);
    verdict(all.first(3), rows[6], 0.4);
    for (const char* id : {"in-house", "in-house/sweeps=80", "in-house-float",
                           "bullet/iterations=10,sleeping=on", "bullet-float/iterations=10,sleeping=on"})
      row(id, scene, directory);
  }
}
