// What both formats ask of a scene before they write it.
#pragma once

#include "harness/exports/unsayable.h"

#include "harness/core/scene.h"

#include <set>
#include <string>
#include <vector>

namespace cylon::exports {

/// How the numbers of two surfaces become those of their pair.
struct PairRule {
  double (*friction)(double, double);
  bool restitution;  ///< It has one, the product; without, impacts are inelastic.
};

/// Friction and restitution of one body or plane alone.
struct Surface {
  double friction = 0, restitution = 0;
};

/// Numbers of bodies and of planes that give those of all pairs that may touch.
struct Surfaces {
  std::vector<Surface> of_body, of_plane;
};

/// Throws Unsayable at a material that the rule cannot give.
Surfaces surfaces_of(const core::Scene&, const PairRule&);

/// The name, with a number where it is taken; takes it.
std::string unique(std::string name, std::set<std::string>& taken);

/// Throws Unsayable at what neither format says: forces other than gravity, a frame, simultaneous impacts.
void require_plain(const core::Scene&);

/// The body that a joint's other end counts as: the world in place of a locked body without a surface.  Throws
/// Unsayable at a locked body that has one.
int other_end(const core::Scene&, const core::Joint&);

/// The parts of a body's shape with their poses in it; no part: it has none.
std::vector<core::Part> parts_of(const core::Body&);

/// The name of the body, or "world".
const std::string& name_of(const core::Scene&, int body);

/// Throws Unsayable at what neither format says of the coordinates: a restitution of limits, a target that moves, a
/// quadratic damper.
void require_plain(const core::Scene&, const core::Joint&);

}  // namespace cylon::exports
