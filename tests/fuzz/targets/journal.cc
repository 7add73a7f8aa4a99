#include "harness/cli/journal.h"
#include "harness/input/json.h"
#include "tests/fuzz/targets/targets.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace cylon::fuzz {

// As cli::LineFile reads it, which leaves out every line that throws.
void journal(std::string_view bytes) {
  cli::Journal::Content content;
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\n'), bytes.size());
    try {
      content.take(input::parse_json(bytes.substr(0, end)));
    } catch (const std::exception&) {
    }
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  if (content.request &&
      cli::to_json(cli::request_from(cli::to_json(*content.request))) != cli::to_json(*content.request))
    throw Broken("a request is read as it was written");
}

}  // namespace cylon::fuzz
