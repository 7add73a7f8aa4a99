// Forces that can be shared in many ways: which of them obey Coulomb's law.
#pragma once

#include "engine/contact/coulomb.h"

namespace cylon::engine {

/// Where forces can be shared in many ways, an even sharing may lie outside the cones and another inside: from a force to the
/// nearest that the holds allow, from there on the way on which the cones pull to where the sum of squares of the distances from
/// them is least, and so on; then inwards, until 0.9 of the friction is enough or no less would be.  Where one redundancy is
/// left the first way leads there.  Whether `shared` obeys the law; adds to the operations what it took.
bool share_within_cones(const CoulombProblem&, const std::vector<Hold>&, const VectorX& from, VectorX& shared,
                        std::int64_t& operations);

}  // namespace cylon::engine
