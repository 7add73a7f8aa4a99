// The parts of a shape, one where it is no compound.
#pragma once

#include "harness/core/shapes.h"

#include <vector>

namespace cylon::applied {

std::vector<core::Part> parts_of(const core::Shape&);

}  // namespace cylon::applied
