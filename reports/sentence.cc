#include "reports/sentence.h"

#include "reports/text.h"

#include <fmt/format.h>

namespace cylon::reports {
namespace {

constexpr std::size_t longest = 400;  // bytes of a foreign text in a one-line reason

std::string quoted(const std::string& text) { return escaped(head(text, longest), is_printable); }

std::string what_happened(const results::Verdict& v) {
  std::string text;
  if (is_measured(v.status)) {
    const std::string unit = quoted(v.unit);
    const char* space = unit.empty() ? "" : " ";
    text = fmt::format(": measured {:.4g}{}{}, allowed {:.4g}{}{}, {:+.1f} digits", v.measured, space, unit,
                       v.allowed, space, unit, results::digits(v.measured, v.allowed));
  } else if (v.first_bad_step) {
    text = fmt::format(": not finite from step {}", *v.first_bad_step);
  }
  if (v.tolerance_scale != 1) text += fmt::format("; all tolerances times {:g}", v.tolerance_scale);
  if (!v.detail.empty()) text += (text.empty() ? ": " : "; ") + quoted(v.detail);
  return text;
}

}  // namespace

bool is_measured(results::Status status) {
  return status == results::Status::pass || status == results::Status::low_quality ||
         status == results::Status::fail;
}

std::string expectation(const results::Verdict& v) {
  if (!v.expected_size) return std::string(results::name(v.expected));
  return fmt::format("{:.3g} within a factor of {:g}", *v.expected_size, v.expected_within);
}

std::string sentence(const results::Verdict& v) {
  const std::string expected = v.as_expected() ? v.status == results::Status::pass ? "" : " (as expected)"
                                               : fmt::format(" (expected {})", reports::expectation(v));
  std::string line = fmt::format("{}{}{}", results::name(v.status), expected, what_happened(v));
  if (!v.expected_reason.empty()) line += fmt::format("; expected.toml: {}", quoted(v.expected_reason));
  return line;
}

}  // namespace cylon::reports
