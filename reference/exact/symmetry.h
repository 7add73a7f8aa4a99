// The symmetry axis of an inertia tensor with two equal principal moments.
#pragma once

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

/// Refuses a body without two equal moments (within 1e-12) or with moments that are not positive.
void check_symmetric(std::string_view solution, const core::Scene&, int body);

}  // namespace cylon::exact
