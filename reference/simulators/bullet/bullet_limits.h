// What Bullet does whatever is set, one sentence each, with the place in the sources of Debian's version, below
// src/.
#pragma once

#include <string>
#include <vector>

namespace cylon::simulators {

std::vector<std::string> unforceable_rigid();
std::vector<std::string> unforceable_multibody();

}  // namespace cylon::simulators
