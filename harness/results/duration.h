// Durations and steps as a person reads them, on the console and in every report; web/src/report/numbers.ts does the same.
#pragma once

#include <string>
#include <string_view>

namespace cylon::results {

/// "4 ms", "0.125 ms", "41 µs": rounded to significant digits, with the largest unit of which it is a tenth or more.  "": not
/// finite.
std::string duration(double seconds, int digits = 3);

/// A step that was asked for, "1/60" or "5e-04", exactly: as duration() where three digits say it, else as it was asked for:
/// "1/60 s", "0.5 ms".  Another text is left as it is.
std::string step_in_words(std::string_view asked);

}  // namespace cylon::results
