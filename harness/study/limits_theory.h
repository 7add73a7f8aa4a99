// What theory says of integrators on x'' = -x and on x' = -x, from their coefficients alone.
#pragma once

#include "harness/core/scene.h"

#include <Eigen/Core>

#include <functional>
#include <limits>
#include <optional>
#include <string_view>

namespace cylon::study {

/// One step of h = omega dt on (x, v/omega): (x, v)' = M (x, v).  Nothing for an integrator that is not
/// known or that chooses its own steps.
using StepMatrix = std::function<Eigen::Matrix2d(double h)>;
std::optional<StepMatrix> step_matrix(std::string_view integrator);

/// Largest h up to which every power of the step matrix stays bounded; 0: none.
std::optional<double> stable_oscillation(std::string_view integrator);

/// Largest c dt / m up to which a velocity that is damped by -c v does not grow.
std::optional<double> stable_damping(std::string_view integrator);

/// The last n before the unit circle's exact motion and the integrator's are further apart than `distance`;
/// infinity: not within 10^7 steps.
std::optional<double> steps_until(std::string_view integrator, double h, double distance);

}  // namespace cylon::study
