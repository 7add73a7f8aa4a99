// The symmetry axis of an inertia tensor with two equal principal moments.
#pragma once

#include "harness/core/truth.h"
#include "reference/exact/wide.h"

#include <string_view>

namespace cylon::exact {

struct Symmetry {
  WideVector axis;         ///< Unit, body axes.
  Wide transverse, axial;  ///< I1 = I2 (the mean of what rounding left of them) and I3 [kg m^2].
  Wide difference;         ///< |I1 - I2|/I1, 0 up to rounding for a symmetric body.
};

/// The principal axis whose two other moments differ least; of several the one nearest `hint`, body axes.
Symmetry symmetry(const core::Matrix3& inertia, const core::Vector3& hint = core::Vector3::Zero());

/// What a difference of the two moments does that the solution does not know, added to the bound.  With w the rate and W the
/// rate at which the body turns about its axis against its precession: the axial rate changes by at most
///   difference w^2 min(t, 1/W),  and the orientation by  difference w t (1 + w min(t, 1/W)).
/// Derived for a free body.  Of a heavy top it holds where no deviation grows, not next to an unstable sleeping one.
void add_difference(const core::Scene&, double horizon, core::StateError&);

/// Refuses a body without two equal moments (within 1e-12) or with moments that are not positive.
void check_symmetric(std::string_view solution, const core::Scene&, int body);

}  // namespace cylon::exact
