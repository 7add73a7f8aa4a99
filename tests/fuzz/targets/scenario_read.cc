#include "tests/fuzz/targets/scenario_read.h"

#include "harness/core/input_error.h"
#include "harness/scenario/scenario.h"
#include "tests/fuzz/targets/objection.h"
#include "tests/fuzz/targets/targets.h"

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
  if (const std::string said = objection(*scenario); !said.empty())
    throw Broken("what the reader takes, every part takes: " + said);
}

}  // namespace cylon::fuzz
