// One plan in place of those of several islands.
#pragma once

#include "engine/plan.h"

#include <string>
#include <vector>

namespace cylon::engine::islands {

struct NamedPlan {
  std::string bodies;  ///< "bodies 0, 1, 2".
  const Plan* plan = nullptr;
};

/// Path, integrator and order of the island with the least order (the first of them); each stage is in if it
/// is in for any island, with the reasons.  A further stage, "islands", lists bodies and paths.  Requires at
/// least one plan.
Plan joined_plan(const std::vector<NamedPlan>&);

}  // namespace cylon::engine::islands
