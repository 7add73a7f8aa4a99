#include "reference/exact/catalogue.h"

#include "reference/exact/solutions.h"

#include <array>

namespace cylon::exact {

std::span<const Solution> catalogue() {
  static constexpr std::array solutions = {
      Solution{
          "bouncing_sphere", bouncing_sphere,
          "smooth spheres bouncing on one plane that gravity points into, too far apart sideways to meet"},
      Solution{"dzhanibekov", free_asymmetric_top, "the same as free_asymmetric_top"},
      Solution{"free_asymmetric_top", free_asymmetric_top,
               "rigid bodies, free or falling, any inertia and orientation, not exactly on the separatrix"},
      Solution{"free_symmetric_top", free_symmetric_top,
               "rigid bodies, free or falling, with two equal principal moments, any orientation"},
      Solution{
          "heavy_top", heavy_top,
          "bodies with two equal principal moments on ball joints to the world, the centre of mass on the "
          "symmetry axis, uniform gravity in any direction"},
      Solution{"projectile", projectile,
               "bodies in uniform gravity, turning about a principal axis or not at all"},
      Solution{
          "spring_orbit", spring_orbit,
          "bodies each on one undamped spring from the centre to a pin, no gravity, not aimed at the pin"},
      Solution{"spring_zero_length", spring_zero_length,
               "bodies each on undamped springs of no rest length from the centre to pins, gravity or none"},
      Solution{"two_sphere_oblique", two_sphere_oblique,
               "two smooth spheres, free or falling together, at most one collision"},
  };
  return solutions;
}

}  // namespace cylon::exact
