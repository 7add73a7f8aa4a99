// The name of a claim in reports and in expected.toml.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/reader.h"

#include <string>

namespace cylon::scenario {

/// "angular_momentum conserved, y", "event follows bouncing_sphere, apex 2 height".  No character has a
/// meaning in globs.
std::string label_of(const Table&, const core::Claim&);

}  // namespace cylon::scenario
