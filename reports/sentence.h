// One verdict in one line of plain text, shared by every report that people read.
#pragma once

#include "harness/results/verdict.h"

#include <string>

namespace cylon::reports {

/// What was expected, in words: "fail", or "0.0123 within a factor of 3" where a size is known.
std::string expectation(const results::Verdict&);

/// "0.013 rad", and where an interval is known: "0.013 [0.008, 0.018] rad".
std::string measured_text(const results::Verdict&);

/// Whether allowed says anything: of what is measured, and of what is not finite.
bool has_allowed(const results::Verdict&);

/// "fail (expected pass): measured 2.51 rad, allowed 0.001 rad, -3.4 digits; expected.toml: …".  Line ends
/// and control characters of the verdict's own texts are escaped; long texts are cut.
std::string sentence(const results::Verdict&);

}  // namespace cylon::reports
