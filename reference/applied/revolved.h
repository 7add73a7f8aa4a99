// The part below a plane of what a circle of changing radius sweeps along an axis.
#pragma once

#include "harness/core/shapes.h"

#include <vector>

namespace cylon::applied {

/// A solid of revolution between two planes across its axis:  radius^2 = c0 + c1 s + c2 s^2,  s from low to high
/// along the axis [m].
struct Revolved {
  double low = 0, high = 0;
  double c0 = 0, c1 = 0, c2 = 0;  ///< [m^2], [m], 1.
};

/// A capsule, a cylinder or a cone about its body's y, piece by piece.
std::vector<Revolved> revolved(const core::Capsule&);
std::vector<Revolved> revolved(const core::Cylinder&);
std::vector<Revolved> revolved(const core::Cone&);

struct RevolvedBelow {
  double volume = 0;                             ///< [m^3]
  core::Vector3 moment = core::Vector3::Zero();  ///< Of the volume about s = 0 [m^4].
};

/// What of it lies below y = height, with s = 0 at the origin and a unit axis.  Relative error about 1e-13.
RevolvedBelow below(const Revolved&, const core::Vector3& axis, double height);

}  // namespace cylon::applied
