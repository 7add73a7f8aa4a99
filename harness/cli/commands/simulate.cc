// cylon simulate
#include "harness/cli/asked.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/states_csv.h"

#include "harness/core/input_error.h"
#include "harness/core/measure.h"
#include "harness/core/observable.h"
#include "harness/core/recording.h"
#include "harness/process/client.h"
#include "harness/process/interruption.h"
#include "harness/scenario/input.h"
#include "reports/csv.h"

#include <fmt/format.h>

#include <cmath>
#include <iostream>
#include <iterator>
#include <numeric>
#include <set>

namespace cylon::cli {
namespace {

struct Options {
  Asked asked;
  std::string dt, out = "-", account;
  std::vector<std::string> at_words;
  std::vector<double> at;  // those of the words
  double every = 0, timeout = 60;
  bool nearest = false;
};

// The step at time t [s]; off the grid only where --nearest allows it.
std::int64_t step_at(double t, double dt, std::int64_t last, bool nearest) {
  const double ratio = t / dt, step = std::round(ratio);
  if (!(t >= 0) || step > static_cast<double>(last) * (1 + 1e-12))
    throw core::InputError(fmt::format("--at {}: must lie in [0, {}] s", t, static_cast<double>(last) * dt));
  if (!nearest && std::abs(ratio - step) > 1e-9 * std::max(1.0, ratio))
    throw core::InputError(
        fmt::format("--at {}: is not a multiple of the step {} s; the nearest is {} s (or use --nearest)", t,
                    dt, step * dt));
  return static_cast<std::int64_t>(step);
}

std::string csv(const core::Scene& scene, const core::Recording& recording,
                const std::set<std::int64_t>& wanted) {
  std::string text = fmt::format("{}\n", states_header);
  const auto to = std::back_inserter(text);
  std::vector<std::string> names;
  for (const core::Body& body : scene.bodies) names.push_back(reports::csv_field(body.name));
  for (std::size_t i = 0; i < recording.steps.size(); ++i) {
    if (!wanted.empty() && !wanted.contains(recording.steps[i])) continue;
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const core::BodyState& s = recording.states[i][b];
      fmt::format_to(to, "{:.17g},{},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g},{:.17g}",
                     recording.time(i), names[b], s.position.x(), s.position.y(), s.position.z(),
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
        fmt::format("--every {}: is not a multiple of the step {} s; the nearest is {} s (or use --nearest)",
                    options.every, dt, steps * dt));
  return static_cast<std::int64_t>(std::min(steps, 9e15));
}

// The grid of the printed times.  An error-controlled integrator needs no step: without --dt the times that
// are asked for make the grid, their greatest common divisor in nanoseconds.
double grid(const Options& options, const scenario::Scenario& scenario) {
  if (!options.dt.empty()) return scenario::parse_step(options.dt, "--dt");
  if (options.asked.tolerance == 0) return scenario.step;
  if (options.every > 0) return options.every;
  std::int64_t divisor = 0;  // [ns]
  for (const double t : options.at) {
    const double ns = std::round(1e9 * t);
    if (!(t >= 0) || t > scenario.duration || std::abs(1e9 * t - ns) > 1e-6 * std::max(1.0, ns))
      return scenario.step;
    divisor = std::gcd(divisor, static_cast<std::int64_t>(ns));
  }
  if (divisor == 0) return scenario.step;
  const double dt = 1e-9 * static_cast<double>(divisor);
  constexpr double most = 1e6;  // samples
  if (scenario.duration / dt > most)
    throw core::InputError(
        fmt::format("--at: the times have no common step larger than {} s; set --dt, or round the times",
                    scenario.duration / most));
  return dt;
}

// Where works and kinetic energy, both seen from the scene's frame, do not balance.
void require_balance(const core::Scene& scene) {
  for (const core::Force& force : scene.forces)
    if (const auto* thrust = std::get_if<core::Thrust>(&force); thrust && thrust->mass_rate != 0)
      throw core::InputError("--account: a mass changes, and what leaves takes kinetic energy with it");
  if (scene.frame && scene.frame->turns())
    throw core::InputError("--account: the frame turns, and works are those of the inertial frame");
}

double kinetic_energy(const core::Scene& scene, const core::State& state) {
  core::Values values;
  core::evaluate({.quantity = core::Quantity::kinetic_energy}, scene, state, values);
  return values.front().x();
}

// The works since t = 0, and what of the kinetic energy they do not explain: the works of contacts, limits and dry friction,
// joints that move, and the error of the motion.
std::string balance_csv(const core::Scene& scene, const core::Recording& recording) {
  std::string text = "entry,joules\n";
  const auto row = [&](const std::string& entry, double joules) {
    text += fmt::format("{},{:.17g}\n", reports::csv_field(entry), joules);
  };
  double sum = 0;
  for (const core::Work& w : recording.works) row(w.force, w.work), sum += w.work;
  const double gained =
      kinetic_energy(scene, recording.states.back()) - kinetic_energy(scene, recording.states.front());
  row("all forces", sum);
  row("kinetic energy gained", gained);
  row("gained without a force", gained - sum);
  return text;
}

// What no law of motion gives, or "".
std::string nonsense(const core::Recording& recording) {
  if (const auto bad = core::first_bad_step(recording))
    return fmt::format("non-finite: states are NaN or infinite from {} s on",
                       static_cast<double>(*bad) * recording.dt);
  constexpr double light = 299'792'458;  // [m/s]
  for (std::size_t i = 0; i < recording.states.size(); ++i)
    for (const core::BodyState& body : recording.states[i])
      if (body.velocity.norm() > light)
        return fmt::format("unstable: a body is faster than light at {} s", recording.time(i));
  return "";
}

int simulate(const Context& context, const Options& options) {
  if (options.account == "-" && options.out == "-")
    throw core::InputError("--account -: stdout has the states; give them another place by --out");
  require_writable(std::vector<std::string>{options.out, options.account});
  const scenario::Scenario scenario = scenario::read(find_scenario(context, options.asked.file));
  process::EngineChoice engine = choose(context, options.asked);
  if (!options.account.empty()) {
    require_option(engine, "--account", "account");
    require_balance(scenario.scene);
    engine.options["account"] = "yes";
  }
  const double dt = grid(options, scenario);
  const bool own_grid = options.dt.empty() && dt != scenario.step;

  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = dt;
  request.setup.tolerance = options.asked.tolerance;
  try {
    // A grid that the times made need not meet the end of the scenario.
    request.steps = own_grid ? static_cast<std::int64_t>(std::floor(scenario.duration / dt * (1 + 1e-12)))
                             : core::whole_steps(scenario.duration, dt);
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
  const process::Interruptible until_told;
  const process::RunOutcome outcome = process::run(engine, request, {.run_seconds = options.timeout});
  if (outcome.recording) {
    write_whole(options.out, csv(scenario.scene, *outcome.recording, wanted));
    if (!options.account.empty())
      write_whole(options.account, balance_csv(scenario.scene, *outcome.recording));
    for (const std::string& remark : outcome.recording->remarks)
      std::cerr << plain_line(fmt::format("{}: {}", options.asked.engine, remark)) << '\n';
  }
  if (!outcome.stderr_tail.empty())
    std::cerr << plain(outcome.stderr_tail) << (outcome.stderr_tail.ends_with('\n') ? "" : "\n");
  if (outcome.status != results::Status::pass) return report_failure(options.asked.engine, outcome);
  const std::string finding = nonsense(*outcome.recording);
  if (finding.empty()) return ok;
  std::cerr << plain_line(fmt::format("{}: {}; try a smaller step or another integrator",
                                      options.asked.engine, finding))
            << '\n';
  return differs;
}

}  // namespace

Command add_simulate(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  add_asked(app, options->asked);
  add_step_option(app, options->dt);
  const Option at = add_times_option(app, options->at_words);
  app.add_option("--every", options->every,
                 "Print every S seconds, and the end of the scenario (of a run with --tolerance and without "
                 "--dt: multiples of S alone)")
      ->type_name("S")
      ->excludes(at)
      ->check(positive(1e9));
  app.add_flag("--nearest", options->nearest, "Use the nearest step for a time between two steps");
  app.add_option("--out", options->out, "CSV file, written completely or not at all; - is stdout")
      ->type_name("FILE")
      ->capture_default_str();
  app.add_option("--account", options->account,
                 "Write the work of each force from start to end [J] as CSV, and the kinetic energy gained "
                 "(in-house engine); - is stdout")
      ->type_name("FILE");
  add_timeout_option(app, options->timeout);
  return [=, &context] {
    options->at = times_of_words(options->at_words);
    return simulate(context, *options);
  };
}

}  // namespace cylon::cli
