// Spheres event by event beside Bullet and ODE: what a run costs and how wrong it is, in one table.
// S2, a bouncing sphere: cost of a run of 5 s whose largest error of height over 300 samples is below 1e-2 m;
// for the others the largest step of a ladder that reaches it.  S13, a gas of 1000 spheres for 10 s: drift of
// the energy beside the cost.  CPU time of the stepping alone, all engines alike: the workers time their own
// steps and this process times step() here; the smallest of several runs.  Workers are looked for beside this
// program.  Settings: each engine's published path with its defaults, but for what is printed.
#include "bench/cpu_time.h"
#include "engine/ballistic/ballistic.h"
#include "harness/process/client.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace {

using namespace cylon;
using bench::cpu_now;

constexpr double gravity = 9.81, radius = 0.5, restitution = 0.8, drop = 2.0, bounce_time = 5, gas_time = 10;

// Closed form: flight n starts at t_n with speed u e^n.
double height(double t) {
  double start = 0, speed = 0, base = drop;
  for (double end = std::sqrt(2 * drop / gravity); t > end;) {
    speed = speed == 0 ? restitution * std::sqrt(2 * gravity * drop) : restitution * speed;
    start = end;
    base = 0;
    end += 2 * speed / gravity;
  }
  const double s = t - start;
  return radius + base + speed * s - gravity * s * s / 2;
}

struct Result {
  double cpu = 0, error = 0;  // [s]; [m] or relative energy
  std::string failure;
};

// The largest error at the 300 samples t = T k / 300.
double height_error(const std::vector<double>& heights) {
  double worst = 0;
  for (std::size_t k = 0; k < heights.size(); ++k)
    worst = std::max(worst, std::abs(heights[k] - height(bounce_time * static_cast<double>(k) /
                                                         static_cast<double>(heights.size() - 1))));
  return worst;
}

double gas_energy(const core::Scene& scene, const core::State& state) {
  double sum = 0;
  for (std::size_t i = 0; i < state.size(); ++i)
    sum += scene.bodies[i].mass * state[i].velocity.squaredNorm() / 2 +
           state[i].angular_velocity.dot(scene.bodies[i].inertia * state[i].angular_velocity) / 2;
  return sum;
}

Result run_worker(const core::Scene& scene, const process::EngineChoice& choice, double duration,
                  std::int64_t steps, bool gas) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = duration / static_cast<double>(steps);
  request.steps = steps;
  request.every = steps / 300;
  process::Limits limits;
  limits.run_seconds = 120;
  const auto outcome = process::run(choice, request, limits);
  if (!outcome.recording) return {0, 0, outcome.reason};
  const core::Recording& r = *outcome.recording;
  if (gas)
    return {r.cpu_seconds,
            std::abs(gas_energy(scene, r.states.back()) / gas_energy(scene, r.states.front()) - 1), ""};
  std::vector<double> heights;
  for (const core::State& s : r.states) heights.push_back(s[0].position.y());
  return {r.cpu_seconds, height_error(heights), ""};
}

engine::Model model_of(const core::Scene& scene, const engine::Material& material) {
  engine::Model model;
  model.surface_count = 1;
  model.materials = {material};
  for (const core::Force& f : scene.forces)
    model.forces.gravity = std::get<core::UniformGravity>(f).acceleration;
  for (const core::Plane& p : scene.planes) {
    model.planes.push_back({p.normal, p.offset});
    model.plane_surfaces.push_back(0);
  }
  for (const core::Body& b : scene.bodies) {
    model.bodies.push_back(engine::make_body(b.mass, b.inertia));
    model.motions.push_back(engine::make_motion(model.bodies.back(), b.initial.position,
                                                engine::Quaternion(b.initial.orientation.coeffs()),
                                                b.initial.velocity, b.initial.angular_velocity));
    model.shapes.emplace_back(engine::Sphere{std::get<core::Sphere>(b.shape).radius});
    model.surfaces.push_back(0);
  }
  return model;
}

// The stepping alone is timed; made anew for every run.  steps = 1: one step to the end, nothing sampled.
Result run_here(const engine::Model& model, double duration, int steps, int repeats, bool gas) {
  Result best{1e30, 0, ""};
  std::vector<engine::Motion> motions;
  for (int i = 0; i < repeats; ++i) {
    const auto stepper = engine::make_ballistic(model, duration / steps);
    std::vector<double> heights = {radius + drop};
    const double start = cpu_now();
    for (int k = 0; k < steps; ++k) {
      stepper->step();
      if (gas) continue;
      stepper->read(motions);
      heights.push_back(motions[0].position.y());
    }
    best.cpu = std::min(best.cpu, cpu_now() - start);
    if (stepper->handover()) return {0, 0, stepper->handover()->reason};
    stepper->read(motions);
    const auto energy = [&](const std::vector<engine::Motion>& m) {
      double sum = 0;
      for (std::size_t b = 0; b < m.size(); ++b)
        sum += m[b].momentum.squaredNorm() / (2 * model.bodies[b].mass);
      return sum;
    };
    best.error = gas          ? std::abs(energy(motions) / energy(model.motions) - 1)
                 : steps == 1 ? std::abs(heights.back() - height(duration))
                              : height_error(heights);
  }
  return best;
}

// A run of S2 that is too short to time alone: many in a row, less what making the steppers costs.
double seconds_per_bounce_run(const engine::Model& model) {
  constexpr int runs = 512;
  double best = 1e30;
  for (int repeat = 0; repeat < 50; ++repeat) {
    std::vector<std::unique_ptr<engine::Ballistic>> steppers;
    for (int i = 0; i < runs; ++i) steppers.push_back(engine::make_ballistic(model, bounce_time));
    std::vector<engine::Motion> motions;
    const double start = cpu_now();
    for (const auto& s : steppers) {
      s->step();
      s->read(motions);
    }
    best = std::min(best, (cpu_now() - start) / runs);
  }
  return best;
}

void row(const std::string& who, double dt, const Result& r, double own) {
  if (!r.failure.empty()) {
    fmt::print("{:<22} {:>10.3g}  {}\n", who, dt, r.failure);
    return;
  }
  fmt::print("{:<22} {:>10.3g} {:>12.3g} {:>12.3g} {:>10.0f}x\n", who, dt, r.error, 1e6 * r.cpu, r.cpu / own);
}

// The better of an engine's rows beside a target.
void verdict(const char* whom, double ratio, double target, const char* error) {
  fmt::print("  vs {}: {:.0f}x  target {:.0f}x {}  {}\n", whom, ratio, target, error,
             ratio >= target ? "met" : "NOT MET");
}

// By the first letters of an engine's id: the least cost over ours.
struct Best {
  double bullet = INFINITY, ode = INFINITY;
  void see(const std::string& id, double ratio) {
    double& place = id.starts_with("bullet") ? bullet : ode;
    place = std::min(place, ratio);
  }
};

void heading(const char* what, const char* error) {
  fmt::print("\n{}\n{:<22} {:>10} {:>12} {:>12} {:>11}\n", what, "engine", "dt [s]", error, "cpu [us]",
             "ratio");
}

void bouncing(const std::vector<process::EngineChoice>& engines) {
  const auto scenario = scenario::parse(fmt::format(R"(
title = "Bounces"
story = "S2"
duration = 5.0
step = 0.001
gravity = [0, -9.81, 0]
[[body]]
name = "ball"
mass = 1.0
position = [0, 2.5, 0]
shape = {{ type = "sphere", radius = 0.5 }}
[[plane]]
name = "floor"
normal = [0, 1, 0]
offset = 0
[[material]]
between = ["*", "*"]
restitution = {}
friction = 0
[[claim]]
conserves = "energy"
tolerance = {{ relative = 1, reason = "rounding" }}
)",
                                                    restitution),
                                        "bounces.toml");
  const engine::Model model = model_of(scenario.scene, {restitution, 0});
  heading("S2, bouncing sphere, 5 s; ratio = cpu / (ballistic, one step)", "max |dy|");
  const double own = seconds_per_bounce_run(model);
  row("ballistic, one step", bounce_time, {own, run_here(model, bounce_time, 1, 1, false).error, ""}, own);
  row("ballistic, 300 samples", bounce_time / 300, run_here(model, bounce_time, 300, 200, false), own);
  Best reached;
  for (const auto& choice : engines) {
    for (const std::int64_t steps : {300, 1200, 4800, 19200, 76800, 307200}) {
      Result best = run_worker(scenario.scene, choice, bounce_time, steps, false);
      for (int i = 0; i < 2 && best.failure.empty(); ++i)
        best.cpu = std::min(best.cpu, run_worker(scenario.scene, choice, bounce_time, steps, false).cpu);
      row(choice.id, bounce_time / static_cast<double>(steps), best, own);
      if (best.failure.empty() && best.error <= 1e-2) reached.see(choice.id, best.cpu / own);
      if (!best.failure.empty() || best.error <= 1e-2) break;
    }
  }
  verdict("Bullet", reached.bullet, 4000, "at 1e-2 m");
  verdict("ODE", reached.ode, 1200, "at 1e-2 m");
}

void gas(const std::vector<process::EngineChoice>& engines) {
  std::string text = R"(
title = "Gas"
story = "S13"
duration = 10.0
step = 0.001
[[cloud]]
name = "ball"
mass = 1.0
count = 1000
low = [-0.95, -0.95, -0.95]
high = [0.95, 0.95, 0.95]
speed = 1.0
seed = 7
shape = { type = "sphere", radius = 0.05 }
[[material]]
between = ["*", "*"]
restitution = 1
friction = 0
[[claim]]
conserves = "energy"
tolerance = { relative = 1, reason = "rounding" }
)";
  const char* normals[] = {"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"};
  for (int i = 0; i < 6; ++i)
    text += fmt::format("[[plane]]\nname = \"wall{}\"\nnormal = [{}]\noffset = -1\n", i, normals[i]);
  const auto scenario = scenario::parse(text, "gas1000.toml");
  const engine::Model model = model_of(scenario.scene, {1, 0});
  heading("S13, gas of 1000 spheres, 10 s; ratio = cpu / (ballistic at 1/60)", "|dE|/E");
  const Result own = run_here(model, gas_time, 600, 5, true);
  row("ballistic", gas_time / 600, own, own.cpu);
  row("ballistic", gas_time / 10000, run_here(model, gas_time, 10000, 2, true), own.cpu);
  Best cheapest;
  for (const auto& choice : engines)
    for (const std::int64_t steps : {600, 2400}) {
      const Result theirs = run_worker(scenario.scene, choice, gas_time, steps, true);
      row(choice.id, gas_time / static_cast<double>(steps), theirs, own.cpu);
      if (theirs.failure.empty()) cheapest.see(choice.id, theirs.cpu / own.cpu);
    }
  const char* error = own.error <= 1e-13 ? "at |dE|/E <= 1e-13" : "with |dE|/E > 1e-13 (NOT MET)";
  verdict("Bullet", cheapest.bullet, 15, error);
  verdict("ODE", cheapest.ode, 8, error);
}

}  // namespace

int main(int, char** argv) {
  const auto rows = process::default_engines(std::filesystem::absolute(argv[0]).parent_path());
  std::vector<process::EngineChoice> engines;
  for (const char* id : {"bullet", "bullet-float", "ode", "ode-quick"})
    engines.push_back(process::parse_engine(id, rows));
  bouncing(engines);
  gas(engines);
}
