// How far forces at contacts are from Coulomb's and Signorini's laws.
#include "engine/contact/coulomb.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

Real violation(const CoulombProblem& p, const VectorX& f) {
  const VectorX u = p.response * f + p.offset;
  Real worst = 0;
  for (std::size_t i = 0; i < p.friction.size(); ++i) {
    const Eigen::Index at = 3 * static_cast<Eigen::Index>(i);
    const Real mu = p.friction[i], stiff = p.response.diagonal().segment<3>(at).maxCoeff();
    if (!(stiff > 0)) continue;
    const Vector3 now = f.segment<3>(at), rate = u.segment<3>(at);
    const bool given = i < p.hold.size() && p.hold[i].given;
    Vector3 wanted = now - rate / stiff;
    if (const Real bound = p.bound_of(i); bound > 0) {  // onto |f_t| <= bound
      const Vector2 across = given ? Vector2(-bound * p.hold[i].slip) : Vector2(wanted.tail<2>());
      wanted << 0, across * std::min(Real(1), bound / std::max(across.norm(), bound));
    } else if (given || mu == 0) {
      const Real normal = std::max(Real(0), wanted[0]);
      const Vector2 across = given ? Vector2(-mu * normal * p.hold[i].slip) : Vector2(Vector2::Zero());
      wanted << normal, across;
    } else {
      // Onto the cone:  (f_n + mu |f_t|)/(1 + mu^2) times (1, mu) on its edge, or its tip.
      wanted[0] -= mu * rate.tail<2>().norm() / stiff;
      const Real size = wanted.tail<2>().norm();
      if (size > mu * wanted[0]) {
        const Real along = std::max(Real(0), (wanted[0] + mu * size) / (1 + mu * mu));
        wanted[0] = along;
        wanted.tail<2>() *= mu * along / size;
      }
    }
    const Real off = (now - wanted).norm() * stiff;
    if (!std::isfinite(off)) return std::numeric_limits<Real>::infinity();
    worst = std::max(worst, off);
  }
  return worst;
}

}  // namespace cylon::engine
