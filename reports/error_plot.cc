#include "reports/error_plot.h"

#include "harness/results/duration.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace cylon::reports {
namespace {

// Largest error over what is allowed; NaN is beyond everything.
double peak(const reports::ErrorCurve& curve) {
  double most = 0;
  for (const double value : curve.value)
    most = std::max(most, std::isnan(value) ? std::numeric_limits<double>::infinity() : value);
  return curve.allowed > 0 ? most / curve.allowed : most > 0 ? HUGE_VAL : 0;
}

// ---- A field of dots: 2 x 4 in a character ---------------------------------------------------------

class Dots {
 public:
  Dots(int columns, int rows, bool braille)
      : columns_(columns),
        rows_(rows),
        braille_(braille),
        cells_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), 0) {}

  int width() const { return columns_ * (braille_ ? 2 : 1); }
  int height() const { return rows_ * (braille_ ? 4 : 1); }

  void set(int x, int y) {
    if (x < 0 || y < 0 || x >= width() || y >= height()) return;
    // Unicode's Braille Patterns: dots 1 2 3 7 down the left, 4 5 6 8 down the right.
    constexpr int bits[2][4] = {{0x01, 0x02, 0x04, 0x40}, {0x08, 0x10, 0x20, 0x80}};
    if (braille_)
      at(x / 2, y / 4) |= bits[x % 2][y % 4];
    else
      at(x, y) = 1;
  }
  std::string row(int y, bool dashed) const {
    std::string out;
    for (int x = 0; x < columns_; ++x) {
      const int cell = cells_[index(x, y)];
      if (cell == 0)
        out += !dashed ? " " : braille_ ? "┄" : "-";
      else
        out += braille_ ? utf8(0x2800 + cell) : "*";
    }
    return out;
  }

 private:
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(columns_) + static_cast<std::size_t>(x);
  }
  int& at(int x, int y) { return cells_[index(x, y)]; }
  static std::string utf8(int code) {  // U+0800 … U+FFFF
    return {static_cast<char>(0xe0 | (code >> 12)), static_cast<char>(0x80 | ((code >> 6) & 63)),
            static_cast<char>(0x80 | (code & 63))};
  }

  int columns_, rows_;
  bool braille_;
  std::vector<int> cells_;
};

constexpr int chart_rows = 7;

std::string verdict_of(const reports::ErrorCurve& curve) {
  if (curve.first_violation)
    return fmt::format("first exceeded at t = {:.6g} s, step {}", curve.first_violation->time,
                       curve.first_violation->step);
  return "never exceeded";
}

}  // namespace

Plot error_plot(std::span<const reports::Trace* const> runs) {
  std::map<std::string, double> worst;
  for (const reports::Trace* run : runs)
    for (const reports::ErrorCurve& curve : run->errors)
      if (curve.allowed > 0) worst[curve.claim] = std::max(worst[curve.claim], peak(curve));
  const auto chosen = std::max_element(worst.begin(), worst.end(),
                                       [](const auto& a, const auto& b) { return a.second < b.second; });
  Plot plot;
  plot.x_scale = Scale::linear;
  plot.x_label = "time [s]";
  if (chosen == worst.end()) return plot;
  for (std::size_t i = 0; i < runs.size(); ++i)
    for (const reports::ErrorCurve& curve : runs[i]->errors) {
      if (curve.claim != chosen->first) continue;
      plot.title = fmt::format("{}: {}", runs[i]->scenario, curve.claim);
      plot.y_label = curve.unit.empty() ? "error" : fmt::format("error [{}]", curve.unit);
      plot.line = curve.allowed;
      Curve& line = plot.curves.emplace_back();
      line.name = fmt::format("{}, {}", runs[i]->engine, results::step_in_words(runs[i]->dt_text));
      line.colour = line.marker = static_cast<int>(i);
      for (std::size_t k = 0; k < curve.time.size(); ++k)
        line.points.emplace_back(curve.time[k], curve.value[k]);
    }
  return plot;
}

std::string error_chart(const reports::ErrorCurve& curve, const ConsoleOptions& options) {
  const auto drawable = [](double value) { return value > 0 && std::isfinite(value); };
  double low = HUGE_VAL, high = -HUGE_VAL;
  const auto take = [&](double value) {
    if (drawable(value)) low = std::min(low, std::log10(value)), high = std::max(high, std::log10(value));
  };
  std::for_each(curve.value.begin(), curve.value.end(), take);
  const bool empty = low > high;
  take(curve.allowed);
  const std::string unit = curve.unit.empty() ? "" : " " + curve.unit;
  std::string out = fmt::format("{}, allowed {:.3g}{}: {}\n", shown(curve.claim, options), curve.allowed,
                                unit, verdict_of(curve));
  if (empty) return out + "  no error to plot: all values are zero or not finite\n";
  low = std::floor(low) + 0.0, high = std::max(low + 1, std::ceil(high)) + 0.0;  // no negative zero

  constexpr int margin = 8;  // of the axis's numbers
  const int columns = std::clamp(options.width - margin - 2, 20, 100);
  Dots dots(columns, chart_rows, options.utf8);
  const double end = std::max(curve.time.back(), 1e-300);
  const auto column = [&](double t) {
    return static_cast<int>(std::lround(std::clamp(t / end, 0.0, 1.0) * (dots.width() - 1)));
  };
  const auto line = [&](double value) {
    return static_cast<int>(std::lround((high - std::log10(value)) / (high - low) * (dots.height() - 1)));
  };
  std::optional<std::pair<int, int>> last;
  for (std::size_t i = 0; i < curve.value.size(); ++i) {
    if (!drawable(curve.value[i])) {
      last.reset();
      continue;
    }
    const int x = column(curve.time[i]), y = line(curve.value[i]);
    // Upright strokes from point to point, so that a steep curve stays one line.
    const int from = last && x - last->first <= 2 ? last->second : y;
    for (int k = std::min(from, y); k <= std::max(from, y); ++k) dots.set(x, k);
    last = {x, y};
  }
  const int allowed_row = drawable(curve.allowed) ? line(curve.allowed) * chart_rows / dots.height() : -1;
  for (int row = 0; row < chart_rows; ++row) {
    const std::string number = row == 0                ? fmt::format("1e{:.0f}", high)
                               : row == chart_rows - 1 ? fmt::format("1e{:.0f}", low)
                               : row == allowed_row    ? "allowed"
                                                       : "";
    std::string text = fmt::format("{:>{}} {}{}", number, margin - 1, options.utf8 ? "│" : "|",
                                   dots.row(row, row == allowed_row));
    text.erase(text.find_last_not_of(' ') + 1);
    out += text + '\n';
  }
  return out + fmt::format("{:>{}} 0 s{:>{}}\n", "", margin - 1, fmt::format("{:.6g} s", end), columns - 2);
}

}  // namespace cylon::reports
