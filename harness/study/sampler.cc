#include "harness/study/sampler.h"

#include <fmt/format.h>

#include <sched.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <limits>
#include <sstream>

namespace cylon::study {
namespace {

std::string failure_of(const process::RunOutcome& outcome) {
  return fmt::format("{}: {}", results::name(outcome.status), outcome.reason);
}

process::RunOutcome repeat(const process::EngineChoice& engine, const core::Scene& scene, double dt,
                           std::int64_t steps, int repetitions, const process::Limits& limits) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = dt;
  request.steps = steps;
  request.every = std::max<std::int64_t>(1, steps);
  request.repetitions = repetitions;
  return process::run(engine, request, limits);
}

bool in_path(const char* program) {
  const char* path = std::getenv("PATH");
  std::istringstream folders(path ? path : "/usr/bin:/bin");
  for (std::string folder; std::getline(folders, folder, ':');)
    if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
  return false;
}

Pinning find_pinning() {
  cpu_set_t allowed;
  if (::sched_getaffinity(0, sizeof allowed, &allowed) != 0)
    return {{}, "workers are not pinned: the processors that may be used are not known"};
  int last = -1;
  for (int cpu = 0; cpu < CPU_SETSIZE; ++cpu)
    if (CPU_ISSET(cpu, &allowed)) last = cpu;
  if (!in_path("taskset")) return {{}, "workers are not pinned: taskset (util-linux) is not installed"};
  return {{"taskset", "-c", fmt::format("{}", last)},
          fmt::format("workers run on processor {} (taskset)", last)};
}

}  // namespace

const Pinning& pin_to_one_processor() {
  static const Pinning pinning = find_pinning();
  return pinning;
}

process::EngineChoice pinned(process::EngineChoice engine, const Pinning& pinning) {
  engine.row.started_by = pinning.prefix;
  return engine;
}

std::string SamplePlan::says() const {
  const std::string part =
      steps == of ? fmt::format("{} steps", of) : fmt::format("first {} of {} steps", steps, of);
  return fmt::format("{}, least of {} x {} run{}", part, repetitions, runs, runs == 1 ? "" : "s");
}

double least_of(const std::vector<process::Repetition>& all, int runs, bool with_load) {
  double least = std::numeric_limits<double>::infinity();
  const auto count = static_cast<std::size_t>(runs);
  for (std::size_t begin = 0; begin + count <= all.size(); begin += count) {
    double sum = 0;
    for (std::size_t i = begin; i < begin + count; ++i)
      sum += all[i].step_seconds + (with_load ? all[i].load_seconds : 0);
    least = std::min(least, sum);
  }
  return least / runs;
}

Planned plan_samples(const process::EngineChoice& engine, const core::Scene& scene, double dt,
                     std::int64_t steps, const SampleRule& rule, const process::Limits& limits) {
  SamplePlan plan{.scene = &scene, .dt = dt, .steps = steps, .of = steps, .repetitions = rule.repetitions};
  double run_seconds = 0;
  for (int trial = 0; trial < 4; ++trial) {  // a run may cost more at its start than later
    const process::RunOutcome outcome = repeat(engine, scene, dt, plan.steps, 3, limits);
    if (outcome.status != results::Status::pass) return {std::nullopt, failure_of(outcome), true};
    plan.with_load = core::controls_its_error(outcome.engine, outcome.terms);
    run_seconds = least_of(outcome.repetitions, 1, plan.with_load);
    if (run_seconds <= 1.5 * rule.most_seconds || plan.steps == 1) break;
    plan.steps = std::max<std::int64_t>(
        1, static_cast<std::int64_t>(static_cast<double>(plan.steps) * rule.most_seconds / run_seconds));
  }
  const double runs = std::ceil(rule.least_seconds / std::max(run_seconds, 1e-9));
  if (runs > rule.most_runs)
    return {std::nullopt, fmt::format("too short to time: {:.2g} s a run, and {} runs are not {:g} s",
                                      run_seconds, rule.most_runs, rule.least_seconds)};
  plan.runs = std::max(1, static_cast<int>(runs));
  return {plan, ""};
}

Sample take_sample(const process::EngineChoice& engine, const SamplePlan& plan,
                   const process::Limits& limits) {
  // The run that is recorded, before the repetitions, is the warm-up.
  const process::RunOutcome outcome =
      repeat(engine, *plan.scene, plan.dt, plan.steps, plan.repetitions * plan.runs, limits);
  if (outcome.status != results::Status::pass) return {0, failure_of(outcome)};
  const double seconds = least_of(outcome.repetitions, plan.runs, plan.with_load);
  if (!(seconds > 0) || !std::isfinite(seconds)) return {0, "the worker says that its steps took no time"};
  return {seconds, "", outcome.engine.version};
}

}  // namespace cylon::study
