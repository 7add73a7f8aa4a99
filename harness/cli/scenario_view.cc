#include "harness/cli/scenario_view.h"

#include "harness/core/claim.h"
#include "harness/process/scene_json.h"

namespace cylon::cli {

using Json = nlohmann::ordered_json;

Json scenario_facts(const scenario::Scenario& scenario) {
  scenario::require_prepared(scenario);
  Json claims = Json::array();
  for (const core::Claim& claim : scenario.claims)
    claims.push_back({{"label", claim.label},
                      {"observable", core::name(claim.observable.quantity)},
                      {"follows", claim.follows},
                      {"evidence", core::evidence(claim)},
                      {"source", claim.truth ? claim.truth->source : ""},
                      {"truth_error", claim.truth_error},
                      {"unit", core::unit(claim)},
                      {"until", claim.until},
                      {"at_least", claim.at_least ? Json(*claim.at_least) : Json()},
                      {"absolute", claim.tolerance.absolute},
                      {"relative", claim.tolerance.relative},
                      {"level", claim.tolerance.level},
                      {"roundings", claim.tolerance.roundings},
                      {"size", claim.tolerance.size},
                      {"tolerance_reason", claim.tolerance.reason}});
  return {{"name", scenario.name},       {"title", scenario.title},
          {"story", scenario.story},     {"tags", scenario.tags},
          {"sources", scenario.sources}, {"duration", scenario.duration},
          {"step", scenario.step},       {"bodies", scenario.scene.bodies.size()},
          {"claims", std::move(claims)}};
}

Json scenario_view(const scenario::Scenario& scenario) {
  Json view = {{"format", "cylon-scenario/1"}, {"hash", scenario.hash}};
  view.update(scenario_facts(scenario));
  view["scene"] = process::to_json(scenario.scene);
  return view;
}

}  // namespace cylon::cli
