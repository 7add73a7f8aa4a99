// Forces and torques of a scene on its bodies, all but those of contacts and joints, for those who judge motion.
#pragma once

#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::core {

/// A force and a torque, or what they give over a time, each with a bound on its error.
struct Load {
  Vector3 force = Vector3::Zero();   ///< [N]
  Vector3 torque = Vector3::Zero();  ///< [N m]
  double force_error = 0;            ///< [N]
  double torque_error = 0;           ///< [N m]
};

/// Why the forces of a scene do not follow from its state and the time by a law that is known here, or nothing:
/// water, a plug-in's force, a mass that changes, a frame that turns or accelerates.
std::optional<std::string> loads_unknown(const Scene&);

/// One for each body: the force, the torque about its centre of mass, and first-order bounds on what an error of the
/// state makes of them.  Requires that loads_unknown(scene) says nothing.
std::vector<Load> loads(const Scene&, double t, const State&, const StateError&);

/// Largest principal moment [kg m^2].
double largest_moment(const Body&);

}  // namespace cylon::core
