#include "harness/results/duration.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <utility>

namespace cylon::results {
namespace {

// The number and its unit.
std::pair<double, const char*> with_prefix(double seconds) {
  constexpr std::pair<double, const char*> units[] = {
      {1, "s"}, {1e-3, "ms"}, {1e-6, "µs"}, {1e-9, "ns"}, {1e-12, "ps"}};
  for (const auto& [scale, unit] : units)
    if (std::abs(seconds) >= 0.1 * scale) return {seconds / scale, unit};
  return {seconds == 0 ? 0 : seconds / 1e-12, seconds == 0 ? "s" : "ps"};
}

// Of a number, or of one over another, and nothing else.
bool is_step(std::string_view text, double& value) {
  const auto number = [](std::string_view digits, double& into) {
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), into);
    return error == std::errc() && end == digits.data() + digits.size() && std::isfinite(into);
  };
  const std::size_t slash = text.find('/');
  double over = 1;
  const bool is = number(text.substr(0, slash), value) &&
                  (slash == std::string_view::npos || number(text.substr(slash + 1), over));
  value /= over;
  return is && std::isfinite(value);
}

}  // namespace

std::string duration(double seconds, int digits) {
  if (!std::isfinite(seconds)) return "";
  const auto [number, unit] = with_prefix(seconds);
  const std::string text = fmt::format("{:.{}g}", number, digits);
  return fmt::format("{} {}", text.find("e+") == std::string::npos ? text : fmt::format("{:.0f}", number),
                     unit);
}

std::string step_in_words(std::string_view asked) {
  double seconds = 0;
  if (!is_step(asked, seconds)) return std::string(asked);
  const auto [number, unit] = with_prefix(seconds);
  const bool exact = std::abs(std::stod(fmt::format("{:.3g}", number)) - number) <= 1e-12 * std::abs(number);
  return exact ? duration(seconds) : fmt::format("{} s", asked);
}

}  // namespace cylon::results
