// cylon truth
#include "harness/cli/command_line.h"
#include "harness/cli/commands/app.h"
#include "harness/cli/options.h"
#include "harness/cli/output.h"
#include "harness/cli/progress.h"
#include "reference/certified/solve.h"

#include "harness/core/input_error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <iterator>

namespace cylon::cli {
namespace {

using certified::Ball;
using certified::BodyBalls;
using certified::Certificate;

constexpr int not_said = -1, usual_digits = 21;

struct Options {
  std::string file, out;
  std::vector<std::string> at_words;
  std::vector<double> at;  // those of the words
  double every = 0, radius = 1e-20;
  int digits = not_said, bits = 1024;
  bool conditioning = false;
};

// Those asked for, ascending, with the end after those of --every; 33 even ones where none are.
std::vector<double> times_of(const Options& options, double duration) {
  std::vector<double> times = options.at;
  constexpr int even = 32, most = 100'000;
  if (times.empty() && options.every == 0)
    for (int i = 0; i <= even; ++i) times.push_back(duration * i / even);
  if (options.every > 0) {
    const double count = std::floor(duration / options.every * (1 + 1e-12));
    if (count > most)
      throw core::InputError(
          fmt::format("--every {}: makes {:g} times, at most {} are printed", options.every, count, most));
    for (int i = 0; i <= static_cast<int>(count); ++i) times.push_back(std::min(duration, i * options.every));
    if (duration - times.back() > 1e-9 * duration) times.push_back(duration);
  }
  for (const double t : times)
    if (!(t >= 0 && t <= duration))
      throw core::InputError(fmt::format("--at {}: must lie in [0, {}] s, the duration", t, duration));
  std::ranges::sort(times);
  times.erase(std::unique(times.begin(), times.end()), times.end());
  return times;
}

// The numbers of one kind, separated and perhaps quoted; no more digits than the radius leaves.
template <std::size_t N>
std::string joined(const std::array<Ball, N>& balls, int digits, std::string_view separator, bool quoted) {
  std::string text;
  for (std::size_t i = 0; i < N; ++i)
    text += fmt::format("{}{}{}{}", i == 0 ? "" : separator, quoted ? "\"" : "", balls[i].text(digits),
                        quoted ? "\"" : "");
  return text;
}

std::string table(const core::Scene& scene, const Certificate& found, int digits) {
  std::string text = "time,body,px,py,pz,qw,qx,qy,qz,vx,vy,vz,wx,wy,wz,radius\n";
  for (const certified::Sampled& sample : found.samples)
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
      const BodyBalls& body = sample.bodies[b];
      fmt::format_to(std::back_inserter(text), "{},{},{},{},{},{},{:.2g}\n", sample.time,
                     scene.bodies[b].name, joined(body.position, digits, ",", false),
                     joined(body.orientation, digits, ",", false), joined(body.velocity, digits, ",", false),
                     joined(body.angular_velocity, digits, ",", false), body.radius());
    }
  return text;
}

std::string conditioning_table(const Certificate& found) {
  std::string text = "time,conditioning,radius\n";
  for (const certified::Sampled& sample : found.samples) {
    double radius = 0;
    for (const BodyBalls& body : sample.bodies) radius = std::max(radius, body.radius());
    fmt::format_to(std::back_inserter(text), "{},{:.6g},{:.2g}\n", sample.time, sample.conditioning, radius);
  }
  return text;
}

std::string impact_lines(const core::Scene& scene, const std::string& name, const Certificate& found,
                         int digits) {
  std::string text;
  for (const certified::ImpactBall& impact : found.impacts) {
    const auto& [body, other, plane] = impact.pair;
    fmt::format_to(std::back_inserter(text), "{}: {} strikes {} at {} s, radius {:.2g}\n", name,
                   scene.bodies[static_cast<std::size_t>(body)].name,
                   plane >= 0 ? scene.planes[static_cast<std::size_t>(plane)].name
                              : scene.bodies[static_cast<std::size_t>(other)].name,
                   impact.time.text(digits), impact.time.radius());
  }
  return text;
}

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    result += c;
  }
  return result + "\"";
}

// Format truth/1, as a scenario's follows = { file = … } reads it.  The rounding to so many digits counts
// too.
std::string json(const core::Scene& scene, const std::string& name, const Options& options,
                 const Certificate& found) {
  double largest = 0;
  for (const certified::Sampled& sample : found.samples)
    for (const BodyBalls& body : sample.bodies)
      for (const auto* balls : {&body.position, &body.velocity, &body.angular_velocity})
        for (const Ball& x : *balls) largest = std::max(largest, x.largest());
  const double rounding = std::max(1.0, largest) * std::pow(10.0, 1 - options.digits);
  std::string text = fmt::format(
      "{{\n\"schema\": \"truth/1\",\n\"name\": {},\n\"source\": {},\n", quoted(name),
      quoted(fmt::format("cylon truth {} --radius {:g} --digits {}", name, options.radius, options.digits)));
  const auto to = std::back_inserter(text);
  fmt::format_to(to, "\"agreement\": {{\"max_abs_diff\": \"{:.3g}\"}},\n", 1.01 * (found.radius + rounding));
  double worst = 0;
  for (const certified::Sampled& sample : found.samples) worst = std::max(worst, sample.conditioning);
  fmt::format_to(to, "\"rigorous\": {{\"max_radius\": \"{:.3g}\"}},\n", 1.01 * found.radius);
  if (found.impacts.empty())
    fmt::format_to(to,
                   "\"conditioning\": {{\"amplification_max_over_horizon\": \"{:.6g}\", "
                   "\"amplification_end\": \"{:.6g}\"}},\n",
                   worst, found.samples.back().conditioning);
  text += "\"bodies\": [";
  for (std::size_t b = 0; b < scene.bodies.size(); ++b)
    fmt::format_to(to, "{}{{\"id\": {}}}", b ? ", " : "", quoted(scene.bodies[b].name));
  text += "],\n\"t\": [";
  for (std::size_t k = 0; k < found.samples.size(); ++k)
    fmt::format_to(to, "{}\"{}\"", k ? ", " : "", found.samples[k].time);
  text += "],\n\"trajectory\": {";
  for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
    fmt::format_to(to, "{}\n  {}: {{", b ? "," : "", quoted(scene.bodies[b].name));
    const auto column = [&](const char* key, auto member, bool first) {
      fmt::format_to(to, "{}\n   \"{}\":\n   [", first ? "" : ",", key);
      for (std::size_t k = 0; k < found.samples.size(); ++k)
        fmt::format_to(to, "{}[{}]", k ? ",\n    " : "",
                       joined(found.samples[k].bodies[b].*member, options.digits, ",", true));
      text += "]";
    };
    column("position", &BodyBalls::position, true);
    column("velocity", &BodyBalls::velocity, false);
    column("orientation", &BodyBalls::orientation, false);
    column("angular_velocity", &BodyBalls::angular_velocity, false);
    text += "}";
  }
  return text + "}\n}\n";
}

int truth(const Context& context, Options options) {
  if (options.conditioning && options.out.empty() && options.digits != not_said)
    throw core::InputError(
        "--digits: --conditioning prints none of these numbers; give --out, or leave it out");
  if (options.digits == not_said) options.digits = usual_digits;
  if (!options.out.empty()) require_writable(options.out);
  const scenario::Scenario scenario = scenario::read(find_scenario(context, options.file));
  const std::vector<double> times = times_of(options, scenario.duration);
  Certificate found;
  const auto show = [&](const certified::Reached& reached) {
    show_progress(context.progress,
                  fmt::format("{}: {:.4g} of {:.4g} s, {} steps, {} bits", plain_line(scenario.name),
                              reached.time, times.back(), reached.steps, reached.bits));
  };
  try {
    found =
        certified::certify(scenario.scene, times, {options.radius, options.bits}, certified::exactly, show);
    show_progress(context.progress, "");
  } catch (const core::OutOfDomain& error) {
    show_progress(context.progress, "");
    throw core::InputError(fmt::format("{}: {}", scenario.name, error.what()));
  }
  if (options.conditioning && !found.impacts.empty())
    throw core::InputError(fmt::format(
        "{}: --conditioning: there is an impact at {:.6g} s, and error growth is not computed across impacts",
        scenario.name, found.impacts.front().time.middle()));
  if (options.conditioning)
    std::cout << conditioning_table(found);
  else if (options.out.empty())
    std::cout << plain(table(scenario.scene, found, options.digits));
  if (!options.out.empty()) write_whole(options.out, json(scenario.scene, scenario.name, options, found));
  std::cerr << impact_lines(scenario.scene, plain_line(scenario.name), found, options.digits);
  std::cerr << plain_line(fmt::format("{}: radius {:.2g} proven, {} bits, {} step{}", scenario.name,
                                      found.radius, found.bits, found.steps, found.steps == 1 ? "" : "s"))
            << '\n';
  if (found.reached) return ok;
  std::cerr << plain_line(fmt::format("{}: {}; try a larger --bits", scenario.name, found.reason)) << '\n';
  return inconclusive;
}

}  // namespace

Command add_truth(App& app, const Context& context) {
  const auto options = std::make_shared<Options>();
  app.add_option("file", options->file,
                 "Scenario file, or the name of a shipped scenario: smooth motion, or impacts of spheres")
      ->type_name("FILE")
      ->required();
  const Option at = add_times_option(app, options->at_words);
  app.add_option(
         "--every", options->every,
         "Print every S seconds, and the end of the scenario. Default without --at: 33 evenly spaced times")
      ->type_name("S")
      ->excludes(at)
      ->check(positive(1e9));
  app.add_option("--radius", options->radius,
                 "Error bound to prove for every number, in its SI unit; exit code 3 where it is not reached")
      ->capture_default_str()
      ->check(in_range(1e-250, 1.0));
  app.add_option("--digits", options->digits, "Significant digits to print")
      ->default_str(std::to_string(usual_digits))
      ->check(in_range(3, 300));
  app.add_option("--bits", options->bits, "Largest precision to try [bits]")
      ->capture_default_str()
      ->check(in_range(128, 100000));
  app.add_flag("--conditioning", options->conditioning,
               "Print instead how much an error of the initial state has grown at each time");
  app.add_option("--out", options->out,
                 "JSON file in the format truth/1, for follows = { file = … }; - is stdout")
      ->type_name("FILE");
  return [=, &context] {
    options->at = times_of_words(options->at_words);
    return truth(context, *options);
  };
}

}  // namespace cylon::cli
