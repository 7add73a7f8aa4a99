// What the elements of a URDF say and urdfdom does not read: its tree holds robot, links and joints alone.
#pragma once

#include "harness/imports/model/model.h"

#include <map>
#include <string>
#include <vector>

namespace cylon::formats {

struct Tags {
  std::vector<foreign::Loss> losses;
  std::map<std::string, int> inertials;  ///< Links with <inertial>, and its line.
};

/// Of a file that urdfdom takes.
Tags tags_of(const std::string& file);

/// Throws Refused, with line and name, at a joint whose link hangs on itself, where urdfdom finds no root and names none,
/// or is the child of another joint, where it makes two links of one.
void require_tree(const std::string& file);

}  // namespace cylon::formats
