#include "harness/core/size.h"

#include "harness/core/solid.h"

#include <cmath>

namespace cylon::core {

double size(const Body& body) {
  const double extent = bounding_radius(body.shape);
  return extent > 0 ? extent : std::sqrt(principal_axes(body.inertia).moments.maxCoeff() / body.mass);
}

}  // namespace cylon::core
