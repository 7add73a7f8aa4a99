#include "harness/core/fingerprint.h"

#include <fmt/format.h>

namespace cylon::core {

std::string Fingerprint::hex() const { return fmt::format("{:016x}", value_); }

}  // namespace cylon::core
