// [[claim]] -> core::Claim, with its truth at hand and its tolerance weighed.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/draft.h"

#include <vector>

namespace cylon::scenario {

/// The claims of a finished scene.  Throws core::InputError for one that cannot be judged: an observable that
/// the scene has not, a truth that refuses the scene or is looser than a tenth of the tolerance, a relative
/// tolerance of something that is zero or an angle, a claim made twice.
std::vector<core::Claim> read_claims(const Table& root, Draft&, double duration, double step);

}  // namespace cylon::scenario
