#include "harness/told/diagnostic.h"

#include <fmt/format.h>

namespace cylon::told {

std::string in_words(const Diagnostic& d) {
  std::string how = d.method;
  if (d.order > 0) how += fmt::format("{}order {}", how.empty() ? "" : ", ", d.order);
  return fmt::format("{}: {}{}", d.kind, d.text, how.empty() ? "" : fmt::format(" [{}]", how));
}

}  // namespace cylon::told
