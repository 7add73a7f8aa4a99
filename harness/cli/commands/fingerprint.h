// cylon engines --fingerprint: what engines do, beside what they say.
#pragma once

#include "harness/cli/context.h"

#include <string>
#include <vector>

namespace cylon::cli {

/// Probes the engines that the globs name, or variants such as bullet/gyro=none; all without any.  Throws
/// core::InputError for an id that is none.
int fingerprint(const std::vector<process::EngineRow>&, const std::vector<std::string>& asked, bool json);

}  // namespace cylon::cli
