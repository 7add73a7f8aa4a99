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

/// The largest unit in the last place of a coordinate that a length of 1 is told from.
///
/// The orbit of 1.5 m on a spring leaves its place by a hundredth where that is 1/192 of it, in double and in
/// float alike (`cylon limits origin`, before the engine refused: 7.0e13 m and 1.0e5 m); this is less than
/// half of that.  A ball of 0.1 m that starts 1033 m out, 1/820, is what still has to run (scenario
/// tunnel_thin_wall).
inline constexpr Real coarsest_place = Real(1) / 512;

/// The largest product of epsilon and the ratio of two masses, where the lighter carries the heavier.
///
/// What they exchange follows from the sum of their reciprocal masses, 1/m + 1/M.  It is rounded to
/// epsilon/m, which is epsilon M/m of 1/M: by that part the heavier one's acceleration is wrong, of g by half
/// of 1/1024 g = 5 mm in the first second.
inline constexpr Real coarsest_mass = Real(1) / 1024;

/// Why numbers with this epsilon are too coarse for the model as it is at t = 0, with the numbers; or "".
///
/// - A unit in the last place of the largest coordinate of a body that may touch exceeds coarsest_place of
///   its half-width; of a plane, of the least half-width that may meet it; of the ends of a spring, an
///   attraction or a joint, of the length between them (of a spring its rest length, if that is more).  A
///   body alone may be anywhere.
/// - Contacts located in time and joints: the lighter of two bodies may have to carry the heavier, and
///   epsilon times the ratio of their masses exceeds coarsest_mass.  Any two bodies that may touch may come
///   to lie on each other where a force acts; of bodies on joints one carries another where it hangs on a
///   second joint.
/// What a body meets later in the run is not known here.
std::string unresolved(const Model&, Path, const Names&);

}  // namespace cylon::engine
