#include "engine/geometry/advance.h"

#include <algorithm>
#include <limits>

namespace cylon::engine {
namespace {

Real time_to_close(Real gap, Real speed) {
  if (!(gap > 0)) return 0;
  return speed > 0 ? gap / speed : std::numeric_limits<Real>::infinity();
}

}  // namespace

Real safe_time(const Separation& separation, const Speed& body, const Speed& other) {
  const Real closing = std::max(Real(0), -separation.normal.dot(body.velocity - other.velocity));
  return time_to_close(separation.gap, closing + body.change + other.change + body.spin * body.radius +
                                           other.spin * other.radius);
}

Real safe_time(Real gap, Real speed, Real spin, Real radius, Real other_spin, Real other_radius) {
  return time_to_close(gap, speed + spin * radius + other_spin * other_radius);
}

}  // namespace cylon::engine
