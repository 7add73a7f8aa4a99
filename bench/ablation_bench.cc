// What a scene does not need, and what it would have cost: every scenario with the planned model and with the
// full one
// (`model=full`: every stage runs), the same integrator and step, ns of thread CPU time per body and step,
// and how far the two end apart, relative to the scene's own length, speed and turn.
//   ablation_bench [SCENARIO…]      all otherwise
// Then the price of each stage: the ratio, full over planned, of the scenarios whose plan leaves that stage
// out, median and extremes.  A stage alone cannot be switched on, so its row is the price of the company that
// it comes in.
#include "harness/cli/context.h"
#include "harness/process/client.h"
#include "harness/scenario/scenario.h"
#include "harness/study/relations.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <vector>

namespace {

using namespace cylon;

constexpr std::int64_t most_steps = 2000;

struct Measured {
  double ns = 0;  // per body-step
  core::State end;
  std::vector<core::Stage> plan;
  std::string reason;  // why nothing was measured
};

Measured measure(const scenario::Scenario& scenario, const process::EngineChoice& engine) {
  process::RunRequest request;
  request.scene = &scenario.scene;
  request.setup.dt = scenario.step;
  request.steps = request.every = std::min(most_steps, core::whole_steps(scenario.duration, scenario.step));
  request.repetitions = 4;
  process::RunOutcome outcome = process::run(engine, request, {.run_seconds = 60});
  if (!outcome.recording) return {0, {}, {}, outcome.reason};
  double least = outcome.recording->cpu_seconds;
  for (const process::Repetition& r : outcome.repetitions) least = std::min(least, r.step_seconds);
  const double body_steps =
      static_cast<double>(request.steps) * static_cast<double>(scenario.scene.bodies.size());
  return {1e9 * least / body_steps, outcome.recording->states.back(), outcome.terms.plan, ""};
}

double median(std::vector<double> x) {
  std::sort(x.begin(), x.end());
  return (x[(x.size() - 1) / 2] + x[x.size() / 2]) / 2;
}

}  // namespace

int main(int argc, char** argv) try {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);
  const cli::Context context = cli::make_context();
  const std::vector<std::string> wanted(argv + 1, argv + argc);
  // An integrator of fixed steps where there is one to choose: both sides then do the same arithmetic for the
  // motion itself.
  const std::string integrator = "in-house/integrator=velocity-verlet";
  const auto planned = process::parse_engine(integrator, context.engines),
             full = process::parse_engine(integrator + ",model=full", context.engines);
  std::map<std::string, std::vector<double>> ratios;
  fmt::print("{:<38} {:>10} {:>10} {:>8} {:>10}\n", "velocity-verlet, nominal step", "planned", "full [ns]",
             "ratio", "apart");
  for (const auto& file : scenario_files(context)) {
    const std::string name = file.stem().string();
    if (wanted.empty() ? file.parent_path() != context.scenarios
                       : std::find(wanted.begin(), wanted.end(), name) == wanted.end())
      continue;
    const scenario::Scenario scenario = scenario::load(file);
    const Measured ours = measure(scenario, planned), theirs = measure(scenario, full);
    if (!ours.reason.empty() || !theirs.reason.empty()) {
      fmt::print("{:<38} {}\n", name, ours.reason.empty() ? theirs.reason : ours.reason);
      continue;
    }
    const double ratio = theirs.ns / ours.ns;
    fmt::print("{:<38} {:>10.1f} {:>10.1f} {:>8.2f} {:>10.1e}\n", name, ours.ns, theirs.ns, ratio,
               study::apart(ours.end, theirs.end, study::scales(scenario.scene, scenario.duration)));
    for (const core::Stage& stage : ours.plan) {
      const bool run_in_full = std::any_of(theirs.plan.begin(), theirs.plan.end(), [&](const core::Stage& s) {
        return s.name == stage.name && s.in;
      });
      if (!stage.in && run_in_full) ratios[stage.name].push_back(ratio);
    }
  }
  fmt::print("\n{:<38} {:>10} {:>10} {:>8} {:>10}\n", "left out by the plan, run by the full model",
             "scenarios", "least", "median", "largest");
  for (const auto& [stage, all] : ratios)
    fmt::print("{:<43} {:>5} {:>10.2f} {:>8.2f} {:>10.2f}\n", stage, all.size(),
               *std::min_element(all.begin(), all.end()), median(all),
               *std::max_element(all.begin(), all.end()));
} catch (const core::InputError& error) {
  fmt::print(stderr, "{}\n", error.what());
  return 2;
}
