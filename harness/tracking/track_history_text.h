// The history for people at a terminal, and as JSON.
#pragma once

#include "harness/tracking/track_history_rows.h"
#include "reports/console_options.h"

#include <string>
#include <vector>

namespace cylon::tracking {

/// A block per cell: speed, then accuracy, then the rest; a sparkline each, its changes below.
std::string history_text(const std::vector<HistoryRow>&, const reports::ConsoleOptions&);

/// {"schema": 1, "series": […]}: every point and every change.
std::string history_json(const std::vector<HistoryRow>&);

}  // namespace cylon::tracking
