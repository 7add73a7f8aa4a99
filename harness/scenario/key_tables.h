// The tables of a scenario file, by what they are about.
#pragma once

#include "harness/scenario/keys.h"

namespace cylon::scenario {

const Spec* body_spec();
const Spec* lattice_spec();
const Spec* cloud_spec();

const Spec* joint_spec();

const Spec* claim_spec();

}  // namespace cylon::scenario
