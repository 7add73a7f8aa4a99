#include "engine/ballistic/encounter.h"

namespace cylon::engine::ballistic {

Real contact_accelerated(const Vector3& d, const Vector3& w, const Vector3& a, Real c, Real b, bool touch) {
  const Real quadratic = w.squaredNorm() + d.dot(a), cubic = w.dot(a), quartic = a.squaredNorm() / 4;
  if (!touch) return first_fall<4>({c, 2 * b, quadratic, cubic, quartic});
  if (b < 0) return 0;
  if (b > 0) return first_fall<3>({2 * b, quadratic, cubic, quartic});
  const Real curvature = rounded(quadratic, w.squaredNorm() + size(d) * size(a));
  if (curvature < 0) return 0;  // pressed against each other
  return first_fall<2>({curvature, cubic, quartic});
}

}  // namespace cylon::engine::ballistic
