// [[claim]] -> core::Claim, with every truth that costs little and with its tolerance checked.
#pragma once

#include "harness/core/claim.h"
#include "harness/scenario/certified_claims.h"
#include "harness/scenario/draft.h"

#include <vector>

namespace cylon::scenario {

struct ReadClaims {
  std::vector<core::Claim> claims;
  std::vector<CertifiedClaim> certified;  ///< Those that have no truth yet.
};

/// The claims of a finished scene.  Throws core::InputError for one that cannot be judged: an observable that
/// the scene has not, a truth that refuses the scene or is looser than a tenth of the tolerance, a relative
/// tolerance of something that is zero or an angle, a claim made twice.
ReadClaims read_claims(const Table& root, Draft&, double duration, double step);

}  // namespace cylon::scenario
