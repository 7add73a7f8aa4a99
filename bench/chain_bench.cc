// A chain of links of 1 m on ball joints, let go from the horizontal, and a humanoid of 30 hinges that hangs by its pelvis,
// for half a second: CPU time in steps from 1/10 to 1/1920 s, and how far the worst link is from where it should be.  That is
// what rk4 of this engine says in steps of 1/3840 s, and, to the printed difference, rk8 in the same.  This engine in fixed
// steps and others; none of them has collisions here.  Last: what this engine costs over each row of engines that have trees,
// by its cheapest row whose error is no larger, to a tenth.
//   chain_bench [LINKS|humanoid…]      10, 100, 1000 and humanoid otherwise
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
constexpr double longest = 5;            // [s] of CPU time; finer steps of that engine are left out
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

// Links of 4 kg a metre, one after the other from `from` on `parent`, each on a hinge at its beginning.
class Figure {
 public:
  explicit Figure(const core::Vector3& pelvis) {
    add(core::Joint{.type = core::JointType::ball, .point = pelvis + core::Vector3(0.02, 0.1, 0)},
        pelvis - core::Vector3(0, 0.1, 0), pelvis + core::Vector3(0, 0.1, 0));
  }

  struct Link {
    core::Vector3 axis, way;
  };
  int limb(int parent, core::Vector3 from, const std::vector<Link>& links) {
    for (const Link& link : links) {
      add(core::Joint{.type = core::JointType::hinge, .to = parent, .point = from, .axis = link.axis}, from,
          from + link.way);
      parent = static_cast<int>(scene_.bodies.size()) - 1, from += link.way;
    }
    return parent;
  }

  core::Scene scene() const { return scene_; }

 private:
  void add(core::Joint joint, const core::Vector3& from, const core::Vector3& to) {
    const double length = (to - from).norm(), mass = 4 * length, along = mass * 4e-4;
    const core::Vector3 way = (to - from) / length;
    core::Body body;
    body.name = fmt::format("link{}", scene_.bodies.size());
    body.mass = mass;
    const core::Matrix3 outer = way * way.transpose();
    body.inertia =
        (mass * length * length / 12 + along) * (core::Matrix3::Identity() - outer) + along * outer;
    body.initial.position = (from + to) / 2;
    joint.body = static_cast<int>(scene_.bodies.size());
    scene_.bodies.push_back(body);
    scene_.joints.push_back(joint);
  }

  core::Scene scene_;
};

// Three hinges at each shoulder and hip, two at each wrist and ankle, one at each elbow and knee, three in the back and the
// neck.  Gravity is oblique, so that nothing is in balance.
core::Scene humanoid() {
  const core::Vector3 x = core::Vector3::UnitX(), y = core::Vector3::UnitY(), z = core::Vector3::UnitZ();
  Figure figure({0, 1, 0});
  const int chest = figure.limb(0, {0, 1.1, 0}, {{x, 0.12 * y}, {z, 0.12 * y}, {y, 0.2 * y}});
  figure.limb(chest, {0, 1.54, 0}, {{y, 0.04 * y}, {x, 0.04 * y}, {z, 0.2 * y}});
  for (const double side : {-1., 1.}) {
    const core::Vector3 out = side * x;
    figure.limb(chest, 0.2 * out + 1.5 * y,
                {{z, 0.05 * out},
                 {y, 0.05 * out},
                 {x, 0.25 * out},
                 {y, 0.25 * out},
                 {z, 0.05 * out},
                 {y, 0.12 * out}});
    figure.limb(
        0, 0.1 * out + 0.9 * y,
        {{z, -0.05 * y}, {x, -0.05 * y}, {y, -0.35 * y}, {x, -0.4 * y}, {x, -0.05 * y}, {z, 0.2 * z}});
  }
  core::Scene scene = figure.scene();
  scene.forces = {core::UniformGravity{{3, -9, 2}}};
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

constexpr const char* engines[] = {"in-house/integrator=rk4",
                                   "in-house/integrator=velocity-verlet",
                                   "bullet-multibody",
                                   "bullet-multibody/integrator=runge-kutta-4",
                                   "bullet",
                                   "ode",
                                   "ode-quick",
                                   "mujoco/integrator=euler",
                                   "mujoco/integrator=rk4",
                                   "simbody/integrator=verlet",
                                   "simbody/integrator=runge-kutta-3",
                                   "dart"};

std::vector<Row> measure(const std::string& name, const core::Scene& scene, const core::State& reference,
                         const std::string& directory) {
  std::vector<Row> rows;
  const auto links = static_cast<double>(scene.bodies.size());
  for (const char* id : engines)
    for (const double rate : {10., 20., 30., 60., 120., 240., 480., 960., 1920.}) {
      const auto recording = run(id, scene, rate, directory);
      if (!recording) break;
      const Row row = {id, rate, recording->cpu_seconds / duration,
                       difference(recording->states.back(), reference)};
      fmt::print("{:>8}  {:<42} 1/{:<5} {:>10.3f} {:>12.1f} {:>10.1e}\n", name, id, rate,
                 1e6 * row.second / rate / links, 1e6 * row.second / links, row.error);
      rows.push_back(row);
      if (recording->cpu_seconds > longest) {
        fmt::print("{:>8}  {:<42} finer steps take longer than {} s and are left out\n", name, id, longest);
        break;
      }
    }
  return rows;
}

bool starts(const Row& row, const char* beginning) { return row.engine.starts_with(beginning); }

bool has_trees(const Row& row) {
  return starts(row, "bullet-multibody") || starts(row, "mujoco") || starts(row, "simbody") ||
         starts(row, "dart");
}

void compare(const std::string& name, const std::vector<Row>& rows) {
  for (const Row& other : rows) {
    if (!has_trees(other) || !std::isfinite(other.error)) continue;
    const Row* best = nullptr;
    for (const Row& own : rows)
      if (starts(own, "in-house") && own.error <= 1.1 * other.error && (!best || own.second < best->second))
        best = &own;
    if (best)
      fmt::print("{:>8}  {:<42} 1/{:<5} cost over it {:>6.2f}, by {} in 1/{} s\n", name, other.engine,
                 other.rate, best->second / other.second, best->engine, best->rate);
    else
      fmt::print("{:>8}  {:<42} 1/{:<5} no row of ours has an error so small\n", name, other.engine,
                 other.rate);
  }
}

}  // namespace

int main(int count, char** arguments) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const std::string directory = std::filesystem::canonical("/proc/self/exe").parent_path().string();
  std::vector<std::string> names(arguments + 1, arguments + count);
  if (names.empty()) names = {"10", "100", "1000", "humanoid"};
  fmt::print("{:>8}  {:<42} {:<7} {:>10} {:>12} {:>10}\n", "links", "engine", "step/s", "us/(l*step)",
             "us/(l*s)", "error/m");
  for (const std::string& name : names) {
    const core::Scene scene = name == "humanoid" ? humanoid() : chain(std::stoll(name));
    const auto reference = run("in-house/integrator=rk4", scene, reference_rate, directory),
               second = run("in-house/integrator=rk8", scene, reference_rate, directory);
    if (!reference || !second) return 1;
    fmt::print("{:>8}  the reference is known to {:.1e} m\n", name,
               difference(reference->states.back(), second->states.back()));
    compare(name, measure(name, scene, reference->states.back(), directory));
  }
}
