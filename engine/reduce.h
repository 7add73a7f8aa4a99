// Reduced coordinates: none for locked bodies, and none for what a joint to the world forbids.
#pragma once

#include "engine/model.h"

#include <string>
#include <vector>

namespace cylon::engine {

/// How a body of a reduced model relates to the body that was given.
struct Reading {
  int body = 0;                    ///< The body that was given.
  bool pinned = false;             ///< Its motion is that of the pivot, or of a point on its axis.
  bool keeps_orientation = false;  ///< The rod that replaces a point at a length turns; the point does not.
  Quaternion orientation = Quaternion::Identity();  ///< The one that it keeps.
  Matrix3 inertia = Matrix3::Zero();                ///< About the centre of mass, body axes [kg m^2].
};

struct Reduced {
  Model model;
  std::vector<Reading> readings;    ///< One per body of `model`.
  std::vector<std::string> pinned;  ///< For the plan: "body 0 turns about a point", …
};

/// Locked bodies come last.  Puts each body that a joint to the world lets turn about a point or about an axis,
/// and each point that one keeps at a length, in coordinates in which that joint cannot open; the joint goes.
/// The reference point becomes the pivot, the inertia
///   I_p = I + m (|c|^2 1 - c c^T)   (seed eq. 70, 71; errata 15),
/// about an axis h alone  h^T I_p h,  for a point on a rod  m l^2 (1 - n n^T).  Also each body that one joint, to
/// the world, lets move along an axis, move along it and turn about it, or move in a plane and turn about its
/// normal: momenta and forces within that space are left.  Left as they are:
/// bodies that can touch something or float, and second joints of a body.
Reduced reduce(Model);

/// The motions of the centres of mass, one per body that was given.  Resizes; what has that size already keeps
/// the motions of bodies that are locked.
void read(const std::vector<Body>&, const std::vector<Reading>&, const Motion*, std::vector<Motion>& given);

}  // namespace cylon::engine
