#include "harness/results/build.h"

namespace cylon::results {

std::string build_of(std::string_view version) {
  const std::size_t open = version.find(" (");
  if (open == std::string_view::npos || !version.ends_with(')')) return {};
  return std::string(version.substr(open + 2, version.size() - open - 3));
}

std::string build_in_words(std::string_view version) {
  const std::string build = build_of(version);
  return build.empty() ? "native code" : build;
}

}  // namespace cylon::results
