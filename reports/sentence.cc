#include "reports/sentence.h"

#include "harness/results/digits_text.h"
#include "reports/text.h"

#include <fmt/format.h>

namespace cylon::reports {
namespace {

constexpr std::size_t longest = 400;  // bytes of a foreign text in a one-line reason

std::string quoted(const std::string& text) { return escaped(head(text, longest), is_printable); }

}  // namespace

bool has_allowed(const results::Verdict& v) {
  return is_measured(v.status) || v.status == results::Status::non_finite;
}

std::string measured_text(const results::Verdict& v) {
  const std::string interval =
      v.interval ? fmt::format(" [{:.4g}, {:.4g}]", v.interval->low, v.interval->high) : "";
  return fmt::format("{:.4g}{}{}{}", v.measured, interval, v.unit.empty() ? "" : " ", quoted(v.unit));
}

namespace {

std::string what_happened(const results::Verdict& v) {
  std::string text;
  if (is_measured(v.status)) {
    const std::string unit = quoted(v.unit);
    text = fmt::format(": measured {}, allowed {:.4g}{}{}, {}", measured_text(v), v.allowed,
                       unit.empty() ? "" : " ", unit,
                       results::digits_in_words(results::digits(v.measured, v.allowed)));
  } else if (v.first_bad_step) {
    text = fmt::format(": not finite from step {}", *v.first_bad_step);
  }
  if (v.tolerance_scale != 1) text += fmt::format("; all tolerances times {:g}", v.tolerance_scale);
  if (!v.detail.empty()) text += (text.empty() ? ": " : "; ") + quoted(v.detail);
  return text;
}

}  // namespace

std::string expectation(const results::Verdict& v) {
  if (!v.expected_size) return std::string(results::name(v.expected));
  return fmt::format("{:.3g} within a factor of {:g}", *v.expected_size, v.expected_within);
}

std::string sentence(const results::Verdict& v) {
  const bool silent = v.status == results::Status::pass || v.status == results::Status::undecided;
  const std::string expected = !v.as_expected() ? fmt::format(" (expected {})", reports::expectation(v))
                               : silent         ? ""
                                                : " (as expected)";
  std::string line = fmt::format("{}{}{}", results::name(v.status), expected, what_happened(v));
  if (!v.expected_reason.empty()) line += fmt::format("; expected.toml: {}", quoted(v.expected_reason));
  return line;
}

}  // namespace cylon::reports
