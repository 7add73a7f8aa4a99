// The options of MuJoCo: what each takes, what MuJoCo calls it and where its model has it.
#pragma once

#include "reference/applied/options.h"

namespace cylon::simulators {

/// The place in MuJoCo's model: an attribute of <option>, of <flag>, or a number of solref and solimp.
struct MujocoPlace {
  enum : int { option, flag, reference, impedance };
};

/// The words of a flag are "disable" and "enable"; values are written as MuJoCo reads them.
const applied::Options& mujoco_options();

}  // namespace cylon::simulators
