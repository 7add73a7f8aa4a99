// cylon simulate
#include "harness/cli/app.h"
#include "harness/cli/command_line.h"
#include "harness/cli/output.h"

#include "harness/core/input_error.h"
#include "harness/core/recording.h"
#include "harness/process/client.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <set>

namespace cylon::cli {
namespace {

struct Options {
  std::string file, engine = "in-house", integrator, dt, out = "-";
  std::vector<double> at;
  double every = 0, timeout = 60, tolerance = 0;
  bool nearest = false;
  std::vector<std::string> workers;
};

// The step at time t [s]; off the grid only where --nearest allows it.
std::int64_t step_at(double t, double dt, std::int64_t last, bool nearest) {
  const double ratio = t / dt, step = std::round(ratio);
  if (!(t >= 0) || step > static_cast<double>(last) * (1 + 1e-12))
    throw core::InputError(fmt::format("--at {}: must lie in [0, {}] s", t, static_cast<double>(last) * dt));
  if (!nearest && std::abs(ratio - step) > 1e-9 * std::max(1.0, ratio))
    throw core::InputError(
        fmt::format("--at {}: is not a multiple of the step {} s; the nearest is {} s (or say --nearest)", t,
                    dt, step * dt));
  return static_cast<std::int64_t>(step);
}

std::string csv(const core::Scene& scene, const core::Recording& recording,
                const std::set<std::int64_t>& wanted) {
  std::string text = "time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz\n";
  const auto to = std::back_inserter(text);
  for (std::size_t i = 0; i < recording.steps.size(); ++i) {
    if (!wanted.empty() && !wanted.contains(recording.steps[i])) continue;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const core::BodyState& s = recording.states[i][b];
      fmt::format_to(to, "{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}",
                     recording.time(i), scene.bodies[b].name, s.position.x(), s.position.y(), s.position.z(),
                     s.orientation.w(), s.orientation.x(), s.orientation.y(), s.orientation.z());
      fmt::format_to(to, ",{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}\n", s.velocity.x(), s.velocity.y(),
                     s.velocity.z(), s.angular_velocity.x(), s.angular_velocity.y(), s.angular_velocity.z());
    }
  }
  return text;
}

// The stride of --every S; 0 where it was not given.
std::int64_t stride(const Options& options, double dt) {
  const double ratio = options.every / dt, steps = std::max(1.0, std::round(ratio));
  if (options.every == 0) return 0;
  if (!options.nearest && std::abs(ratio - steps) > 1e-9 * std::max(1.0, ratio))
    throw core::InputError(
        fmt::format("--every {}: is not a multiple of the step {} s; the nearest is {} s (or say --nearest)",
                    options.every, dt, steps * dt));
  return static_cast<std::int64_t>(std::min(steps, 9e15));
}

int simulate(const Context& context, const Options& options) {
  if (options.tolerance != 0)
    throw core::InputError(
        "--tolerance: no engine here has an error-controlled scheme yet; give a step with --dt");
  require_writable(options.out);
  const scenarios::Scenario scenario = scenarios::load(find_scenario(context, options.file));
  const double dt = options.dt.empty() ? scenario.step : scenarios::parse_step(options.dt);
  process::EngineChoice engine =
      process::parse_engine(options.engine, with_workers(context, options.workers));
  if (!options.integrator.empty() && !engine.integrator.empty() && engine.integrator != options.integrator)
    throw core::InputError(
        fmt::format("--integrator {}: --engine {} states another", options.integrator, options.engine));
  if (!options.integrator.empty()) engine.integrator = options.integrator;

  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = dt;
  try {
    request.steps = core::whole_steps(scenario.duration, dt);
  } catch (const std::invalid_argument& error) {
    throw core::InputError(fmt::format("{}: the duration: {}", scenario.name, error.what()));
  }
  request.every = stride(options, dt);
  if (request.every == 0)
    request.every = core::sampling_stride(scenario.scene.bodies.size(), request.steps, dt, 0);
  std::set<std::int64_t> wanted;
  for (const double t : options.at) wanted.insert(step_at(t, dt, request.steps, options.nearest));
  if (!wanted.empty()) {
    request.every = std::max<std::int64_t>(1, request.steps);
    for (const std::int64_t step : wanted)
      if (step > 0) request.at.push_back(step);
  }
  const process::RunOutcome outcome = process::run(engine, request, {.run_seconds = options.timeout});
  if (outcome.recording) write_whole(options.out, csv(scenario.scene, *outcome.recording, wanted));
  if (!outcome.stderr_tail.empty())
    std::cerr << plain(outcome.stderr_tail) << (outcome.stderr_tail.ends_with('\n') ? "" : "\n");
  if (outcome.status == core::Status::pass) return ok;
  std::cerr << plain(fmt::format("{}: {}: {}\n", options.engine, core::name(outcome.status), outcome.reason));
  // An engine that is there and says that it cannot do this was asked for the wrong thing.
  return outcome.status == core::Status::unsupported && !outcome.engine.version.empty() ? bad_input
                                                                                        : harness_failure;
}

}  // namespace

Command add_simulate(CLI::App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file, "A scenario file, or the name of a shipped scenario")
      ->type_name("FILE")
      ->required();
  app.add_option("--engine", options->engine, "Engine id, with a variant after '/': bullet/gyro=none")
      ->type_name("ID")
      ->capture_default_str();
  app.add_option("--integrator", options->integrator,
                 "One of the engine's schemes, as `cylon engines` names them")
      ->type_name("NAME");
  app.add_option("--dt", options->dt, "Step [s], 0.001 or 1/60; the scenario's nominal step otherwise")
      ->type_name("S");
  app.add_option("--tolerance", options->tolerance,
                 "Error bound in place of a step, for error-controlled schemes")
      ->type_name("T");
  auto* at = app.add_option("--at", options->at, "Times to print [s], separated by commas: 0,0.5,1")
                 ->type_name("S")
                 ->delimiter(',');
  app.add_option("--every", options->every, "Print every S seconds")
      ->type_name("S")
      ->excludes(at)
      ->check(positive(1e9));
  app.add_flag("--nearest", options->nearest, "Take the nearest step for a time between steps");
  app.add_option("--out", options->out, "CSV file, written whole or not at all; - is stdout")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--timeout", options->timeout, "Seconds until the engine is stopped")
      ->type_name("S")
      ->capture_default_str()
      ->check(positive(1e6));
  add_worker_option(app, options->workers);
  return [=, &context] { return simulate(context, *options); };
}

}  // namespace cylon::cli
