// log10(allowed / measured) as a person reads it.
#pragma once

#include <fmt/format.h>

#include <string>

namespace cylon::results {

/// "+1.0", of what digits() gives; "exact" for an error of exactly 0, which it gives as 99.
inline std::string digits_text(double digits) {
  return digits >= 99 ? "exact" : fmt::format("{:+.1f}", digits);
}

/// The same in a sentence: "+1.0 digits", "exact".
inline std::string digits_in_words(double digits) {
  return digits_text(digits) + (digits >= 99 ? "" : " digits");
}

}  // namespace cylon::results
