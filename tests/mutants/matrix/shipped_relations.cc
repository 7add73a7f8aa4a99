// The relations that `cylon run --metamorphic` asks, as judges on shipped scenes.
#include "harness/study/metamorphic.h"
#include "harness/study/relations.h"
#include "harness/study/runner.h"
#include "harness/study/theory.h"
#include "tests/mutants/matrix/judge.h"
#include "tests/mutants/matrix/record.h"
#include "tests/paths.h"

#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string_view>

namespace cylon::mutants {
namespace {

// One simulator in this process as a runner of scenes.
study::Runner runner_of(const Subject& subject) {
  const std::shared_ptr<core::Simulator> simulator = subject.make();
  return [=](const core::Scene& scene, double dt, std::int64_t steps, std::int64_t every) {
    core::Setup setup = subject.setup;
    setup.dt = dt;
    if (const auto why = simulator->unsupported(scene, setup))
      throw study::RunFailed{{.status = results::Status::unsupported, .reason = *why}};
    study::Sampling plan;
    plan.steps = steps, plan.every = every;
    return record(*simulator, scene, setup, plan);
  };
}

std::optional<std::vector<Finding>> related(const Subject& subject, const scenario::Scenario& scenario,
                                            std::string_view only) {
  constexpr std::int64_t samples = 200;
  const auto steps = static_cast<std::int64_t>(std::llround(scenario.duration / scenario.step));
  const std::int64_t every = std::max<std::int64_t>(1, steps / samples);
  const study::Runner run = runner_of(subject);
  core::Recording plain;
  try {
    plain = run(scenario.scene, scenario.step, steps, every);
  } catch (const study::RunFailed&) {
    return std::nullopt;
  }
  const study::Subject asked{scenario.scene, plain, every, study::scales(scenario.scene, scenario.duration),
                             scenario.duration};
  std::vector<Finding> findings;
  for (const study::Relation& relation : study::relations()) {
    if (relation.undefined_in(scenario.scene) || (!only.empty() && relation.name != only)) continue;
    // A thousandth of the scales is more than a fixed step promises.
    if (!relation.exact && !study::promise_of(plain.engine, plain.terms).adaptive) continue;
    try {
      findings.push_back({fmt::format("relation {}", relation.name), relation.deviation(asked, run),
                          relation.exact ? 0 : study::allowed_of_relations});
    } catch (const study::RunFailed&) {  // it does not take the other scene
    }
  }
  return findings;
}

struct Row {
  const char* name;
  const char* file;
  std::string_view only = {};  ///< The one relation that is asked; empty: all.
};

constexpr Row rows[] = {
    {"rel: tilted", "scenarios/tilted_gravity.toml"},
    {"rel: spring pair", "scenarios/two_body_spring.toml"},
    {"rel: oblique", "scenarios/two_sphere_oblique.toml"},
    {"rel: rod", "scenarios/rod_offcentre_hit.toml"},
    {"rel: cubes", "scenarios/seed_cubes.toml"},
    {"rel: break shot", "scenarios/break_shot.toml", "repetition"},
};

}  // namespace

std::vector<Judge> shipped_relation_judges() {
  std::vector<Judge> result;
  for (const Row& row : rows)
    result.push_back({row.name, fmt::format("{}, the shipped relations", row.file), true,
                      [file = std::filesystem::path(source_dir) / row.file, only = row.only](
                          const Subject& subject) { return related(subject, scenario::read(file), only); }});
  return result;
}

}  // namespace cylon::mutants
