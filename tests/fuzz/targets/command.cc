#include "harness/view/command.h"
#include "tests/fuzz/targets/targets.h"

namespace cylon::fuzz {

void command(std::string_view bytes) {
  try {
    view::parse_command(bytes);
  } catch (const view::BadCommand&) {
  }
}

}  // namespace cylon::fuzz
