#pragma once

#include "harness/exports/exports.h"

namespace cylon::exports {

/// Throws Unsayable.
Exported to_sdformat(const scenario::Scenario&);

}  // namespace cylon::exports
