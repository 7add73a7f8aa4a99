#include "tests/fuzz/targets/objection.h"

#include "harness/core/input_error.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/scene_json.h"
#include "harness/scenario/input.h"
#include "harness/scenario/writer.h"
#include "harness/study/cell.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::fuzz {
namespace {

std::string of_worker(const scenario::Scenario& scenario) {
  const nlohmann::json message = process::to_json(scenario.scene);
  const core::Scene back = process::scene_from_json(process::parse_object(process::line(message)));
  return process::to_json(back) == message ? "" : "the worker reads another scene";
}

std::string of_truths(const scenario::Scenario& scenario) {
  for (const core::Claim& claim : scenario.claims) {
    if (!claim.truth || !claim.truth->times.empty()) continue;
    const double horizon = std::min({claim.until, scenario.duration, claim.truth->horizon});
    for (const double t : {0.0, 0.37 * horizon, horizon})
      if (claim.truth->state(t).size() != scenario.scene.bodies.size()) return "a truth has other bodies";
  }
  return "";
}

// The viewer does not write what it cannot read back, and says so (view/record_file.h).
std::string of_writer(const scenario::Scenario& scenario) {
  const std::string written = "duration = 1\nstep = 0.125\n" + scenario::to_toml(scenario.scene);
  if (written.size() > scenario::largest_input) return "";
  const core::Scene again = scenario::parse(written, scenario.file + ".written.toml").scene;
  return again.bodies.size() == scenario.scene.bodies.size() ? "" : "the written scene has other bodies";
}

std::string of_sampling(const scenario::Scenario& scenario) {
  study::sampling(scenario, scenario.step);
  return "";
}

constexpr struct {
  const char* name;
  std::string (*ask)(const scenario::Scenario&);
} parts[] = {{"worker", of_worker}, {"truths", of_truths}, {"writer", of_writer}, {"sampling", of_sampling}};

}  // namespace

std::string objection(const scenario::Scenario& scenario) {
  for (const auto& part : parts) {
    std::string said;
    try {
      said = part.ask(scenario);
    } catch (const std::exception& error) {
      said = error.what();
    }
    if (!said.empty()) return std::string(part.name) + ": " + said;
  }
  return "";
}

}  // namespace cylon::fuzz
