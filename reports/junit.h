// Verdict rows as JUnit XML, for continuous integration.
#pragma once

#include "harness/results/verdict.h"

#include <string>
#include <vector>

namespace cylon::reports {

/// A <testsuite> per scenario, a <testcase> per engine and claim.  The cases that are not well are exactly
/// those that differ from expected.toml: <error> for a crash, a timeout or a broken protocol, else <failure>.
/// Unsupported as expected is <skipped>; any other expected trouble passes, with a note in <system-out>.
/// The text of each element is a one-line reason; the command that gives the row again follows.
std::string to_junit(const std::vector<results::Verdict>&);

}  // namespace cylon::reports
