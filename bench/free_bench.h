// Many bodies that fly freely and never meet, in the precision that this is built for, beside Bullet and ODE
// in one run: ns per body and step, thread CPU time, the smallest of several runs in turn.  Boxes that spin
// at 1 to 2 rad/s, steps of 1/60 s; a speed never travels without its error: the largest turn by which an
// orientation misses the closed form after 1 s.  References: the adapters' free bodies, which have no shape
// and nothing to collide with, one step per step, the faster of each engine's paths.  `step`: one step after
// another, each leaving all states in memory; `run of 64`: 64 steps between looks, block by block.
#pragma once

#include "bench/cpu_time.h"
#include "bench/free_cloud.h"
#include "engine/free_bodies.h"
#include "engine/make_stepper.h"
#include "harness/process/client.h"
#include "harness/scenario/scenario.h"

#include <fmt/format.h>
#include <malloc.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>
#include <vector>

namespace cylon::bench {

using engine::Real;

constexpr double dt = 1. / 60;
constexpr bool is_float = sizeof(Real) == 4;

struct Kind {
  const char* name;
  double moments[3];
  bool spins;
};
inline constexpr Kind points = {"points", {0.2, 0.3, 0.4}, false},
                      symmetric = {"symmetric", {0.2, 0.2, 0.4}, true},
                      asymmetric = {"asymmetric", {0.2, 0.3, 0.4}, true};

inline scenario::Scenario scenario_of(const Kind& kind, std::size_t count) {
  return scenario::parse(fmt::format(R"(
title = "Free bodies"
story = "Bodies fly freely."
duration = 1.0
step = "1/60"
gravity = [0, -9.81, 0]
{}[[claim]]
conserves = "energy"
tolerance = {{ relative = 1, reason = "rounding" }}
)",
                                     free_cloud(static_cast<std::int64_t>(count),
                                                fmt::format("[{}]", fmt::join(kind.moments, ", ")),
                                                kind.spins ? "[0.3, 1.1, -0.4]" : "[0, 0, 0]")),
                         "free_bodies.toml");
}

inline engine::Model model_of(const core::Scene& scene) {
  engine::Model model;
  model.forces.gravity = {0, Real(-9.81), 0};
  for (const core::Body& b : scene.bodies) {
    model.bodies.push_back(engine::make_body(static_cast<Real>(b.mass), b.inertia.cast<Real>()));
    model.motions.push_back(
        engine::make_motion(model.bodies.back(), b.initial.position.cast<Real>(),
                            engine::Quaternion(b.initial.orientation.cast<Real>().coeffs()),
                            b.initial.velocity.cast<Real>(), b.initial.angular_velocity.cast<Real>()));
    model.shapes.emplace_back();
    model.surfaces.push_back(engine::no_surface);
  }
  return model;
}

// Closed form after 1 s, by integrator auto.
inline std::vector<engine::Motion> exact(const engine::Model& model) {
  engine::Options options;
  options.dt = 1;
  const auto stepper = engine::make_stepper(model, options, engine::make_plan(model, options));
  stepper->step();
  std::vector<engine::Motion> motions;
  stepper->read(motions);
  return motions;
}

template <class Orientation>
double miss(const Orientation& orientation, const engine::Motion& truth) {
  const Eigen::Quaterniond a = orientation.normalized(), b = truth.orientation.template cast<double>();
  return 2 * std::asin(std::min(1.0, (a.conjugate() * b.normalized()).vec().norm()));
}

struct Reference {
  std::string id;
  double ns = 1e30, error = 0;
  std::string failure;
};

inline void run(Reference& r, const process::EngineChoice& choice, const core::Scene& scene,
                std::int64_t steps, const std::vector<engine::Motion>& truth) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = steps;
  request.every = steps;
  process::Limits limits;
  limits.run_seconds = 120;
  const auto outcome = process::run(choice, request, limits);
  if (!outcome.recording) {
    r.failure = outcome.reason;
    return;
  }
  r.ns = std::min(r.ns, 1e9 * outcome.recording->cpu_seconds /
                            (static_cast<double>(steps) * static_cast<double>(scene.bodies.size())));
  if (steps != 60) return;
  for (std::size_t i = 0; i < truth.size(); ++i)
    r.error = std::max(r.error, miss(outcome.recording->states.back()[i].orientation, truth[i]));
}

struct Own {
  double step = 1e30, run = 1e30, error = 0;
};

inline void run(Own& own, const engine::Model& model, const std::vector<engine::Motion>& truth) {
  engine::Options options;
  options.integrator = "velocity-verlet", options.dt = dt;
  const engine::Plan plan = engine::make_plan(model, options);
  const auto stepper = engine::make_stepper(model, options, plan);
  std::vector<engine::Motion> motions;
  stepper->advance(60);
  stepper->read(motions);
  for (std::size_t i = 0; i < truth.size(); ++i)
    own.error = std::max(own.error, miss(motions[i].orientation.cast<double>(), truth[i]));
  const double count = static_cast<double>(model.bodies.size());
  const int repeats = std::max(2, static_cast<int>(2e5 / count));
  for (int batch = 0; batch < 10; ++batch) {
    double start = cpu_now();
    for (int i = 0; i < repeats; ++i) stepper->step();
    own.step = std::min(own.step, 1e9 * (cpu_now() - start) / (repeats * count));
    start = cpu_now();
    const int runs = std::max(1, repeats / 16);
    for (int i = 0; i < runs; ++i) stepper->advance(64);
    own.run = std::min(own.run, 1e9 * (cpu_now() - start) / (64 * runs * count));
  }
}

inline void ratio(const char* what, double own, const char* whom, const Reference& theirs, double target) {
  fmt::print("    {:<10} vs {:<7} {:>7.0f}x", what, whom, theirs.ns / own);
  if (target > 0) fmt::print("  target {:>4.0f}x  {}", target, theirs.ns / own >= target ? "met" : "NOT MET");
  fmt::print("\n");
}

inline void compare(const Kind& kind, std::size_t count, double bullet_target, double ode_target,
                    const std::vector<process::EngineRow>& rows) {
  const auto scenario = scenario_of(kind, count);
  const engine::Model model = model_of(scenario.scene);
  const auto truth = exact(model);
  Own own;
  std::vector<Reference> references;
  const bool many = count > 10'000;  // then only those that are faster at 1000, and no second run of theirs
  for (const char* id : {"bullet-float", "bullet", "ode", "ode-quick"})
    if (!many || id == std::string("bullet-float") || id == std::string("ode"))
      references.push_back({id, 1e30, 0, ""});
  for (int round = 0; round < 3; ++round) {
    run(own, model, truth);
    for (Reference& r : references)
      if (r.failure.empty() && !(many && round > 0))
        run(r, process::parse_engine(r.id, rows), scenario.scene, many ? 12 : 60, truth);
  }
  fmt::print("\n{} {} bodies, {}\n", count, kind.name, is_float ? "float" : "double");
  fmt::print("    {:<28} {:>9} ns  misses {:.2g} rad\n", "ours, step", fmt::format("{:.3g}", own.step),
             own.error);
  fmt::print("    {:<28} {:>9} ns  misses {:.2g} rad\n", "ours, run of 64", fmt::format("{:.3g}", own.run),
             own.error);
  const auto faster = [&](const char* whose) {
    Reference best;
    for (const Reference& r : references)
      if (r.id.starts_with(whose) && r.ns < best.ns) best = r;
    return best;
  };
  for (const Reference& r : references) {
    if (r.failure.empty())
      fmt::print("    {:<28} {:>9} ns{}\n", r.id, fmt::format("{:.3g}", r.ns),
                 many ? std::string() : fmt::format("  misses {:.2g} rad", r.error));
    else
      fmt::print("    {:<28} {}\n", r.id, r.failure);
  }
  for (const auto& [what, ns] : {std::pair{"step", own.step}, std::pair{"run of 64", own.run}}) {
    ratio(what, ns, "Bullet", faster("bullet"), bullet_target);
    ratio(what, ns, "ODE", faster("ode"), ode_target);
  }
}

// a + 3 b to a: read to written as 2 to 1, as a step of FreeBodies does.
inline double bandwidth() {
  std::vector<double> a(16'000'000, 1), b(16'000'000, 2);
  double best = 1e30;
  for (int i = 0; i < 8; ++i) {
    const double start = cpu_now();
    for (std::size_t k = 0; k < a.size(); ++k) a[k] += 3 * b[k];
    best = std::min(best, cpu_now() - start);
  }
  return 24e-9 * static_cast<double>(a.size()) / best;
}

inline double resident() {
  long pages = 0, size = 0;
  if (std::FILE* f = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(f, "%ld %ld", &size, &pages) != 2) pages = 0;
    std::fclose(f);
  }
  return static_cast<double>(pages) * 4096;
}

inline void million(const Kind& kind) {
  constexpr std::size_t count = 1'000'000;
  const engine::Body body = engine::make_body(
      Real(1.5),
      engine::Vector3(Real(kind.moments[0]), Real(kind.moments[1]), Real(kind.moments[2])).asDiagonal());
  const auto given = [&](std::size_t i) {
    const Real x = static_cast<Real>(i % 1000), w = 1 + static_cast<Real>(i % 7) / 7;
    return engine::FreeBodies::Given{
        body, engine::make_motion(body, {x, 2, 3}, engine::Quaternion(1, Real(0.2), Real(0.3), Real(0.4)),
                                  {w, -w, Real(0.3)}, engine::Vector3(Real(0.3), Real(1.1), Real(-0.4)) * w)};
  };
  malloc_trim(0);
  const double before = resident();
  engine::FreeBodies bodies(count, given, {0, Real(-9.81), 0}, *engine::find_integrator("velocity-verlet"),
                            dt);
  bodies.step();
  const double bytes = (resident() - before) / count;
  double ns = 1e30, in_runs = 1e30, speed = 0;
  for (int i = 0; i < 4; ++i) {
    speed = std::max(speed, bandwidth());
    for (int k = 0; k < 4; ++k) {
      const double start = cpu_now();
      bodies.step();
      ns = std::min(ns, (cpu_now() - start) * 1e9 / count);
    }
    const double start = cpu_now();
    bodies.advance(64);
    in_runs = std::min(in_runs, (cpu_now() - start) * 1e9 / (64. * count));
  }
  // read: p, s, q, L and four constants: 17; written: p, q and the one s that gravity changes: 8
  const double moved = 25 * sizeof(Real);
  fmt::print("\n1000000 {} bodies, {}\n", kind.name, is_float ? "float" : "double");
  fmt::print(
      "    step {:.3g} ns = {:.0f} bytes at {:.1f} GB/s, {:.0f} % of the {:.1f} GB/s of a += 3 b  (target 70 "
      "%)  {}\n",
      ns, moved, moved / ns, 100 * moved / ns / speed, speed, moved / ns >= 0.7 * speed ? "met" : "NOT MET");
  fmt::print("    run of 64: {:.3g} ns, {:.0f} % of what memory allows step by step\n", in_runs,
             100 * moved / in_runs / speed);
  fmt::print("    resident {:.0f} bytes a body  (target 300)  {}\n", bytes, bytes <= 300 ? "met" : "NOT MET");
}

inline int free_bench(const char* program) {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto rows = process::default_engines(std::filesystem::absolute(program).parent_path());
  fmt::print("8 free bodies: velocity-verlet, h = 1/60 s; targets vs Bullet for float, vs ODE for double\n");
  for (const Kind& kind : {symmetric, asymmetric}) {
    compare(kind, 1000, is_float ? 50 : 0, is_float ? 0 : 17, rows);
    compare(kind, 100'000, is_float ? 90 : 0, is_float ? 0 : 30, rows);
    million(kind);
  }
  if (is_float) return 0;
  fmt::print("\n11 point masses: velocity-verlet, h = 1/60 s\n");
  compare(points, 1000, 750, 450, rows);
  compare(points, 100'000, 400, 250, rows);
  return 0;
}

}  // namespace cylon::bench
