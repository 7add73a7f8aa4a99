#include "tests/fuzz/targets/scenario_read.h"

#include "harness/core/input_error.h"
#include "harness/process/json_fields.h"
#include "harness/process/messages.h"
#include "harness/process/scene_json.h"
#include "harness/scenario/scenario.h"
#include "tests/fuzz/targets/targets.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace cylon::fuzz {

void read_scenario(std::string_view text, const std::string& file_name) {
  std::optional<scenario::Scenario> scenario;
  try {
    scenario = scenario::parse(text, file_name);
  } catch (const core::InputError& error) {
    if (error.line == 0 || error.column == 0)
      throw Broken(std::string("a refusal has a line and a column: ") + error.what());
    return;
  }
  const nlohmann::json message = process::to_json(scenario->scene);
  try {
    const std::string line = process::line(message);
    if (process::to_json(process::scene_from_json(process::parse_object(line))) != message)
      throw Broken("a worker reads the scene that was read");
  } catch (const process::MalformedMessage& error) {
    throw Broken(std::string("a worker takes the scene that was read: ") + error.what());
  }
}

}  // namespace cylon::fuzz
