// How chance shares the kinetic energy of an elastic gas among its bodies and directions.
//
// N smooth elastic spheres in a closed box keep their energy and nothing else.  Once the motion has mixed, the n = 3N
// numbers sqrt(m) v are spread evenly over the sphere sum m v^2 = 2T (the microcanonical ensemble; gravity takes part in T
// alone).  The share of k of these numbers in T then has the density
//
//   Beta(k/2, (n - k)/2),   mean k/n                                                  (equipartition)
//
// whatever the masses.  The shares of all N bodies have the law F of one, Beta(3/2, 3(N - 1)/2), and the largest distance
// D of their distribution from F obeys  P(D >= d) <= 2 exp(-2 N d^2)  (Massart, Ann. Probab. 18 (1990) 1269; there for
// independent ones: shares, which add to one, scatter less about F).
#pragma once

#include "harness/core/observable.h"

#include <optional>
#include <string>

namespace cylon::core {

/// Why chance says nothing of a scene's energy, or nothing where it does.
std::optional<std::string> energy_share_undefined(const Observable&, const Scene&);

/// The part of the kinetic energy of translation that the observable's body, or all bodies, have along its component.
/// With neither: the distance D of the distribution of the bodies' shares from F.  In [0, 1]; without energy 0,
/// or D = 1; NaN of a state with a NaN.
double energy_share(const Observable&, const Scene&, const State&);

/// k/n, or 0 for D.
double expected_share(const Observable&, const Scene&);

/// The probability that chance takes a share, or D, that far from what is expected, or farther; of D the bound above.
double chance_of_share(const Observable&, const Scene&, double distance);

/// The distance whose chance is `level`, in (0, 1).
double allowed_share(const Observable&, const Scene&, double level);

}  // namespace cylon::core
