// The motion that claims without a truth of their own are measured by.
#pragma once

#include "harness/core/claim.h"

#include <vector>

namespace cylon::scenario {

/// Gives the claims without a truth the motion of the one that is known for longest: their scales are taken
/// from it.  To be called again when truths change.
void bind_motion(std::vector<core::Claim>&, double duration);

}  // namespace cylon::scenario
