#pragma once

#include "harness/exports/exports.h"

namespace cylon::exports {

/// Throws Unsayable.
Exported to_mjcf(const scenario::Scenario&);

}  // namespace cylon::exports
