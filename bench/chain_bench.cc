// A chain of links of 1 m on ball joints, let go from the horizontal: CPU time per step and link, and the
// drift of the energy beside it (over m g 1 m), in steps of 1/240 s for half a second.  This engine in fixed steps of a
// fourth-order and of a symplectic integrator, Bullet and ODE; none of them has collisions here.
//   chain_bench [LINKS…]      10, 100 and 1000 otherwise
#include "bench/engine_run.h"
#include "harness/core/measure.h"
#include "harness/core/observable.h"

#include <fmt/format.h>

#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace {

using namespace cylon;

constexpr std::int64_t steps = 120;

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

double energy_drift(const core::Scene& scene, const core::State& end) {
  core::Observable q;
  q.quantity = core::Quantity::energy;
  core::State start;
  for (const core::Body& body : scene.bodies) start.push_back(body.initial);
  core::Values before, after;
  core::evaluate(q, scene, start, before);
  core::evaluate(q, scene, end, after);
  return core::distance(q, before, after) / core::energy_scale(scene, start);
}

void row(const std::string& id, const core::Scene& scene, const std::string& directory) {
  const auto recording = bench::run_engine(id, scene, 1. / 240, steps, steps, directory);
  if (!recording) return;
  const double us = 1e6 * recording->cpu_seconds / static_cast<double>(steps);
  fmt::print("{:>6}  {:<38} {:>10.1f} {:>10.3f} {:>12.2e}\n", scene.bodies.size(), id, us,
             us / static_cast<double>(scene.bodies.size()), energy_drift(scene, recording->states.back()));
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string directory = std::filesystem::canonical("/proc/self/exe").parent_path().string();
  std::vector<std::int64_t> sizes;
  for (int i = 1; i < count; ++i) sizes.push_back(std::stoll(arguments[i]));
  if (sizes.empty()) sizes = {10, 100, 1000};
  fmt::print("{:>6}  {:<38} {:>10} {:>10} {:>12}\n", "links", "engine", "us/step", "us/(l*s)",
             "energy drift");
  for (const std::int64_t size : sizes) {
    const core::Scene scene = chain(size);
    for (const char* id : {"in-house/integrator=rk4", "in-house/integrator=velocity-verlet", "bullet",
                           "bullet-multibody", "ode", "ode-quick"})
      row(id, scene, directory);
  }
}
