#include "harness/cli/provenance_now.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <ctime>

namespace cylon::cli {

std::string now() { return fmt::format("{:%Y-%m-%dT%H:%M:%SZ}", fmt::gmtime(std::time(nullptr))); }

reports::Provenance provenance_now(const Context& context) {
  reports::Provenance provenance = reports::build_and_machine();
  provenance.date = now();
  provenance.command_line = context.command_line;
  return provenance;
}

}  // namespace cylon::cli
