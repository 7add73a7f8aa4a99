// What a given error costs: this engine beside Bullet and ODE on the smooth scenes S4 to S8, in one run.
//   engine_bench [WORD…]      only the scenes whose name contains a word
// Error: the largest at T/4, T/2, 3T/4 and T against closed forms.  Cost: thread CPU time of the stepping and
// of those four samples (the workers time their steps alone), the smallest of several runs, references and
// this engine in turn.  `ours`: the integrator and the step that reach the error for the least, chosen
// knowing the truth; the next three steps of the ladder must reach it too; where the plan knows a closed
// form that costs less, that, and the integrator beside it (`in steps`) with its own ratios.  `default`:
// integrator auto, told nothing but the tolerance, its setting up and its second run included.  References:
// each engine's adapter with its default path, its step halved until the error is reached, then once more
// by 1/sqrt 2; the cheaper of its precisions.
#include "bench/own_run.h"
#include "bench/reference_run.h"
#include "bench/smooth_scenes.h"
#include "harness/scenario/scenario.h"
#include "reference/exact/catalogue.h"
#include "reference/simulators/in_house/in_house_model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>

namespace cylon::bench {
namespace {

void show(const char* who, const Run& r, double duration) {
  fmt::print("    {:<9} {:<22} h = {:<10.4g} {:>9.2g} {:>13.2f}\n", who, r.how, duration / r.steps, r.error,
             1e6 * r.cpu);
}

// `stepped`: of the integrator that stands beside a closed form.
void verdict(const char* whom, double theirs, double ours, double untuned, double stepped, double target) {
  const auto met = [&](double cost) { return theirs / cost >= target ? "met" : "NOT MET"; };
  fmt::print("    vs {:<6} {:>9.0f}x", whom, theirs / ours);
  if (target > 0) fmt::print("  target {:>6.0f}x  {}", target, met(ours));
  if (std::isfinite(untuned)) fmt::print("  (default: {:.0f}x)", theirs / untuned);
  if (std::isfinite(stepped)) {
    fmt::print("  (in steps: {:.0f}x{}{})", theirs / stepped, target > 0 ? " " : "",
               target > 0 ? met(stepped) : "");
  }
  fmt::print("\n");
}

void compare(const Case& c, const std::vector<process::EngineRow>& rows) {
  const auto scenario = scenario::parse(
      fmt::format(
          "title = \"Bench\"\nstory = \"Bench\"\nduration = {}\nstep = 0.001\n{}[[claim]]\nconserves = "
          "\"energy\"\ntolerance = {{ relative = 1, reason = \"rounding\" }}\n",
          c.duration, c.text),
      "bench.toml");
  Truth truth = chain_state;
  for (const exact::Solution& s : exact::catalogue())
    if (s.name == c.solution) truth = s.make(scenario.scene, c.duration).state;
  Subject subject{simulators::in_house_model(scenario.scene).model, c.duration, truth, c.error, {}};
  for (int k = 1; k <= samples; ++k) subject.truths.push_back(truth(c.duration * k / samples));
  const References references{scenario.scene, c.duration, subject, c.budget, {}};

  fmt::print("\n{}, {:g} s\n", c.name, c.duration);
  fmt::print("    {:<9} {:<22} {:<14} {:>9} {:>13}\n", "", "method", "step [s]", "error [" + c.unit + "]",
             "cost [us]");
  for (const Target& target : c.targets) {
    fmt::print("  error <= {:g} {}\n", target.error, c.unit);
    Run ours = tuned(subject, target.error);
    const auto exact_options = subject.options("auto", samples, target.error);
    Run untuned{fmt::format("auto, tolerance {:g}", target.error), samples};
    untuned.error = subject.error_of(exact_options, samples);
    untuned.cpu = subject.cost(exact_options, samples, true, 9);
    if (ours.how.empty()) {
      fmt::print("    no integrator reaches it\n");
      continue;
    }
    const bool closed = !engine::make_plan(subject.model, exact_options).integrator;
    double stepped = INFINITY;
    if (closed) {
      untuned.how = "closed form (auto)";
      if (untuned.cpu < ours.cpu) show("in steps", ours, c.duration), stepped = ours.cpu, ours = untuned;
    }
    struct Found {
      const char* name;
      std::optional<Run> run;
      process::EngineChoice choice;
      Run nearest;
      double target;
    };
    std::vector<Found> found = {{"Bullet", {}, {}, {}, target.bullet}, {"ODE", {}, {}, {}, target.ode}};
    const auto look = [&](Found& f, const std::string& id) {
      const auto choice = process::parse_engine(id, rows);
      const auto r = references.reach(choice, target.error, f.nearest);
      if (r && (!f.run || r->cpu < f.run->cpu)) f.run = r, f.choice = choice;
    };
    for (const std::string& id : c.bullets) look(found[0], id);
    for (const char* id : {"ode", "ode-quick"}) look(found[1], id);
    // in turn, so that all see the same machine
    for (int i = 0; i < 4; ++i) {
      for (Found& f : found)
        if (f.run)
          f.run->cpu =
              std::min(f.run->cpu, references.run(f.choice, static_cast<std::int64_t>(f.run->steps)).cpu);
      const bool is_closed = closed && ours.steps == samples;
      const auto o =
          subject.options(is_closed ? "auto" : ours.how, static_cast<std::int64_t>(ours.steps), target.error);
      ours.cpu = std::min(ours.cpu, subject.cost(o, static_cast<std::int64_t>(ours.steps), is_closed, 15));
      untuned.cpu = std::min(untuned.cpu, subject.cost(exact_options, samples, true, 5));
    }
    show("ours", ours, c.duration);
    show("default", untuned, c.duration);
    for (const Found& f : found) {
      if (f.run) {
        show(f.name, *f.run, c.duration);
      } else {
        fmt::print("    {:<9} not reached; best ", f.name);
        fmt::print("{:.2g} {} with {}, h = {:.2g} s, {:.3g} s of CPU\n", f.nearest.error, c.unit,
                   f.nearest.how, c.duration / f.nearest.steps, f.nearest.cpu);
      }
    }
    for (const Found& f : found)
      if (f.run)
        verdict(f.name, f.run->cpu, ours.cpu, untuned.error <= target.error ? untuned.cpu : INFINITY, stepped,
                f.target);
    if (ours.error > target.error) fmt::print("    NOT REACHED\n");
  }
  std::fflush(stdout);
}

}  // namespace
}  // namespace cylon::bench

int main(int argc, char** argv) {
  using namespace cylon;
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const auto rows = process::default_engines(std::filesystem::absolute(argv[0]).parent_path());
  for (const bench::Case& c : bench::cases()) {
    bool wanted = argc == 1;
    for (int i = 1; i < argc; ++i) wanted = wanted || c.name.find(argv[i]) != std::string::npos;
    if (wanted) bench::compare(c, rows);
  }
  fmt::print(
      "\nS8: Bullet is the cheaper of btMultiBody and of a btRigidBody on a ball joint, as the adapter runs "
      "them; "
      "btMultiBody's own RK4 is no path of the adapter and is not measured.\n");
}
