// A pile of equal spheres dropped as a lattice into an open box (radius 0.5 m, friction 0.5, no restitution,
// steps of 1/60 s for 5 s): the in-house engine, Bullet and ODE's QuickStep through the same door, one after
// another in one run. A time never travels without its error: every row says how deep the settled pile
// overlaps.
//   pile_bench [--huge]     10^5 spheres too, which takes minutes in the other engines
#include "harness/process/client.h"
#include "harness/process/engines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <vector>

namespace {

using namespace cylon;

constexpr double radius = 0.5, mass = 1, friction = 0.5, step = 1. / 60;
constexpr int steps = 300;

core::Scene pile(int count) {
  const int side = count <= 1000 ? 10 : count <= 10000 ? 20 : 46;
  const double half = 0.55 * side + 0.1;
  core::Scene scene;
  scene.forces = {core::UniformGravity{}};
  scene.planes = {{"floor", {0, 1, 0}, 0},
                  {"west", {1, 0, 0}, -half},
                  {"east", {-1, 0, 0}, -half},
                  {"north", {0, 0, 1}, -half},
                  {"south", {0, 0, -1}, -half}};
  scene.materials = {{{"*", "*"}, 0, friction}};
  for (int i = 0; i < count; ++i) {
    const int x = i % side, z = i / side % side, y = i / side / side;
    core::Body ball;
    ball.name = fmt::format("ball{}", i);
    ball.mass = mass;
    ball.inertia = core::Matrix3::Identity() * (0.4 * mass * radius * radius);
    ball.shape = core::Sphere{radius};
    ball.collide = true;
    ball.initial.position = {1.1 * x - half + 0.65 + 0.01 * (i * 7 % 11), 0.6 + 1.1 * y,
                             1.1 * z - half + 0.65 + 0.01 * (i * 5 % 13)};
    scene.bodies.push_back(ball);
  }
  return scene;
}

/// The deepest overlap of two balls or of a ball with a plane [m].
double overlap(const core::Scene& scene, const core::State& state) {
  double worst = 0;
  std::vector<core::Vector3> sorted;
  for (const core::BodyState& body : state) sorted.push_back(body.position);
  std::sort(sorted.begin(), sorted.end(),
            [](const core::Vector3& a, const core::Vector3& b) { return a.x() < b.x(); });
  for (std::size_t i = 0; i < sorted.size(); ++i) {
    for (const core::Plane& plane : scene.planes)
      worst = std::max(worst, radius - (plane.normal.dot(sorted[i]) - plane.offset));
    for (std::size_t j = i + 1; j < sorted.size() && sorted[j].x() < sorted[i].x() + 2 * radius; ++j)
      worst = std::max(worst, 2 * radius - (sorted[i] - sorted[j]).norm());
  }
  return worst;
}

void row(const std::string& id, const core::Scene& scene, const std::string& directory) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = step;
  request.steps = steps;
  request.every = steps;
  process::Limits limits;
  limits.run_seconds = 3600;
  const auto engine = process::parse_engine(id, process::default_engines(directory));
  const auto outcome = process::run(engine, request, limits);
  if (!outcome.recording) {
    fmt::print("{:>7}  {:<30} {}\n", scene.bodies.size(), id, outcome.reason);
    return;
  }
  const double body_steps = static_cast<double>(scene.bodies.size()) * steps;
  fmt::print("{:>7}  {:<30} {:>10.0f} {:>12.2f}\n", scene.bodies.size(), id,
             1e9 * outcome.recording->cpu_seconds / body_steps,
             1e3 * overlap(scene, outcome.recording->states.back()));
}

}  // namespace

int main(int count, char** arguments) {
  const bool huge = count > 1 && std::strcmp(arguments[1], "--huge") == 0;
  const std::string directory = std::filesystem::canonical("/proc/self/exe").parent_path().string();
  fmt::print("{:>7}  {:<30} {:>10} {:>12}\n", "spheres", "engine", "ns/(b*s)", "overlap mm");
  for (const int spheres : {1000, 10000, 100000}) {
    if (spheres == 100000 && !huge) break;
    const core::Scene scene = pile(spheres);
    for (const char* id : {"in-house-float", "in-house-float/sweeps=4", "in-house",
                           "bullet-float/iterations=10", "ode-quick/iterations=10"})
      row(id, scene, directory);
  }
}
