#include "reports/advice_report.h"

#include "harness/results/build.h"
#include "harness/results/substeps.h"
#include "reports/builds.h"
#include "reports/json.h"
#include "reports/text.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <map>

namespace cylon::reports {
namespace {

using Json = nlohmann::ordered_json;
using results::Pick;

std::string named(const Pick& pick) {
  return fmt::format("{} {} at {}", pick.engine, pick.integrator,
                     results::with_substeps(pick.at, pick.substeps));
}

std::string cost(double value) { return std::isfinite(value) ? fmt::format("{:.1e} s/s", value) : "no time"; }

std::string ratio(double a, double b) { return std::isfinite(a / b) ? fmt::format("{:.2g}x", a / b) : "?"; }

Json to_object(const std::optional<Pick>& pick) {
  if (!pick) return nullptr;
  return {{"engine", pick->engine},
          {"integrator", pick->integrator},
          {"at", pick->at},
          {"steps", pick->steps},
          {"dt", pick->dt},
          {"substeps", pick->substeps},
          {"tolerance", pick->tolerance > 0 ? Json(pick->tolerance) : Json(nullptr)},
          {"error", number(pick->error)},
          {"cpu_seconds_per_second", number(pick->cost)}};
}

std::string line(const results::EngineAdvice& one, const results::Advice& advice) {
  if (!one.pick) {
    if (!one.best)
      return fmt::format("{}: {}\n", one.engine, one.reason.empty() ? "no run ended" : one.reason);
    return fmt::format("{}: not reachable{}: best error seen {:.1e}, {}\n", one.engine,
                       one.best->error <= advice.tolerance ? " with a margin" : "", one.best->error,
                       named(*one.best));
  }
  std::string text =
      fmt::format("{}: {}\n    error {:.1e}, {:.2g} times below the tolerance; costs {}{}\n", one.engine,
                  named(*one.pick), one.pick->error, advice.tolerance / one.pick->error, cost(one.pick->cost),
                  one.over_budget ? ", which is over the budget" : "");
  if (one.runner_up)
    text += fmt::format("    next: {}, {} ({})\n", named(*one.runner_up), cost(one.runner_up->cost),
                        ratio(one.runner_up->cost, one.pick->cost));
  text += one.ten_times ? fmt::format("    ten times better: {}, {} ({})\n", named(*one.ten_times),
                                      cost(one.ten_times->cost), ratio(one.ten_times->cost, one.pick->cost))
                        : fmt::format("    ten times better: not reachable; best error seen {:.1e}, {}\n",
                                      one.best->error, named(*one.best));
  return text;
}

}  // namespace

std::string advice_text(const results::Advice& advice, const ConsoleOptions& options) {
  const auto add = [&](std::string& out, const std::string& text) {
    std::size_t from = 0;
    for (std::size_t end = 0; (end = text.find('\n', from)) != std::string::npos; from = end + 1)
      out += shown(std::string_view(text).substr(from, end - from), options) + '\n';
  };
  std::string out;
  if (advice.measure.empty()) {
    add(out, fmt::format("{}: nothing to measure: no exact solution and no conserved quantity\n",
                         advice.scenario));
    return out;
  }
  add(out,
      fmt::format("{}: {} within {:.1e} of {}, relative, over {} s; each result checked from {} start{}\n",
                  advice.scenario, advice.measure, advice.tolerance, advice.against, advice.duration,
                  advice.starts, advice.starts == 1 ? "" : "s"));
  for (const results::EngineAdvice& one : advice.engines) add(out, line(one, advice));
  std::map<std::string, std::string> versions;
  for (const results::EngineAdvice& one : advice.engines) versions[one.engine] = one.version;
  out += costs_of_another_build(versions, options);
  if (advice.features.empty()) return out;
  add(out, fmt::format("\n{:<34} {:<17} {:>11} {:>11} {:>6}  {}\n", "cost of each part", "", "with s/s",
                       "without", "price", "effect on the motion"));
  for (const results::FeaturePrice& f : advice.features)
    add(out,
        f.reason.empty()
            ? fmt::format("{} {:<17} {:>11.1e} {:>11.1e} {:>6}  {:.1e}\n",
                          fitted(shown(f.engine, options), 34, options.utf8 ? "…" : "..."), f.feature,
                          f.with_cost, f.without_cost, ratio(f.with_cost, f.without_cost), f.effect)
            : fmt::format("{} {:<17} {}\n", fitted(shown(f.engine, options), 34, options.utf8 ? "…" : "..."),
                          f.feature, f.reason));
  return out +
         "effect: the largest difference of the two motions, relative to the scales of the motion; angles in "
         "rad\n";
}

std::string advice_json(const results::Advice& advice, const Provenance& p) {
  Json engines = Json::array(), features = Json::array();
  for (const results::EngineAdvice& one : advice.engines)
    engines.push_back({{"engine", one.engine},
                       {"version", one.version},
                       {"build", results::build_of(one.version)},
                       {"pick", to_object(one.pick)},
                       {"margin", one.pick ? number(advice.tolerance / one.pick->error) : Json(nullptr)},
                       {"over_budget", one.over_budget},
                       {"runner_up", to_object(one.runner_up)},
                       {"ten_times_better", to_object(one.ten_times)},
                       {"best", to_object(one.best)},
                       {"reason", one.reason}});
  for (const results::FeaturePrice& f : advice.features)
    features.push_back({{"engine", f.engine},
                        {"feature", f.feature},
                        {"effect", number(f.effect)},
                        {"reason", f.reason},
                        {"with_cpu_seconds_per_second", number(f.with_cost)},
                        {"without_cpu_seconds_per_second", number(f.without_cost)}});
  const Json whole = {{"format", "cylon-advice/1"},
                      {"cylon", p.cylon},
                      {"machine", p.machine},
                      {"date", p.date},
                      {"command_line", p.command_line},
                      {"scenario", advice.scenario},
                      {"measure", advice.measure},
                      {"against", advice.against},
                      {"duration", advice.duration},
                      {"tolerance", advice.tolerance},
                      {"budget", advice.budget > 0 ? Json(advice.budget) : Json(nullptr)},
                      {"starts", advice.starts},
                      {"engines", engines},
                      {"features", features}};
  return whole.dump(1, ' ', true, Json::error_handler_t::replace) + '\n';
}

}  // namespace cylon::reports
