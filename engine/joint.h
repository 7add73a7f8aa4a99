// Joints, as rows of constraints.
#pragma once

#include "engine/constraint.h"
#include "engine/model.h"

namespace cylon::engine {

/// How many rows a joint has: the degrees of freedom that it takes.
int row_count(Joint::Type);

/// Adds the rows of a joint.  Solving c'' = 0 for their forces turns the mechanism into an ordinary
/// differential equation that any integrator can integrate: E. Hairer, G. Wanner, Solving Ordinary Differential
/// Equations II, section VII.1, index reduction.
void add_rows(const Joint&, const std::vector<Body>&, const Motion*, std::vector<Row>&);

}  // namespace cylon::engine
