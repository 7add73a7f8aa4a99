#include "harness/cli/states_csv.h"
#include "harness/core/input_error.h"
#include "harness/core/scene.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void states(std::string_view bytes) {
  core::Scene scene;
  for (const char* name : {"a", "b, the other"}) scene.bodies.emplace_back().name = name;
  try {
    cli::parse_states(bytes, "s.csv", scene);
  } catch (const core::InputError& error) {
    if (error.line == 0 || error.column == 0)
      throw Broken(std::string("a refusal has a line and a column: ") + error.what());
  }
}

}  // namespace cylon::fuzz
