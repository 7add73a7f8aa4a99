// The keys of a file that describes measured motions.
#pragma once

#include "harness/scenario/keys.h"

namespace cylon::measured {

const scenario::Spec& experiment_keys();

}  // namespace cylon::measured
