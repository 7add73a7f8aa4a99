#include "harness/study/features.h"

#include "harness/core/input_error.h"
#include "harness/core/worst.h"
#include "harness/study/advise.h"
#include "harness/study/cost.h"
#include "harness/study/relations.h"
#include "harness/study/settings.h"

#include <fmt/format.h>

#include <algorithm>

namespace cylon::study {
namespace {

struct SceneFeature {
  const char* name;
  bool (*take)(core::Scene&);  // whether it was there
};

constexpr SceneFeature scene_features[] = {
    {"friction",
     [](core::Scene& scene) {
       bool any = false;
       for (core::Material& m : scene.materials) any |= m.friction > 0, m.friction = 0;
       return any && touches(scene);
     }},
    {"joints",
     [](core::Scene& scene) {
       const bool any = !scene.joints.empty();
       scene.joints.clear();
       return any;
     }},
    {"contacts",
     [](core::Scene& scene) {
       const bool any = touches(scene);
       for (core::Body& body : scene.bodies) body.collide = false;
       return any;
     }},
};

// "bullet/gyro=none" with another row: "bullet-float/gyro=none".
std::string with_row(const std::string& id, const std::string& row) {
  const std::size_t slash = id.find('/');
  return slash == std::string::npos ? row : row + id.substr(slash);
}

// The states of a run at the samples, and what its steps cost.
struct Priced {
  std::vector<core::State> states;
  std::optional<process::Repetition> time;
  std::string reason;
};

Priced run(const core::Scene& scene, const process::EngineChoice& engine, const std::string& integrator,
           const results::Pick& pick, std::int64_t samples, const process::Limits& limits) {
  process::RunRequest request;
  request.scene = &scene;
  request.setup.dt = pick.dt, request.setup.tolerance = pick.tolerance, request.setup.integrator = integrator;
  request.steps = pick.steps, request.every = pick.steps / samples;
  Priced priced;
  try {
    process::RunOutcome outcome = process::run(engine, request, limits);
    priced.reason = outcome.reason;
    if (outcome.recording) priced.states = std::move(outcome.recording->states);
  } catch (const core::InputError& error) {
    priced.reason = error.what();
  }
  return priced;
}

}  // namespace

std::vector<Feature> features(const core::Scene& scene, const Setting& setting,
                              std::span<const process::EngineRow> rows) {
  std::vector<Feature> result;
  const process::EngineChoice& engine = setting.engine;
  const core::Engine about = process::describe(engine);
  for (const core::Option& option : about.options)
    for (const std::string off : {"none", "off"})
      if (option.name == "gyro" && turns(scene) && !engine.options.contains("gyro") &&
          std::find(option.values.begin(), option.values.end(), off) != option.values.end())
        result.push_back({"gyroscopic term",
                          process::parse_engine(with_option(engine.id, "gyro=" + off), rows),
                          setting.integrator, scene});
  for (const SceneFeature& feature : scene_features) {
    core::Scene without = scene;
    if (feature.take(without))
      result.push_back({feature.name, engine, setting.integrator, std::move(without)});
  }
  for (const process::EngineRow& row : rows)
    if (row.id == engine.row.id + "-float")
      result.push_back({"double precision", process::parse_engine(with_row(engine.id, row.id), rows),
                        setting.integrator, scene});
  return result;
}

std::vector<results::FeaturePrice> price_features(const Start& start, const std::vector<results::Pick>& picks,
                                                  const std::vector<Setting>& settings,
                                                  std::span<const process::EngineRow> rows, int rounds,
                                                  const process::Limits& limits) {
  const scenario::Scenario& scenario = *start.scenario;
  const std::int64_t samples = start.yardstick->samples();
  const Scales unit = scales(scenario.scene, scenario.duration);
  std::vector<results::FeaturePrice> prices;
  for (const results::Pick& pick : picks) {
    const Setting setting = setting_of(pick, settings);
    const Priced with = run(scenario.scene, setting.engine, setting.integrator.name, pick, samples, limits);
    for (const Feature& feature : features(scenario.scene, setting, rows)) {
      results::FeaturePrice price;
      price.engine = fmt::format("{} {}", pick.engine, pick.integrator);
      price.feature = feature.name;
      const Priced without =
          run(feature.scene, feature.engine, feature.integrator.name, pick, samples, limits);
      price.reason = with.reason.empty() ? without.reason : with.reason;
      if (price.reason.empty()) {
        double effect = 0;
        for (std::size_t k = 0; k < with.states.size() && k < without.states.size(); ++k)
          effect = core::worst(apart(with.states[k], without.states[k], unit), effect);
        price.effect = effect;
        const Timed on{setting.engine,
                       {.dt = pick.dt, .integrator = setting.integrator.name, .tolerance = pick.tolerance},
                       pick.steps};
        Timed off = on;
        off.engine = feature.engine;
        std::optional<process::Repetition> best_on, best_off;
        const double guess = pick.cost * scenario.duration;
        const auto improve = [&](std::optional<process::Repetition>& best, const TimedOnce& once) {
          if (once.least)
            best = best ? least(*best, *once.least) : *once.least;
          else
            price.reason = once.reason;
        };
        for (int round = 0; round < rounds; ++round) {
          improve(best_on, time_once(on, scenario.scene, guess, limits));
          improve(best_off, time_once(off, feature.scene, guess, limits));
        }
        if (best_on) price.with_cost = cost(*best_on, setting.integrator.adaptive, scenario.duration);
        if (best_off) price.without_cost = cost(*best_off, setting.integrator.adaptive, scenario.duration);
      }
      prices.push_back(std::move(price));
    }
  }
  return prices;
}

}  // namespace cylon::study
