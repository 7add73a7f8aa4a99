// Errors over time: as a picture for pages, as characters for terminals.
#pragma once

#include "reports/console_options.h"
#include "reports/plot.h"
#include "reports/trace.h"

#include <span>
#include <string>

namespace cylon::reports {

/// One scenario's runs, a curve per run: of all claims over states that which some run missed by the most (or
/// kept by the least), with a line at what is allowed.
Plot error_plot(std::span<const reports::Trace* const> runs);

/// A claim's error over time on a logarithmic axis, seven lines high, with a line at what is allowed and the
/// first violation in words.  Braille dots, or in ASCII a star per column.
std::string error_chart(const reports::ErrorCurve&, const ConsoleOptions&);

}  // namespace cylon::reports
