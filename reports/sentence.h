// One verdict in one line of plain text, shared by every report that people read.
#pragma once

#include "harness/results/verdict.h"

#include <string>

namespace cylon::reports {

/// Whether measured and allowed say anything: pass, low-quality and fail.
bool is_measured(results::Status);

/// What was expected, in words: "fail", or "0.0123 within a factor of 3" where a size is known.
std::string expectation(const results::Verdict&);

/// "fail (expected pass): measured 2.51 rad, allowed 0.001 rad, -3.4 digits; expected.toml: …".  Line ends
/// and control characters of the verdict's own texts are escaped; long texts are cut.
std::string sentence(const results::Verdict&);

}  // namespace cylon::reports
