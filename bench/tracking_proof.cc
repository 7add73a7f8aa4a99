// What the comparison of two builds is worth on this machine, as busy as it is: false alarms of a build
// against itself, and how often a known slow-down or a known fault is found.  bench/tracking_proof.sh builds
// what it compares.
#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"
#include "harness/study/compare.h"
#include "harness/study/paired_times.h"

#include <fmt/format.h>

#include <cstdlib>
#include <string>
#include <vector>

namespace cylon {
namespace {

using results::Finding;

struct Cell {
  const char *scenario, *engine;
};

// Small, and unlike each other: a spring, a top, a pendulum, a stack with contacts.
constexpr Cell timed[] = {{"spring_orbit", "in-house/integrator=rk4"},
                          {"dzhanibekov", "in-house/integrator=velocity-verlet"},
                          {"spring_chain", "in-house/integrator=rk4"},
                          {"box_settles", "in-house/path=stepping"}};
// The fault sits in rk4.
constexpr const char* faulty[] = {"spring_orbit", "dzhanibekov", "spring_chain", "damped_spring_under",
                                  "heavy_top"};

process::EngineChoice engine_of(const std::string& folder, const char* id) {
  return process::parse_engine(id, process::default_engines(folder));
}

scenario::Scenario load(const std::string& root, const char* name) {
  return scenario::load(root + "/scenarios/" + name + ".toml");
}

/// One comparison of times as `cylon track compare` makes it; a line for it on stdout.
Finding compare_times(const std::string& root, const Cell& cell, const std::string& before,
                      const std::string& after, const char* what, int trial) {
  const scenario::Scenario scenario = load(root, cell.scenario);
  const study::Pinning& pinning = study::pin_to_one_processor();
  const auto old_engine = study::pinned(engine_of(before, cell.engine), pinning);
  const auto new_engine = study::pinned(engine_of(after, cell.engine), pinning);
  const process::Limits limits;
  const study::SampleRule rule{.most_seconds = 2e-3};  // short: many comparisons count here, not each of them
  const auto steps = study::sampling(scenario, scenario.step).steps;
  const study::Planned planned =
      study::plan_samples(old_engine, scenario.scene, scenario.step, steps, rule, limits);
  if (!planned.plan) throw core::InputError(fmt::format("{}: {}", cell.scenario, planned.reason));
  study::PairedTimes pairs([&] { return study::take_sample(old_engine, *planned.plan, limits); },
                           [&] { return study::take_sample(new_engine, *planned.plan, limits); }, {});
  while (pairs.wants_more()) pairs.take_pair();
  if (const std::string failure = pairs.baseline_failure() + pairs.candidate_failure(); !failure.empty())
    throw core::InputError(fmt::format("{}: {}", cell.scenario, failure));
  const results::ComparedTime time = pairs.summary();
  fmt::print("{},{},{},{},{},{:.4f},{:.4f},{:.4f},{}\n", what, trial, cell.scenario, cell.engine,
             results::name(time.finding), time.ratio, time.low, time.high, time.pairs);
  std::fflush(stdout);
  return time.finding;
}

/// Whether the rules of errors and orders find the fault.
bool finds_fault(const std::string& root, const char* name, const std::string& before,
                 const std::string& after) {
  const scenario::Scenario scenario = load(root, name);
  const auto profile = [&](const std::string& folder) {
    return study::profile(scenario, engine_of(folder, "in-house/integrator=rk4"), scenario.step,
                          study::Counter::off, {});
  };
  for (const results::ComparedMetric& metric : study::compare_profiles(profile(before), profile(after))) {
    if (metric.finding != Finding::regressed) continue;
    fmt::print("fault,0,{},rk4,regressed,,,,{}: {}\n", name, metric.name, metric.sentence);
    return true;
  }
  fmt::print("fault,0,{},rk4,same,,,,\n", name);
  return false;
}

int run(const std::vector<std::string>& words) {
  if (words.size() != 5)
    throw core::InputError(
        "usage: tracking_proof SOURCES KIND BASELINE CANDIDATE TRIALS, KIND being time or fault");
  const std::string &root = words[0], &before = words[2], &after = words[3];
  if (words[1] == "fault") {
    for (const char* name : faulty) finds_fault(root, name, before, after);
    return 0;
  }
  const int trials = std::atoi(words[4].c_str());
  for (int trial = 0; trial < trials; ++trial)
    compare_times(root, timed[static_cast<std::size_t>(trial) % std::size(timed)], before, after,
                  words[1].c_str(), trial);
  return 0;
}

}  // namespace
}  // namespace cylon

int main(int argc, char** argv) try {
  return cylon::run({argv + 1, argv + argc});
} catch (const std::exception& error) {
  fmt::print(stderr, "error: {}\n", error.what());
  return 2;
}
