// Which bodies can ever turn: the others need no rotation.
#pragma once

#include "engine/model.h"

#include <vector>

namespace cylon::engine {

/// One flag per body.  A body turns if it has spin, or if a force with an arm, a joint or a touch can give it
/// some; drag only takes it.  Locked bodies do not.
std::vector<char> bodies_that_turn(const Model&);

}  // namespace cylon::engine
