// What is drawn of a measured motion, and held against a band: numbers over its frames.
#pragma once

#include "reference/measured/experiment.h"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace cylon::validation {

/// Of a free body x, y, z of its centre, in lengths of the data [m]; of a chain the angle of each body [rad].
std::vector<std::string> curve_names(const measured::Experiment&);
const char* curve_unit(const measured::Experiment&);  ///< "m", "rad".

/// Standard deviation of what is measured of each.
Eigen::VectorXd curve_noise(const measured::Experiment&);

/// A row for each state, a column for each name.  Turns of a chain are counted: an angle changes by less than pi from a state to
/// the next, and begins within pi of that of `beside`.
Eigen::MatrixXd curves(const measured::Experiment&, const std::vector<core::State>&,
                       const core::State& beside);

}  // namespace cylon::validation
