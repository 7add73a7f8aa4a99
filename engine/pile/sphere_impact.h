// Impacts of spheres: found on the straight paths of the bodies within the step, one after another.
#pragma once

#include "engine/pile/spheres.h"
#include "engine/stepper.h"

#include <vector>

namespace cylon::engine::pile {

/// A pair that comes near fast: two spheres, or a sphere and a plane (b = count + plane).
struct Approaching {
  int a, b;
  Material material;
};

class SphereImpacts {
 public:
  explicit SphereImpacts(const Model&);

  /// Newton's restitution and Coulomb's friction at the instant of contact, for all pairs that meet within
  /// `span` of now; velocities are those before the forces of the step.
  ///   u_n' = -e u_n,  |J_t| <= friction J_n;  p += t (v - v'), so that p + v' h is on the broken path.
  /// Repeated until nothing approaches, at most 64 times: one impact can make another (Newton's cradle).
  /// Adds the contacts to `contacts` where it is not null.
  void resolve(const std::vector<Approaching>&, Spheres&, Time now, Time span, std::vector<Impact>&,
               std::vector<Contact>* contacts);

 private:
  bool strike(const Approaching&, Real& since, Spheres&, Time now, Time span, std::vector<Impact>&,
              std::vector<Contact>* contacts) const;

  std::vector<Plane> planes_;
  Real gravity_;  // [m/s^2]
  bool alone_;
  std::vector<Real> since_;  // of each pair, when in the step it last met [s]
};

/// When two spheres meet: the smaller root t >= 0 of |d + v t| = reach; negative when they do not.
Real time_of_contact(const Vector3& d, const Vector3& v, Real reach);

}  // namespace cylon::engine::pile
