// Masses that change evenly in time.
#pragma once

#include "engine/body.h"

#include <vector>

namespace cylon::engine {

/// m(t) = m_0 + t dm/dt.  What enters or leaves does so at the centre of mass and leaves the inertia alone.
class ChangingMasses {
 public:
  /// Bodies as they are at t = 0.
  explicit ChangingMasses(const std::vector<Body>& bodies) {
    for (std::size_t i = 0; i < bodies.size(); ++i) {
      at_start_.push_back(bodies[i].mass);
      if (bodies[i].mass_rate != 0) changing_.push_back(i);
    }
  }

  bool any() const { return !changing_.empty(); }
  Real at_start(std::size_t body) const { return at_start_[body]; }

  /// The masses at t, and their inverses.
  void set(Time t, std::vector<Body>& bodies) const {
    for (const std::size_t i : changing_) {
      Body& body = bodies[i];
      body.mass = at_start_[i] + static_cast<Real>(t) * body.mass_rate;
      if (!body.locked && !body.pinned) body.inverse_mass = 1 / body.mass;
    }
  }

 private:
  std::vector<Real> at_start_;
  std::vector<std::size_t> changing_;
};

}  // namespace cylon::engine
