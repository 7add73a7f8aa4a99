#include "tests/fuzz/targets/objection.h"

#include "harness/core/input_error.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/scene_json.h"
#include "harness/scenario/input.h"
#include "harness/scenario/writer.h"
#include "harness/study/cell.h"

#include <nlohmann/json.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

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

// Unit quaternions and axes, which the reader brings to length one: of what it has brought there the last bits
// change again.
bool normalised(const nlohmann::json::json_pointer& path) {
  const std::string key = path.parent_pointer().empty() ? "" : path.parent_pointer().back();
  return key == "orientation" || key.starts_with("axis");
}

// What differs between two scenes as workers get them, beyond the rounding of unit vectors; "" where nothing does.
std::string difference(const nlohmann::json& one, const nlohmann::json& other) {
  constexpr double rounding = 4 * std::numeric_limits<double>::epsilon();  // of the norm and of the quotient
  if (one == other) return "";
  for (const nlohmann::json& change : nlohmann::json::diff(one, other)) {
    const nlohmann::json::json_pointer path(change.at("path").get<std::string>());
    const bool numbers =
        change.at("op") == "replace" && change.at("value").is_number() && one.at(path).is_number();
    if (numbers && normalised(path) &&
        std::abs(change.at("value").get<double>() - one.at(path).get<double>()) <= rounding)
      continue;
    return path.to_string();
  }
  return "";
}

// The viewer does not write what it cannot read back, and says so (view/record_file.h).
std::string of_writer(const scenario::Scenario& scenario) {
  const std::string written = "duration = 1\nstep = 0.125\n" + scenario::to_toml(scenario.scene);
  if (written.size() > scenario::largest_input) return "";
  const core::Scene again = scenario::parse(written, scenario.file + ".written.toml").scene;
  const std::string where = difference(process::to_json(scenario.scene), process::to_json(again));
  return where.empty() ? "" : fmt::format("the written scene has another {}", where);
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
