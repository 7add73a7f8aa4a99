#include "harness/cli/commands/published.h"

#include "harness/scenario/glob.h"
#include "harness/scenario/input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::cli {
namespace {

// Digits of the mantissa from the first that is not zero: 6 for "185.027", "1.20178e6" and ".00185027".
int significant_digits(const std::string& text) {
  int digits = 0;
  for (const char c : text.substr(0, text.find_first_of("eE")))
    if (c >= '0' && c <= '9' && (digits > 0 || c != '0')) ++digits;
  return digits;
}

std::string rounded(double value, int digits) {
  return fmt::format("{:.{}e}", value, std::max(0, digits - 1));
}

}  // namespace

bool same_digits(double measured, const std::string& published) {
  const int digits = significant_digits(published);
  return std::isfinite(measured) && rounded(measured, digits) == rounded(std::stod(published), digits);
}

Reproduction reproduce(const scenario::Suite& suite, const std::vector<results::Verdict>& rows) {
  Reproduction result;
  for (const auto& published : suite.published) {
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const results::Verdict& r) {
      return r.engine == published.engine && r.dt == scenario::parse_step(published.dt) &&
             scenario::glob_match(suite.claim, r.claim);
    });
    if (row == rows.end()) continue;
    const bool same = same_digits(row->measured, published.value);
    result.complete = result.complete && same;
    result.text += fmt::format(
        "{:<28} {:>6}  {:>14}  {:>14.{}g}  {}\n", published.engine, published.dt, published.value,
        row->measured, std::max(6, significant_digits(published.value)), same ? "every digit" : "DIFFERS");
  }
  if (!result.text.empty())
    result.text =
        fmt::format("\n{:<28} {:>6}  {:>14}  {:>14}\n", "published numbers", "dt", "published", "here") +
        result.text;
  return result;
}

}  // namespace cylon::cli
