// A history of made-up runs in a store that is really written.
#pragma once

#include "harness/tracking/store/store.h"

#include <fmt/format.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

namespace cylon::tracking {

using namespace cli;

struct Step {
  std::size_t at;  ///< Revision, from 0.
  double factor;
};

struct MadeUp {
  std::size_t revisions = 60;
  std::vector<Step> steps;        ///< Of the engine's time; the anchor has none.
  std::size_t version_at = 1000;  ///< The first revision with bullet 3.25 in place of 3.24.
  std::size_t error_at = 1000;    ///< The first with an error larger by 20 %, and another state hash.
  std::uint64_t seed = 1;
  int pairs = 16;
};

inline std::string revision(std::size_t i) { return fmt::format("rev{:03}", i); }

inline store::Result cell_of(const std::string& engine, const std::string& version) {
  store::Result r;
  r.cell = {.hash = "",
            .scenario = "bounce",
            .scenario_hash = "fedcba9876543210",
            .engine = engine,
            .path = "rigid",
            .integrator = "auto",
            .precision = "double",
            .settings = "",
            .dt = 0.001,
            .dt_text = "0.001"};
  r.engine_version = version;
  return r;
}

inline void add_times(store::Result& r, const std::vector<double>& times, const std::vector<double>& base) {
  for (std::size_t i = 0; i < times.size(); ++i) {
    const auto pair = static_cast<std::int64_t>(i);
    r.samples.push_back({{"cpu_seconds", store::Kind::time, "s"}, pair, times[i], ""});
    r.samples.push_back({{"cpu_ratio:base", store::Kind::time, "ratio"}, pair, times[i] / base[i], ""});
  }
}

/// Runs of in-house and bullet on bounce beside a pinned binary "base", one per revision.  A process strays
/// by 1 %; the machine as a whole wanders by several percent from run to run, which shows in absolute times
/// and not in ratios.
inline void make_up(const std::filesystem::path& file, const MadeUp& given) {
  store::Store store = store::Store::open(file, store::Mode::write);
  std::mt19937_64 random(given.seed);
  std::normal_distribution<double> normal;
  double machine = 0, level = std::log(0.8);
  store.in_one_transaction([&] {
    for (std::size_t i = 0; i < given.revisions; ++i) {
      machine = 0.9 * machine + 0.03 * normal(random);
      for (const Step& step : given.steps)
        if (step.at == i) level += std::log(step.factor);
      const auto times = [&](double log_ratio) {
        std::vector<double> all(static_cast<std::size_t>(given.pairs));
        for (double& one : all) one = 0.037 * std::exp(machine + log_ratio + 0.01 * normal(random));
        return all;
      };
      store::RunInfo info;
      info.revision = revision(i);
      info.date = fmt::format("2024-05-{:02}T03:04:05Z", i % 28 + 1);
      const std::int64_t run = store.begin_run(info);
      store::Result ours = cell_of("in-house", "0.2.0");
      store::Result bullet = cell_of("bullet", i < given.version_at ? "3.24" : "3.25");
      add_times(ours, times(level), times(0));
      add_times(bullet, times(1.7), times(0));
      const double error = 3.1e-6 * (i < given.error_at ? 1 : 1.2);
      ours.samples.push_back({{"error:position", store::Kind::error, "m"}, 0, error, ""});
      ours.samples.push_back(
          {{"state_hash", store::Kind::exact, ""}, 0, NAN, i < given.error_at ? "8f3a" : "77b0"});
      ours.judgements.push_back({"position", "position", "m", "pass", "pass", error, 1e-5, 1e-13, ""});
      bullet.samples.push_back(
          {{"error:position", store::Kind::error, "m"}, 0, i < given.version_at ? 2e-3 : 1e-3, ""});
      bullet.judgements.push_back({"position", "position", "m", "fail", "fail", 2e-3, 1e-5, 1e-13, ""});
      for (const store::Result& result : {ours, bullet}) store.add(run, result);
      store.finish_run(run);
    }
  });
}

}  // namespace cylon::tracking
