// Verdict rows for people at a terminal.
#pragma once

#include "harness/results/verdict.h"
#include "reports/console_options.h"

#include <string>
#include <vector>

namespace cylon::reports {

/// Matrix, legend, and what console_summary says.
std::string console_matrix(const std::vector<results::Verdict>&, const ConsoleOptions&);

/// Every verdict that differs from expected.toml, warnings, scenes supported and, last, the summary.
std::string console_summary(const std::vector<results::Verdict>&, const ConsoleOptions&);

/// Per scenario, engine and step a table of claims: measured, allowed, digits, status, the tolerance's
/// reason; above it what the run was made with.
std::string console_details(const std::vector<results::Verdict>&, const ConsoleOptions&);

/// One verdict in full: who, what, measured against allowed, the engine's last words, the command for it.
std::string difference(const results::Verdict&, const ConsoleOptions&);

/// "40 verdicts: 30 pass, 8 as expected (5 fail, 3 unsupported), 2 differ (1 crash, 1 pass)": three groups
/// that add up.
std::string summary(const std::vector<results::Verdict>&);

/// A line per engine version that expected.toml does not know; else "".
std::string unlisted(const std::vector<results::Verdict>&, const ConsoleOptions&);

}  // namespace cylon::reports
