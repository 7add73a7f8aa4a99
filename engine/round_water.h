// The part of a body of revolution below a water surface.
#pragma once

#include "engine/water.h"

#include <initializer_list>

namespace cylon::engine {

/// A piece of a body of revolution about y:  (its radius at y)^2 = a + b y + c y^2 [m^2],  from <= y <= to [m].
struct RoundPiece {
  Real from = 0, to = 0;
  Real a = 0, b = 0, c = 0;
};

/// To 1e-12 of the volume.  The slice at y is a disc of radius r, of which the part with x <= q lies below the surface, x up along
/// the disc and q the surface's:
///   A = r^2 (pi - arccos(q/r)) + q w,  w = sqrt(r^2 - q^2),  and its first moment in x  -2/3 w^3.
/// They are integrated between the slices that are dry, wet in part, and wet, by Gauss and Legendre's rule in the angle f
/// with y = middle - half cos f, in which the ends are smooth.
Submerged submerged(std::initializer_list<RoundPiece>, const Vector3& position, const Matrix3& rotation,
                    Real height);

}  // namespace cylon::engine
