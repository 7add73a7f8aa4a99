#include "harness/scenario/bind_motion.h"

#include "harness/core/scale.h"

#include <algorithm>
#include <memory>

namespace cylon::scenario {

using core::Claim;

void bind_motion(std::vector<Claim>& claims, double duration) {
  const auto horizon = [&](const Claim& claim) { return std::min(claim.until, duration); };
  const Claim* longest = nullptr;
  for (const Claim& claim : claims)
    if (claim.truth && claim.truth->knows_velocity && claim.truth->knows_angular_velocity &&
        (!longest || horizon(claim) > horizon(*longest)))
      longest = &claim;
  if (!longest) return;
  const auto motion = std::make_shared<core::RequiredMotion>(
      *longest->truth, std::min(horizon(*longest), longest->truth->horizon));
  for (Claim& claim : claims)
    if (claim.follows.empty()) claim.motion = motion;
}

}  // namespace cylon::scenario
