// Impacts of spheres: found on the paths of free fall within the step, one after another.
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

/// Of SphereImpacts::resolve().
inline constexpr int most_impact_sweeps = 64;

class SphereImpacts {
 public:
  /// `parts` into which a step is divided for the contacts.
  SphereImpacts(const Model&, int parts);

  /// Newton's restitution and Coulomb's friction at the instant of contact, for all pairs that meet within
  /// `span` of now; velocities are those before the forces of the step, and u those of the instant, v + t g.
  ///   u_n' = -e u_n,  |J_t| <= friction J_n;  p += t (v - v'), so that p + v' h + g h^2/2 is on the broken path,
  /// and orientations turn by t w and by -t w'.
  /// Repeated until nothing approaches, at most most_impact_sweeps times: one impact can make another (Newton's cradle), or
  /// unmake it (a ball in a corner), so each body meets others in the order of time.
  /// Adds the contacts to `contacts` where it is not null.  Says whether nothing approached at the end.
  bool resolve(const std::vector<Approaching>&, Spheres&, Time now, Time span, std::vector<Impact>&,
               std::vector<Contact>* contacts);

 private:
  struct Meeting {
    Real time = -1;  // since now [s]; negative: none
    Vector3 normal = Vector3::Zero(), velocity = Vector3::Zero();
    Real approach = 0, lever = 1;
  };

  Meeting meeting(const Approaching&, const Spheres&, Real span) const;
  void strike(const Approaching&, const Meeting&, Spheres&, Time now, std::vector<Impact>&,
              std::vector<Contact>* contacts);

  std::vector<Plane> planes_;
  Real gravity_;  // [m/s^2]
  Real parts_;
  bool alone_;
  std::vector<Real> since_;  // of each body, when in the step its path began [s]
  std::vector<Real> next_;   // of each body, when it meets another
  std::vector<Real> time_;   // of each pair, when it meets; negative: not
};

/// When two spheres meet: the smaller root t >= 0 of |d + v t| = reach; negative when they do not.
Real time_of_contact(const Vector3& d, const Vector3& v, Real reach);

}  // namespace cylon::engine::pile
