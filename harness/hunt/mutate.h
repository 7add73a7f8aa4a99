// A scene that somebody wrote, with changes that keep it valid: joints stay closed, what touches goes on touching.
#pragma once

#include "harness/hunt/trial.h"

#include <span>
#include <string_view>

namespace cylon::hunt {

class Dice;

struct Mutation {
  std::string_view says;  ///< What it changes, one clause.
  /// False where the scene has nothing of the kind.
  bool (*make)(Dice&, Trial&);
};

std::span<const Mutation> mutations();

/// The trial with one to three changes.
Trial mutated(Dice&, Trial);

}  // namespace cylon::hunt
