// The tables of a scenario file, by what they are about.
#pragma once

#include "harness/scenario/keys.h"

namespace cylon::scenario {

const Spec* body_spec();
const Spec* lattice_spec();
const Spec* cloud_spec();

const Spec* spring_spec();
const Spec* drag_spec();
const Spec* thrust_spec();
const Spec* drive_spec();
const Spec* attraction_spec();
const Spec* water_spec();

const Spec* joint_spec();
const Spec* plane_spec();
const Spec* material_spec();
const Spec* frame_spec();

const Spec* claim_spec();

}  // namespace cylon::scenario
