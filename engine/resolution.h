// Whether the number type can hold a model: places beside lengths, masses beside one another.  One rule for
// every precision, written in its epsilon.
#pragma once

#include "engine/model.h"

#include <functional>
#include <string>

namespace cylon::engine {

enum class Path;

/// How a thing of a model is called in a reason.
enum class Thing { body, plane };
using Names = std::function<std::string(Thing, int)>;

/// "body 3", "plane 0".
std::string numbered(Thing, int);

/// The largest error of what is stored, as a part of what it is for: beyond a tenth no digit is right.
///
/// Only the rounding of the model itself counts, so the bounds hold for every program that keeps these
/// numbers. What the steps of a run add is for the run to show.  u(x) is the unit in the last place of x; a
/// number is stored to u/2.
///
/// Places.  The difference a - b of two places that are near each other is exact (Sterbenz), so its error is
/// that of the places, at most (u(a_i) + u(b_i))/2 in coordinate i.
/// - Two bodies that touch are in one place: the distance is known to |u(a)|, the norm over the coordinates.
/// - Two ends of a spring, an attraction or a joint: to |u(a) + u(b)|/2.
/// - A body and a plane n.x = d: to sum |n_i| u(a_i)/2 + u(d)/2.  A coordinate along the plane has no part in
///   it.
///
/// Masses.  What two bodies exchange follows from 1/m + 1/M, of which the heavier one's acceleration needs
/// the second term.  The sum is stored to u(1/m)/2 <= epsilon/(2 m), which is epsilon/2 M/m of 1/M.
inline constexpr Real largest_error = Real(0.1);

/// Why numbers with this epsilon are too coarse for the model as it is at t = 0, with the numbers; or "".
///
/// - Places: the error above is beyond largest_error of the half-width of a body that may touch; of the
///   length between the ends of a spring, an attraction or a joint (of a spring its rest length, if that is
///   more; of a joint the spread of the mass that it turns, if that is more: a joint at the centre of a body
///   has a lever of rounding alone).  A body alone may be anywhere.
/// - Masses, of contacts located in time and of joints: the lighter of two bodies may have to carry the
///   heavier.  Any two bodies that may touch may come to lie on each other where a force acts; of bodies on
///   joints one carries another where it hangs on a second joint.
/// What a body meets later in the run is not known here.
std::string unresolved(const Model&, Path, const Names&);

}  // namespace cylon::engine
