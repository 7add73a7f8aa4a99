// All that is wrong with one file.
#pragma once

#include "harness/core/input_error.h"

#include <utility>
#include <vector>

namespace cylon::core {

/// As an InputError it is the first of them.
struct InputErrors : InputError {
  /// At least one, in the order of the file.
  explicit InputErrors(std::vector<InputError> all) : InputError(all.front()), each(std::move(all)) {}

  std::vector<InputError> each;
};

}  // namespace cylon::core
