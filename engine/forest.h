// How joints hang bodies from each other.
#pragma once

#include "engine/model.h"

#include <vector>

namespace cylon::engine {

/// A body that can move and what it hangs from.
struct Hung {
  int body;
  int parent;          ///< May be locked.
  const Joint* joint;  ///< Of the model; null: nothing holds it.
};

/// All bodies that can move, parents first; those of a tree that hangs from nothing stand together, after all that hang
/// from what does not move.  Empty where a joint closes a loop.  Joints between what does not move hold nothing.
std::vector<Hung> forest(const Model&);

}  // namespace cylon::engine
