// Where two runs of one scene part: the first sample, body and quantity, and how far they are apart at every
// sample.
#pragma once

#include "harness/core/observable.h"
#include "harness/core/trajectory.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace cylon::study {

/// How far two motions are from each other in one quantity.
struct Curve {
  core::Quantity quantity = core::Quantity::position;
  std::string_view unit;
  double allowed = 0;                ///< In the unit.
  std::vector<double> distance;      ///< Of the worst body, or of the totals; one per sample.
  std::vector<int> body;             ///< The worst one; -1: a total.
  std::optional<std::size_t> first;  ///< The first sample with a distance above `allowed`, or NaN.
  std::size_t largest = 0;           ///< The sample with the largest distance, NaN above all.
};

/// Positions, orientations, velocities and angular velocities body by body; momentum, angular momentum and
/// energy of all.  Allowed is `tolerance` times the scene's own scales L, V (study::scales) and its mass M:
/// L, 1 rad, V, the angular velocity; M V, M V L, M V^2/2.  Requires as many states in both, at the same
/// times, and tolerance >= 0; at 0 any difference counts.
std::vector<Curve> divergence(const core::Scene&, double duration, const core::Trajectory&,
                              const core::Trajectory&, double tolerance);

/// The curve that parts first; of several at one sample, that with the largest distance over what is allowed.
/// Null where none does.
const Curve* first_to_part(std::span<const Curve>);

/// The least p and q, at most 10^4, with p a = q b within 1e-9; nothing where there are none.  For steps a, b
/// > 0.
struct Multiples {
  std::int64_t of_a = 1, of_b = 1;
};
std::optional<Multiples> common_multiple(double a, double b);

}  // namespace cylon::study
