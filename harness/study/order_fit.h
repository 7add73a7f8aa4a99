// The order at which errors fall with the step, and where rounding ends that.  Knows numbers alone.
#pragma once

#include <cstddef>
#include <optional>
#include <span>

namespace cylon::study {

struct StepError {
  double dt = 0;     ///< > 0
  double error = 0;  ///< Relative, >= 0; what is not finite is left out.
};

struct OrderFit {
  std::optional<double> order;  ///< Slope of log error against log dt where the error falls.
  std::size_t used = 0;         ///< Points that it rests on.
  std::optional<double> floor;  ///< The median error from which a finer step does not help.
  double floor_from = 0;        ///< The coarsest step at the floor.
  bool rounding = false;        ///< The floor is as low as rounding, or as the truth's own error.
};

/// The points from the coarsest step to the finest.  `resolution`: a relative error below which nothing can
/// be told (the truth's bound); `epsilon` of the engine's numbers.
///
/// The floor is the longest run of finest steps over which the median of all pairs' slopes (Theil and Sen) is
/// below 0.4, once the error has fallen to a hundredth of its largest, or lies below the resolution or the
/// root of epsilon; its first points are given back while they are ten times above its median.  The order is
/// the median of all pairs' slopes of the four finest points above twenty times the floor and below 0.3,
/// where a trajectory is lost; below the root of epsilon a last point that fell less than three quarters of
/// its due is left out, and points show an order only where each falls, and all of them by a factor of ten.
OrderFit fit_order(std::span<const StepError>, double resolution, double epsilon);

}  // namespace cylon::study
