#include "harness/process/last_words.h"

#include <algorithm>

namespace cylon::process {
namespace {

// What Child::ending() says, up to the line of stderr.
struct Ending {
  const char *begins, *ends;
};
constexpr Ending endings[] = {{"killed by ", ": "}, {"exited ", " before done: "}, {"cannot start '", "': "}};

}  // namespace

std::string without_last_words(const std::string& reason) {
  std::size_t end = reason.size();
  for (const auto& [begins, ends] : endings) {
    const std::size_t begin = reason.find(begins);
    if (begin == std::string::npos) continue;
    const std::size_t at = reason.find(ends, begin);
    if (at != std::string::npos) end = std::min(end, reason.find(": ", at));
  }
  return reason.substr(0, end);
}

}  // namespace cylon::process
