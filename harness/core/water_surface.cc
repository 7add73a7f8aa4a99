#include "harness/core/water_surface.h"

#include <algorithm>
#include <cmath>

namespace cylon::core {

double water_surface(const Water& water, const Vector3& point, double t) {
  if (water.mode != "step") return water.level + water.wave * std::sin(point.x() - water.speed * t);
  const auto cell = [](double x) { return std::clamp(std::trunc((x + 5) / 0.25), 0.0, 40.0); };
  const double i = cell(point.x()), j = cell(point.z());
  return water.level + water.wave / 2 * (std::sin(water.speed * t + i) + std::sin(i * j / 2));
}

}  // namespace cylon::core
