// What `cylon validate` accepts, every other part accepts: the worker's reader, the truths, the writer of the viewer's
// recordings, the sampling.
#pragma once

#include "harness/scenario/scenario.h"

#include <string>

namespace cylon::fuzz {

/// What a part says against a scene that the reader took; "" where all take it.
std::string objection(const scenario::Scenario&);

}  // namespace cylon::fuzz
