// Where a body touches the scene's plane, and what of its energy is gone then: of measured and predicted states alike.
#pragma once

#include "reference/measured/experiment.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace cylon::validation {

/// The states touch where the body's lowest point is less than this above the plane [m]: what gives in an impact, and what lengths
/// are off, is less.
inline constexpr double touching = 0.005;

struct Touch {
  double time = 0;  ///< [s]
  core::Vector3 centre;
};

/// Where the states first touch, a straight line between frames; none where they begin so.
std::optional<Touch> first_touch(const measured::Experiment&, const std::vector<core::State>&);

/// Share of the energy (kinetic, and potential above the plane) that is gone 0.1 s after the first touch.
std::optional<double> loss_after_first(const measured::Experiment&, const std::vector<core::State>&);

/// Share of the energy before it that each touch takes: 1 - E'/E, E and E' means over the flights before and after it.  Smoothed
/// data spread an impact over the frames beside it: frames within two of a touch do not count, and where fewer than three are left
/// of either flight the loss is not known (NaN).  What follows the last flight is no touch between two.
std::vector<double> losses_of_touches(const measured::Experiment&, const std::vector<core::State>&);

/// Of a touch by its place in a run: how many measured runs have a flight after it, and in how many its loss is known.
struct TouchCount {
  std::size_t flights = 0, known = 0;
};
std::vector<TouchCount> touch_counts(const measured::Experiment&);

}  // namespace cylon::validation
