#include "reports/plot.h"

#include "reports/xml.h"

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
constexpr std::size_t most_marks = 40;  // of a curve that has one at every point

// An axis from the lowest to the highest tick.  Logarithmic: in decades; linear: in steps of 1, 2 or 5 times
// a power of ten.
class Axis {
 public:
  explicit Axis(Scale scale) : scale_(scale) {}

  bool holds(double value) const { return std::isfinite(value) && (scale_ == Scale::linear || value > 0); }
  void take(double value) {
    const double u = scale_ == Scale::linear ? value : std::log10(value);
    low_ = std::min(low_, u), high_ = std::max(high_, u);
  }
  void finish() {
    if (low_ > high_) low_ = scale_ == Scale::linear ? 0 : -1, high_ = low_ + 1;
    if (scale_ == Scale::logarithmic) {
      low_ = std::floor(low_), high_ = std::ceil(high_);
      if (low_ == high_) ++high_;
      step_ = std::max(1.0, std::floor((high_ - low_ + 9) / 10));
      return;
    }
    if (low_ == high_) ++high_;
    const double wanted = (high_ - low_) / 8, power = std::pow(10, std::floor(std::log10(wanted)));
    step_ = power * (wanted <= power ? 1 : wanted <= 2 * power ? 2 : wanted <= 5 * power ? 5 : 10);
    low_ = step_ * std::floor(low_ / step_), high_ = step_ * std::ceil(high_ / step_);
  }
  /// 0 at the lowest tick, 1 at the highest.
  double part(double value) const {
    return ((scale_ == Scale::linear ? value : std::log10(value)) - low_) / (high_ - low_);
  }
  /// Calls with each tick's place and text.
  template <class Draw>
  void ticks(const Draw& draw) const {
    for (int i = 0; low_ + i * step_ <= high_ + 1e-9 * step_; ++i) {
      const double u = low_ + i * step_, shown = std::abs(u) < 1e-9 * step_ ? 0 : u;
      draw((u - low_) / (high_ - low_),
           scale_ == Scale::linear ? fmt::format("{:.6g}", shown) : fmt::format("1e{:.0f}", shown));
    }
  }

 private:
  Scale scale_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_, step_ = 1;
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
  Axis x(plot.x_scale), y(Scale::logarithmic);
  const auto drawable = [&](const std::pair<double, double>& p) {
    return x.holds(p.first) && y.holds(p.second);
  };
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
  x.ticks([&](double part, const std::string& text) {
    const double at = left + width * part;
    fmt::format_to(to, "<path class=\"g\" d=\"M{:.1f} {}V{:.1f}\"/>", at, top, top + height);
    fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", at,
                   top + height + 16, text);
  });
  y.ticks([&](double part, const std::string& text) {
    const double at = top + height * (1 - part);
    fmt::format_to(to, "<path class=\"g\" d=\"M{} {:.1f}H{}\"/>", left, at, left + width);
    fmt::format_to(to, "<text x=\"{}\" y=\"{:.1f}\" text-anchor=\"end\">{}</text>\n", left - 6, at + 4, text);
  });
  fmt::format_to(to, "<text x=\"{:.1f}\" y=\"{:.1f}\" text-anchor=\"middle\">{}</text>\n", left + width / 2,
                 top + height + 38, xml(plot.x_label));
  fmt::format_to(to,
                 "<text transform=\"translate(16 {:.1f}) rotate(-90)\" text-anchor=\"middle\">{}</text>\n",
                 top + height / 2, xml(plot.y_label));

  for (const auto& front : plot.fronts) {
    std::string stairs;
    double last = 0;
    for (const auto& p : front) {
      if (!drawable(p)) continue;
      stairs += stairs.empty() ? fmt::format("M{:.1f} {:.1f}", at_x(p.first), at_y(p.second))
                               : fmt::format("L{:.1f} {:.1f}V{:.1f}", at_x(p.first), last, at_y(p.second));
      last = at_y(p.second);
    }
    if (!stairs.empty()) fmt::format_to(to, "<path class=\"f\" d=\"{}\"/>\n", stairs);
  }
  if (plot.line > 0)
    fmt::format_to(to, "<path class=\"t\" d=\"M{} {:.1f}H{}\"/>\n", left, at_y(plot.line), left + width);

  for (std::size_t i = 0; i < plot.curves.size(); ++i) {
    const Curve& curve = plot.curves[i];
    std::string line, marks;
    // Of a dense curve only some points have a mark, each curve's elsewhere.
    const std::size_t every = curve.points.size() > most_marks ? curve.points.size() / 8 : 1;
    for (std::size_t k = 0; k < curve.points.size(); ++k) {
      const auto& p = curve.points[k];
      if (!drawable(p)) continue;
      fmt::format_to(std::back_inserter(line), "{}{:.1f} {:.1f}", line.empty() ? "M" : "L", at_x(p.first),
                     at_y(p.second));
      if ((k + every * i / 5) % every == 0)
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
