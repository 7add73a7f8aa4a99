// A scene as MuJoCo reads it: a text in its XML, every number with 17 digits.  Knows no MuJoCo header.
#pragma once

#include "harness/core/scene.h"
#include "reference/applied/forest.h"
#include "reference/simulators/mujoco/mujoco_contacts.h"
#include "reference/simulators/mujoco/mujoco_settings.h"

#include <string>

namespace cylon::simulators {

/// Names in the text: body i is "bi", its joint "ji"; geoms of the world are the planes in their order.
std::string mujoco_xml(const core::Scene&, const applied::Forest&, const MujocoContacts&,
                       const MujocoSettings&, double dt);

/// The name of body i.
std::string mujoco_body_name(int i);

}  // namespace cylon::simulators
