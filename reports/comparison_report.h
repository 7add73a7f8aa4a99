// Comparisons of two builds for people at a terminal, for programs and for continuous integration.
#pragma once

#include "harness/results/comparison.h"
#include "reports/console_options.h"

#include <string>

namespace cylon::reports {

/// A table with a line per cell - outcome, ratio of times with its interval, pairs, what changed in the
/// results - then the reason of everything that regressed with the command that compares it again, and a
/// summary.
std::string console(const results::ComparisonReport&, const ConsoleOptions&);

/// {"schema":1, "baseline", "candidate", "tau", "alpha", "gate", "reliable", "self_check", "notes",
/// "cells":[…]}. Numbers that are not finite are null.
std::string to_json(const results::ComparisonReport&);

/// A <testsuite> per scenario, a <testcase> per engine and step: <failure> for a regression, <skipped> for
/// what was not compared or did not decide; the rest passes, with what changed in <system-out>.
std::string to_junit(const results::ComparisonReport&);

/// What changed, in words: "error of position: rose by 25 %, …; state hash: …"; "" where nothing did.
std::string changes(const results::Comparison&);

/// The first that regressed, or else that changed, and how many more there are.
std::string brief(const results::Comparison&);

/// "x 1.052 (1.047 … 1.058)", or why there is no time.
std::string ratio(const results::Comparison&);

/// "2 regressed, 1 improved, 5 the same": those that occur, the worst first.
std::string summary(const results::ComparisonReport&);

/// Why no time is believed; "" where the environment is reliable.
std::string warning(const results::ComparisonReport&);

}  // namespace cylon::reports
