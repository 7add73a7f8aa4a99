// What errors of bodies that springs hold in balance are measured by.
#pragma once

#include "engine/model.h"

#include <algorithm>
#include <cmath>

namespace cylon::engine {

/// Springs pull by forces of which the rounding, eps of their length, shakes a body that they hold in balance.  No step makes
/// that smooth: an error that is asked to be less would have no end.  With l the longest spring at the start and w the
/// fastest, w^2 = k/m, errors are asked to be no less than 4 eps l and 4 eps w l, whatever little moves.
class Balanced {
 public:
  explicit Balanced(const Model& model) {
    for (const Spring& spring : model.forces.springs) {
      const Real length =
          (end(model, spring.body, spring.anchor) - end(model, spring.to, spring.to_anchor)).norm();
      Real inverse_mass = model.bodies[index(spring.body)].inverse_mass;
      if (spring.to != fixed_world)
        inverse_mass = std::max(inverse_mass, model.bodies[index(spring.to)].inverse_mass);
      length_ = std::max({length_, length, spring.rest_length});
      rate_ = std::max(rate_, std::sqrt(spring.stiffness * inverse_mass));
    }
  }

  /// By what the errors of places [m] and of speeds [m/s] of such a size are measured, where they are asked to be within
  /// `tolerance` of that; 0 is nothing that moves, and stays.
  Real length(Real size, Real tolerance) const { return at_least(size, length_, tolerance); }
  Real speed(Real size, Real tolerance) const { return at_least(size, rate_ * length_, tolerance); }

 private:
  static Vector3 end(const Model& model, int body, const Vector3& anchor) {
    if (body == fixed_world) return anchor;
    const Motion& motion = model.motions[index(body)];
    return motion.position + motion.orientation * anchor;
  }
  static Real at_least(Real size, Real whole, Real tolerance) {
    return size > 0 ? std::max(size, std::min(whole, 4 * epsilon / tolerance * whole)) : size;
  }

  Real length_ = 0, rate_ = 0;  // [m, 1/s]
};

}  // namespace cylon::engine
