#include "reports/plot.h"

#include "reports/text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>

namespace cylon::reports {
namespace {

// Okabe and Ito's palette, which readers with any colour vision tell apart; its black is the text's colour.
constexpr const char* palette[] = {"#0072b2", "#d55e00", "#009e73", "#cc79a7",
                                   "#e69f00", "#56b4e9", "#888888", "currentColor"};

constexpr double left = 70, top = 40, width = 560, row = 15, legend_width = 250;

std::string xml(std::string_view text) {
  std::string out;
  for (const char c : escaped(text, is_printable)) switch (c) {
      case '<':
        out += "&lt;";
        break;
      case '>':
        out += "&gt;";
        break;
      case '&':
        out += "&amp;";
        break;
      case '"':
        out += "&quot;";
        break;
      default:
        out += c;
    }
  return out;
}

bool drawable(const std::pair<double, double>& p) {
  return p.first > 0 && p.second > 0 && std::isfinite(p.first) && std::isfinite(p.second);
}

// Decades low … high of a logarithmic axis.
struct Axis {
  int low = std::numeric_limits<int>::max(), high = std::numeric_limits<int>::min();
  void take(double value) {
    low = std::min(low, static_cast<int>(std::floor(std::log10(value))));
    high = std::max(high, static_cast<int>(std::ceil(std::log10(value))));
  }
  void finish() {
    if (low > high) low = -1, high = 0;
    if (low == high) ++high;
  }
  double part(double value) const { return (std::log10(value) - low) / (high - low); }
  int stride() const { return std::max(1, (high - low + 9) / 10); }
};

// Seven shapes of about equal area around (x, y).
std::string marker(int shape, double x, double y, int colour) {
  constexpr double r = 3.5;
  const std::string paint = fmt::format("class=\"m\" style=\"fill:{0};stroke:{0}\"", palette[colour % 8]);
  const auto path = [&](const char* d) {
    return fmt::format("<path transform=\"translate({:.1f} {:.1f})\" d=\"{}\" {}/>", x, y, d, paint);
  };
  switch (shape % 7) {
    case 0:
      return fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>", x, y, r, paint);
    case 1:
      return path("M-3-3H3V3H-3Z");
    case 2:
      return path("M0-4.5L4 3H-4Z");
    case 3:
      return path("M0 4.5L4-3H-4Z");
    case 4:
      return path("M0-4.5L4.5 0L0 4.5L-4.5 0Z");
    case 5:
      return path("M-4 0H4M0-4V4");
    default:
      return path("M-3-3L3 3M-3 3L3-3");
  }
}

}  // namespace

std::string to_svg(const Plot& plot) {
  Axis x, y;
  const auto take = [&](const std::pair<double, double>& p) {
    if (drawable(p)) x.take(p.first), y.take(p.second);
  };
  for (const Curve& curve : plot.curves) std::for_each(curve.points.begin(), curve.points.end(), take);
  if (plot.line > 0) y.take(plot.line);
  x.finish(), y.finish();
  const double height = std::max(380.0, row * static_cast<double>(plot.curves.size()));
  const auto at_x = [&](double v) { return left + width * x.part(v); };
  const auto at_y = [&](double v) { return top + height * (1 - y.part(v)); };

  std::string out;
  const auto to = std::back_inserter(out);
  fmt::format_to(to,
                 "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {:.0f} {:.0f}\" "
                 "font-family=\"sans-serif\" font-size=\"12\">\n",
                 left + width + 20 + legend_width, top + height + 50);
  fmt::format_to(to, "<title>{}</title>\n", xml(plot.title));
  out +=
      "<style>svg{color:#222;background:#fff}text{fill:currentColor}.g{stroke:#8884;stroke-width:1}"
      ".c{fill:none;stroke-width:1.5}.m{stroke-width:1.2}"
      ".f{fill:none;stroke:currentColor;stroke-opacity:.25;stroke-width:7;stroke-linejoin:round}"
      ".t{stroke:currentColor;stroke-dasharray:6 4}"
      "@media(prefers-color-scheme:dark){svg{color:#ddd;background:#181818}}</style>\n";
  fmt::format_to(to, "<text x=\"{}\" y=\"22\" font-size=\"15\">{}</text>\n", left, xml(plot.title));
  for (int d = x.low; d <= x.high; d += x.stride()) {
    const double at = at_x(std::pow(10, d));
    fmt::format_to(to, "<path class=\"g\" d=\"M{:.1f} {}V{:.1f}\"/>", at, top, top + height);
    fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">1e{}</text>\n", at,
                   top + height + 16, d);
  }
  for (int d = y.low; d <= y.high; d += y.stride()) {
    const double at = at_y(std::pow(10, d));
    fmt::format_to(to, "<path class=\"g\" d=\"M{} {:.1f}H{}\"/>", left, at, left + width);
    fmt::format_to(to, "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">1e{}</text>\n", left - 6, at + 4, d);
  }
  fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left + width / 2,
                 top + height + 38, xml(plot.x_label));
  fmt::format_to(to,
                 "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                 top + height / 2, xml(plot.y_label));

  std::string stairs;
  double last = 0;
  for (const auto& p : plot.front) {
    if (!drawable(p)) continue;
    stairs += stairs.empty() ? fmt::format("M{:.1f} {:.1f}", at_x(p.first), at_y(p.second))
                             : fmt::format("L{:.1f} {:.1f}V{:.1f}", at_x(p.first), last, at_y(p.second));
    last = at_y(p.second);
  }
  if (!stairs.empty()) fmt::format_to(to, "<path class=\"f\" d=\"{}\"/>\n", stairs);
  if (plot.line > 0)
    fmt::format_to(to, "<path class=\"t\" d=\"M{} {:.1f}H{}\"/>\n", left, at_y(plot.line), left + width);

  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    std::string line, marks;
    for (const auto& p : curve.points) {
      if (!drawable(p)) continue;
      fmt::format_to(std::back_inserter(line), "{}{:.1f} {:.1f}", line.empty() ? "M" : "L", at_x(p.first),
                     at_y(p.second));
      marks += marker(curve.marker, at_x(p.first), at_y(p.second), curve.colour);
    }
    const double at = top + row * (static_cast<double>(i) + 0.5), side = left + width + 20;
    fmt::format_to(to, "<g><title>{}</title>", xml(curve.name));
    if (!line.empty())
      fmt::format_to(to, "<path class=\"c\" style=\"stroke:{}\" d=\"{}\"/>", palette[curve.colour % 8], line);
    fmt::format_to(to, "{}{}<text x=\"{}\" y=\"{:.1f}\">{}</text></g>\n", marks,
                   marker(curve.marker, side, at, curve.colour), side + 12, at + 4, xml(curve.name));
  }
  return out + "</svg>\n";
}

}  // namespace cylon::reports
