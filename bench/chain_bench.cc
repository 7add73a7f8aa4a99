// A chain of links of 1 m on ball joints, let go from the horizontal, for half a second: CPU time in steps from 1/10 to
// 1/480 s, and how far the worst link is from where it should be.  That is what rk4 of this engine says in steps of
// 1/3840 s, and, to the printed difference, rk8 in the same.  This engine in fixed steps, Bullet and ODE; none of them has
// collisions here.  Last: what this engine costs over each row of Bullet's multibody, by its cheapest row whose error
// is no larger, to a tenth.
//   chain_bench [LINKS…]      10, 100 and 1000 otherwise
#include "bench/engine_run.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace {

using namespace cylon;

constexpr double duration = 0.5;         // [s]
constexpr double reference_rate = 3840;  // steps a second

core::Scene chain(std::int64_t links) {
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  for (std::int64_t i = 0; i < links; ++i) {
    core::Body link;
    link.name = fmt::format("link{}", i);
    link.mass = 1;
    link.inertia = core::Vector3(0.005, 0.085, 0.085).asDiagonal();
    link.initial.position = {static_cast<double>(i) + 0.5, 1, 0};
    scene.bodies.push_back(link);
    core::Joint joint;
    joint.type = core::JointType::ball;
    joint.body = static_cast<int>(i), joint.to = i == 0 ? core::world : static_cast<int>(i - 1);
    joint.point = {static_cast<double>(i), 1, 0};
    scene.joints.push_back(joint);
  }
  return scene;
}

struct Row {
  std::string engine;
  double rate = 0;    // steps a second
  double second = 0;  // CPU time per simulated second [s]
  double error = 0;   // of the worst link at the end [m]
};

std::optional<core::Recording> run(const std::string& id, const core::Scene& scene, double rate,
                                   const std::string& directory) {
  const auto steps = static_cast<std::int64_t>(std::lround(duration * rate));
  return bench::run_engine(id, scene, 1 / rate, steps, steps, directory);
}

double difference(const core::State& a, const core::State& b) {
  double most = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = (a[i].position - b[i].position).norm();
    if (!(d <= most)) most = d;  // NaN stays
  }
  return most;
}

std::vector<Row> measure(const core::Scene& scene, const core::State& reference,
                         const std::string& directory) {
  std::vector<Row> rows;
  const std::size_t links = scene.bodies.size();
  for (const char* id : {"in-house/integrator=rk4", "in-house/integrator=velocity-verlet", "bullet-multibody",
                         "bullet-multibody/integrator=runge-kutta-4", "bullet", "ode", "ode-quick"})
    for (const double rate : {10., 20., 30., 60., 120., 240., 480.}) {
      const auto recording = run(id, scene, rate, directory);
      if (!recording) break;
      const Row row = {id, rate, recording->cpu_seconds / duration,
                       difference(recording->states.back(), reference)};
      fmt::print("{:>6}  {:<42} 1/{:<5} {:>10.3f} {:>12.1f} {:>10.1e}\n", links, id, rate,
                 1e6 * row.second / rate / static_cast<double>(links),
                 1e6 * row.second / static_cast<double>(links), row.error);
      rows.push_back(row);
    }
  return rows;
}

bool starts(const Row& row, const char* beginning) { return row.engine.starts_with(beginning); }

void compare(const std::vector<Row>& rows, std::size_t links) {
  for (const Row& other : rows) {
    if (!starts(other, "bullet-multibody") || !std::isfinite(other.error)) continue;
    const Row* best = nullptr;
    for (const Row& own : rows)
      if (starts(own, "in-house") && own.error <= 1.1 * other.error && (!best || own.second < best->second))
        best = &own;
    if (best)
      fmt::print("{:>6}  {:<42} 1/{:<5} cost over it {:>6.2f}, by {} in 1/{} s\n", links, other.engine,
                 other.rate, best->second / other.second, best->engine, best->rate);
    else
      fmt::print("{:>6}  {:<42} 1/{:<5} no row of ours has an error so small\n", links, other.engine,
                 other.rate);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string directory = std::filesystem::canonical("/proc/self/exe").parent_path().string();
  std::vector<std::int64_t> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(std::stoll(arguments[i]));
  if (sizes.empty()) sizes = {10, 100, 1000};
  fmt::print("{:>6}  {:<42} {:<7} {:>10} {:>12} {:>10}\n", "links", "engine", "step/s", "us/(l*step)",
             "us/(l*s)", "error/m");
  for (const std::int64_t size : sizes) {
    const core::Scene scene = chain(size);
    const auto reference = run("in-house/integrator=rk4", scene, reference_rate, directory),
               second = run("in-house/integrator=rk8", scene, reference_rate, directory);
    if (!reference || !second) return 1;
    fmt::print("{:>6}  the reference is known to {:.1e} m\n", size,
               difference(reference->states.back(), second->states.back()));
    compare(measure(scene, reference->states.back(), directory), scene.bodies.size());
  }
}
