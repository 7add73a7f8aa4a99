#include "harness/cli/sparkline.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <string_view>

namespace cylon::cli {
namespace {

constexpr std::array<std::string_view, 8> blocks = {"▁", "▂", "▃", "▄", "▅", "▆", "▇", "█"};
constexpr std::array<std::string_view, 8> ascii = {"_", ".", "-", ":", "=", "+", "*", "#"};

}  // namespace

std::size_t column_of(std::size_t i, std::size_t n, std::size_t width) {
  return n <= width ? i : i * width / n;
}

std::string sparkline(std::span<const double> values, double least_range, bool utf8, std::size_t width) {
  const std::size_t columns = std::min(values.size(), width);
  std::vector<double> sums(columns, 0.0), counts(columns, 0.0);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const std::size_t column = column_of(i, values.size(), width);
    sums[column] += values[i], counts[column] += 1;
  }
  double low = std::numeric_limits<double>::infinity(), high = -low;
  for (std::size_t c = 0; c < columns; ++c)
    if (counts[c] > 0) low = std::min(low, sums[c] / counts[c]), high = std::max(high, sums[c] / counts[c]);
  if (high - low < least_range) {
    const double middle = low / 2 + high / 2;
    low = middle - least_range / 2, high = middle + least_range / 2;
  }
  std::string line;
  for (std::size_t c = 0; c < columns; ++c) {
    const double height = high > low ? 8 * (sums[c] / counts[c] - low) / (high - low) : 0;
    const auto level = static_cast<std::size_t>(std::clamp(height, 0.0, 7.0));
    line += counts[c] == 0 ? "?" : (utf8 ? blocks : ascii)[level];
  }
  return line;
}

std::string letters(const std::vector<std::string>& texts, std::size_t width) {
  std::vector<std::string> seen;
  std::string line(std::min(texts.size(), width), ' ');
  for (std::size_t i = 0; i < texts.size(); ++i) {
    auto at = std::find(seen.begin(), seen.end(), texts[i]);
    if (at == seen.end()) at = seen.insert(seen.end(), texts[i]);
    const auto n = at - seen.begin();
    line[column_of(i, texts.size(), width)] = n < 26 ? static_cast<char>('a' + n) : '#';
  }
  return line;
}

}  // namespace cylon::cli
