// The first blow within a step, isolated by proof.
#pragma once

#include "reference/certified/flow.h"

#include <optional>

namespace cylon::certified {

struct Impact {
  Ball time;  ///< After the step's start [s].
  std::size_t contact = 0;
};

/// The first root of all gaps in the step, no later than `until` after its start; nothing where all are
/// proven to stay open.  Every gap is positive at the start, or vanishes there and opens (that of a blow that
/// has just been).  A gap is open over a piece of the step where its enclosure is positive, or where it
/// grows; it has one root where it falls from a positive to a negative value, which interval Newton then
/// narrows.  Else the piece is halved.  Throws Stuck where that ends without a proof, and where the first
/// root cannot be told from another pair's.
std::optional<Impact> first_impact(const Model&, const Step&, double until);

/// The state variables after it, for every solution of the set.
std::vector<Ball> state_after(const Model&, const Step&, const Impact&);

/// A ball that holds [a, b].
Ball span(double a, double b);
/// Bounds of a ball in double.
double lower(const Ball&);
double upper(const Ball&);

}  // namespace cylon::certified
