// Which step an engine needs: the coarsest one of a sweep that meets an error, and why there is none.
#pragma once

#include "harness/results/trade.h"

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace cylon::results {

/// The relative errors for which a cell says the step.
inline constexpr std::array reach_errors = {1e-2, 1e-3, 1e-4};

/// How a series reaches one error.
struct Reach {
  double error = 0;                  ///< Relative, of the table's measure `by`.
  std::optional<std::size_t> point;  ///< The coarsest point that meets it; nothing: not reached.
  bool coarsest_tried = false;       ///< No coarser one was tried: the step may be larger.
  std::string why;                   ///< Where it is not reached: why.
};

/// One engine on one scenario.
struct StepCell {
  std::size_t series = 0;  ///< Of the table.
  std::string refusal;     ///< Why the engine does not run the scene; empty: it does.
  std::string avoidable;   ///< Of a refusal: engines that reach an error all the same, "bullet, ode".
  std::vector<Reach> reach;
};

/// The coarsest point that meets the error, and whose next finer one does too, so that no lucky step counts;
/// the finest counts by itself.  Of an integrator that controls its error the loosest tolerance.
std::optional<std::size_t> coarsest_point(const TradeTable&, const TradeSeries&, double error);

/// Why no point of the series counts: order and the step that it would take, floor, scatter, failure.
std::string why_not_reached(const TradeTable&, const TradeSeries&, double error);

/// A cell for each engine of the table, in its order.  Of an engine with several series the first that has
/// points counts, but no integrator with error control where the engine goes by fixed steps (path
/// "stepping").
std::vector<StepCell> step_cells(const TradeTable&);

/// -log10 of the error at the coarsest step of at most `dt`, and that point; nothing: no finite error there.
struct DigitsAt {
  std::size_t point = 0;
  double digits = 0;
};
std::optional<DigitsAt> digits_at(const TradeTable&, const TradeSeries&, double dt);

}  // namespace cylon::results
