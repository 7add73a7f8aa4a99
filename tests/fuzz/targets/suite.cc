#include "harness/scenario/suite.h"
#include "harness/core/input_error.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void suite(std::string_view bytes) {
  try {
    scenario::parse_suite(bytes, "s.toml");
  } catch (const core::InputError& error) {
    if (error.line == 0 || error.column == 0)
      throw Broken(std::string("a refusal has a line and a column: ") + error.what());
  }
}

}  // namespace cylon::fuzz
