// Which build made a report, when, and by which command line: the one place that reads the clock.
#pragma once

#include "harness/cli/context.h"
#include "reports/provenance.h"

#include <string>

namespace cylon::cli {

/// The date and time that it is, ISO 8601 in UTC.
std::string now();

/// Of this program, this command line and now.
reports::Provenance provenance_now(const Context&);

}  // namespace cylon::cli
