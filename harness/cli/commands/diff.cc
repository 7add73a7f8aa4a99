// cylon diff: where two runs of one scenario differ first.
#include "harness/cli/asked.h"
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/sparkline.h"
#include "harness/cli/states_csv.h"
#include "harness/cli/workers.h"

#include "harness/core/input_error.h"
#include "harness/core/recording.h"
#include "harness/process/interruption.h"
#include "harness/scenario/input.h"
#include "harness/study/divergence.h"
#include "reports/json.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>
#include <limits>

namespace cylon::cli {
namespace {

using core::Trajectory;
using nlohmann::ordered_json;
using study::Curve;

struct Options {
  std::string file, a, b, dt, csv;
  double tolerance = 1e-3, timeout = 60;
  bool json = false;
  Brought brought;
};

constexpr double same_time = 1e-9;  // relative to the step, as everywhere

/// One of the two runs: an engine at a step, or states from a file.
struct Side {
  std::string name;
  process::EngineChoice engine;
  double dt = 0;              // [s]; 0: a file
  std::vector<double> times;  // of a file
  Trajectory motion;
};

/// An engine came to nothing; the message stands on stderr.
struct Failed {
  int code;
};

Side side(const Context& context, const Options& options, const scenario::Scenario& scenario,
          const std::string& word) {
  Side result{word, {}, 0, {}, {}};
  if (word.ends_with(".csv")) {
    result.motion = read_states(word, scenario.scene);
    result.times = result.motion.time;
    return result;
  }
  const std::size_t at = word.rfind('@');
  const std::string step = at == std::string::npos ? options.dt : word.substr(at + 1);
  result.engine = process::parse_engine(word.substr(0, at), with_brought(context, options.brought));
  result.dt =
      step.empty() ? scenario.step : scenario::parse_step(step, at == std::string::npos ? "--dt" : word);
  try {
    core::whole_steps(scenario.duration, result.dt);
  } catch (const std::invalid_argument& error) {
    throw core::InputError(fmt::format("{}: the duration of {}: {}", word, scenario.name, error.what()));
  }
  return result;
}

// Whether a side has a state at t.
bool has(const Side& side, double t) {
  if (side.dt > 0) {
    const double steps = t / side.dt;
    return std::abs(steps - std::round(steps)) <= same_time * std::max(1.0, steps);
  }
  const auto at = std::lower_bound(side.times.begin(), side.times.end(), t * (1 - same_time));
  return at != side.times.end() && *at <= t * (1 + same_time);
}

// The times at which both sides have states [s].
std::vector<double> common_times(const Side& a, const Side& b, double duration) {
  std::vector<double> times;
  if (a.dt > 0 && b.dt > 0) {
    const auto multiples = study::common_multiple(a.dt, b.dt);
    if (!multiples)
      throw core::InputError(
          fmt::format("{} and {}: the steps {} s and {} s have no common multiple within 10000 of them",
                      a.name, b.name, a.dt, b.dt));
    const std::int64_t last = core::whole_steps(duration, a.dt) / multiples->of_a;
    for (std::int64_t k = 0; k <= last; ++k) times.push_back(static_cast<double>(k * multiples->of_a) * a.dt);
    return times;
  }
  const Side &file = a.dt > 0 ? b : a, &other = a.dt > 0 ? a : b;
  for (const double t : file.times)
    if (t <= duration * (1 + same_time) && has(other, t)) times.push_back(t);
  if (times.empty())
    throw core::InputError(fmt::format("{} and {}: the runs have no common time", a.name, b.name));
  return times;
}

// The side's states at those times, which it has.
Trajectory states_at(const Side& side, const scenario::Scenario& scenario, std::span<const double> times,
                     double timeout) {
  Trajectory result;
  result.time.assign(times.begin(), times.end());
  if (side.dt == 0) {
    for (const double t : times) {
      const auto at = std::lower_bound(side.times.begin(), side.times.end(), t * (1 - same_time));
      result.states.push_back(side.motion.states[static_cast<std::size_t>(at - side.times.begin())]);
    }
    return result;
  }
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = side.dt;
  for (const double t : times) request.at.push_back(std::llround(t / side.dt));
  request.steps = request.at.back();
  request.every = std::max<std::int64_t>(1, request.steps);
  process::RunOutcome outcome = process::run(side.engine, request, {.run_seconds = timeout});
  if (!outcome.stderr_tail.empty())
    std::cerr << plain(outcome.stderr_tail) << (outcome.stderr_tail.ends_with('\n') ? "" : "\n");
  if (!outcome.recording) throw Failed{report_failure(side.name, outcome)};
  // The start is always kept, asked for or not.
  core::Recording& recording = *outcome.recording;
  for (std::size_t i = request.at.front() == 0 ? 0 : 1; i < recording.states.size(); ++i)
    result.states.push_back(std::move(recording.states[i]));
  return result;
}

struct Found {
  std::vector<double> times;
  std::vector<Curve> curves;
  std::size_t every = 1;  // Of the common times, before it was looked closer.
};

// At most so many states of a body are held; more are thinned evenly.
constexpr std::size_t most_states = 1'000'000;

Found compare(const Options& options, const scenario::Scenario& scenario, const Side& a, const Side& b) {
  const std::vector<double> all = common_times(a, b, scenario.duration);
  Found found;
  found.every = (all.size() * scenario.scene.bodies.size() + most_states - 1) / most_states;
  const auto at = [&](const std::vector<double>& times) {
    const Trajectory ours = states_at(a, scenario, times, options.timeout),
                     theirs = states_at(b, scenario, times, options.timeout);
    found.times = times;
    found.curves = study::divergence(scenario.scene, scenario.duration, ours, theirs, options.tolerance);
  };
  std::vector<double> thinned;
  for (std::size_t i = 0; i < all.size(); i += found.every) thinned.push_back(all[i]);
  at(thinned);
  const Curve* first = study::first_to_part(found.curves);
  if (found.every == 1 || !first || *first->first == 0) return found;
  // Once more, with every time between the last sample that agreed and the first that did not.
  const std::size_t to = *first->first;
  std::vector<double> closer(thinned.begin(), thinned.begin() + static_cast<std::ptrdiff_t>(to));
  for (std::size_t i = (to - 1) * found.every + 1; i < to * found.every; ++i) closer.push_back(all[i]);
  closer.insert(closer.end(), thinned.begin() + static_cast<std::ptrdiff_t>(to), thinned.end());
  at(closer);
  return found;
}

std::string body_name(const core::Scene& scene, int body) {
  return body < 0 ? "" : scene.bodies[static_cast<std::size_t>(body)].name;
}

// The steps that end at t, of those sides that make steps.
std::string steps_at(const Side& a, const Side& b, double t) {
  const auto step = [&](const Side& s) { return std::llround(t / s.dt); };
  if (a.dt > 0 && b.dt > 0)
    return step(a) == step(b) ? fmt::format(" (step {})", step(a))
                              : fmt::format(" (steps {} and {})", step(a), step(b));
  if (a.dt == 0 && b.dt == 0) return "";
  return fmt::format(" (step {} of {})", step(a.dt > 0 ? a : b), a.dt > 0 ? a.name : b.name);
}

std::string table(const Context& context, const scenario::Scenario& scenario, const Found& found) {
  std::string text = fmt::format("{:<18}{:<14}{:<24}{:<14}{:<20}log of the distance over time\n", "quantity",
                                 "apart from", "largest distance", "at", "allowed");
  const auto to = std::back_inserter(text);
  for (const Curve& c : found.curves) {
    const std::string body = plain_line(body_name(scenario.scene, c.body[c.largest]));
    const bool apart = c.distance[c.largest] != 0;
    fmt::format_to(to, "{:<18}{:<14}{:<24}{:<14}{:<20}", core::name(c.quantity),
                   c.first ? fmt::format("{:.6g} s", found.times[*c.first]) : "-",
                   fmt::format("{:.3g} {}", c.distance[c.largest], c.unit),
                   apart ? fmt::format("{:.6g} s", found.times[c.largest]) : "-",
                   fmt::format("{:.3g} {}", c.allowed, c.unit));
    std::vector<double> digits;  // zero is as good as 10^-18 of what is allowed
    const double least = c.allowed > 0 ? 1e-18 * c.allowed : std::numeric_limits<double>::min();
    for (const double d : c.distance) digits.push_back(std::log10(std::max(d, least)));
    text += apart ? sparkline(digits, 1, context.utf8, 24) : "-";
    if (apart && !body.empty() && scenario.scene.bodies.size() > 1) text += "  " + body;
    text += '\n';
  }
  return text;
}

// The recordings that end before the scene does, or "": what is missing agrees with nothing.
std::string ends_early(const scenario::Scenario& scenario, const Side& a, const Side& b) {
  std::string text;
  for (const Side* side : {&a, &b})
    if (side->dt == 0 && side->times.back() < scenario.duration * (1 - same_time))
      text += fmt::format("{} ends at {:.9g} s, the scene at {:.9g} s\n", side->name, side->times.back(),
                          scenario.duration);
  return text;
}

std::string heading(const scenario::Scenario& scenario, const Side& a, const Side& b, const Found& found) {
  const Curve* first = study::first_to_part(found.curves);
  if (!first)
    return fmt::format("{}: {} and {} agree at all {} common times", scenario.name, a.name, b.name,
                       found.times.size());
  const double t = found.times[*first->first], d = first->distance[*first->first];
  const int body = first->body[*first->first];
  return fmt::format("{}: {} and {} differ from {:.9g} s on{}: {}{} by {:.3g} {}, {:.3g} {} allowed",
                     scenario.name, a.name, b.name, t, steps_at(a, b, t), core::name(first->quantity),
                     body < 0 ? " of all bodies" : fmt::format(" of '{}'", body_name(scenario.scene, body)),
                     d, first->unit, first->allowed, first->unit);
}

using reports::number;

ordered_json to_json(const scenario::Scenario& scenario, const Options& options, const Found& found) {
  ordered_json curves = ordered_json::array();
  const auto sample = [&](const Curve& c, std::size_t i) {
    const int body = c.body[i];
    return ordered_json{
        {"quantity", core::name(c.quantity)},
        {"time", found.times[i]},
        {"body", body < 0 ? ordered_json(nullptr) : ordered_json(body_name(scenario.scene, body))},
        {"distance", number(c.distance[i])},
        {"allowed", c.allowed},
        {"unit", c.unit}};
  };
  for (const Curve& c : found.curves) {
    ordered_json distances = ordered_json::array();
    for (const double d : c.distance) distances.push_back(number(d));
    curves.push_back({{"quantity", core::name(c.quantity)},
                      {"first", c.first ? sample(c, *c.first) : ordered_json(nullptr)},
                      {"largest", sample(c, c.largest)},
                      {"distance", std::move(distances)}});
  }
  const Curve* first = study::first_to_part(found.curves);
  return {{"schema", 1},
          {"scenario", scenario.name},
          {"a", options.a},
          {"b", options.b},
          {"tolerance", options.tolerance},
          {"first", first ? sample(*first, *first->first) : ordered_json(nullptr)},
          {"time", found.times},
          {"curves", std::move(curves)}};
}

std::string csv(const Found& found) {
  std::string text = "time";
  for (const Curve& c : found.curves) text += fmt::format(",{}", core::name(c.quantity));
  text += '\n';
  for (std::size_t i = 0; i < found.times.size(); ++i) {
    text += fmt::format("{:.17g}", found.times[i]);
    for (const Curve& c : found.curves) text += fmt::format(",{:.17g}", c.distance[i]);
    text += '\n';
  }
  return text;
}

int diff(const Context& context, const Options& options) try {
  if (options.json && options.csv == "-")
    throw core::InputError("--csv -: stdout has the JSON of --json; give the CSV a file");
  if (!options.csv.empty()) require_writable(options.csv);
  const scenario::Scenario scenario = scenario::read(find_scenario(context, options.file));
  const Side a = side(context, options, scenario, options.a), b = side(context, options, scenario, options.b);
  const process::Interruptible until_told;
  const Found found = compare(options, scenario, a, b);
  if (!options.csv.empty()) write_whole(options.csv, csv(found));
  if (options.json) {
    std::cout
        << to_json(scenario, options, found).dump(2, ' ', true, nlohmann::json::error_handler_t::replace)
        << '\n';
  } else if (options.csv != "-") {
    std::cout << plain_line(heading(scenario, a, b, found)) << "\n\n" << table(context, scenario, found);
    if (found.every > 1)
      std::cout << fmt::format(
          "\n"
          "Only every {}th common time is compared, and every time near the first difference. A shorter "
          "difference in between is not found.\n",
          found.every);
  }
  const std::string early = ends_early(scenario, a, b);
  if (!early.empty()) std::cerr << early;
  return study::first_to_part(found.curves) || !early.empty() ? differs : ok;
} catch (const Failed& failed) {
  return failed.code;
}

}  // namespace

Command add_diff(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.footer(
      "Runs with different steps are compared at their common times.  Exit codes: 0 the runs agree, 1 they "
      "differ, or a file ends before the scene does.\n"
      "  cylon diff dzhanibekov bullet bullet/gyro=none\n"
      "  cylon diff heavy_top ode@1/60 ode@1/240\n"
      "  cylon diff gas in-house other_machine.csv --tolerance 0     the first bit that differs");
  app.add_option("file", options->file, "A scenario file, or the name of a shipped scenario")
      ->type_name("FILE")
      ->required();
  const char* what =
      "Engine, optional variant, optional step after '@': bullet/gyro=none@1/240; or a CSV file from `cylon "
      "simulate --out`";
  app.add_option("a", options->a, what)->type_name("RUN")->required();
  app.add_option("b", options->b, "The second run, in the same form")->type_name("RUN")->required();
  app.add_option("--dt", options->dt, "Step of runs without '@' [s]; default: the scenario's nominal step")
      ->type_name("S");
  app.add_option(
         "--tolerance", options->tolerance,
         "Allowed difference, relative to the length, speed and mass of the scene; 0: all bits must agree")
      ->type_name("T")
      ->capture_default_str()
      ->check(in_range(0.0, 1e300));
  app.add_flag("--json", options->json, "Print JSON, with the differences at every time");
  app.add_option("--csv", options->csv, "Write the differences at every time as CSV; - is stdout")
      ->type_name("FILE");
  add_timeout_option(app, options->timeout);
  add_brought_options(app, options->brought);
  return [=, &context] { return diff(context, *options); };
}

}  // namespace cylon::cli
