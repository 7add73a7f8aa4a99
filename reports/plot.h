// Curves as a static SVG, errors on a logarithmic axis: colours and markers that any eye can tell apart,
// light or dark as the reader's screen is, no script.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace cylon::reports {

struct Curve {
  std::string name;
  int colour = 0;  ///< Of a palette of eight; curves of one engine share one.
  int marker = 0;  ///< Of seven shapes.
  std::vector<std::pair<double, double>>
      points;  ///< In order; those that are not finite, or on a logarithmic axis not > 0, are left out.
};

enum class Scale { logarithmic, linear };

struct Plot {
  std::string title, x_label, y_label;
  std::vector<Curve> curves;
  std::vector<std::vector<std::pair<double, double>>> fronts;  ///< Drawn as broad stairs behind the curves.
  double line = 0;                                             ///< A horizontal line at this y; 0: none.
  Scale x_scale = Scale::logarithmic;                          ///< The other axis is logarithmic.
};

/// A whole SVG document.  The same plot gives the same bytes.
std::string to_svg(const Plot&);

}  // namespace cylon::reports
