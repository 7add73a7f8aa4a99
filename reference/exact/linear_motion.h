// The linear equation of motion of one body, for the solutions that consist of it:
//
//     m p'' = -gamma p' - sum k_i (p - pin_i) + m g + sum F_j cos(Omega_j t)
//
// With y = p - sum k_i pin_i/k and the roots r1, r2 of r^2 + (gamma/m) r + k/m = 0, [..] the divided
// differences of exp(x t):
//
//     S = [r1, r2],  C = S' + (gamma/m) S,  y = y0 C + v0 S + g [r1, r2, 0] + Re sum F_j/m [r1, r2, i
//     Omega_j]
//
// which passes through critical damping, resonance and the absence of any of the forces without a seam.
#pragma once

#include "harness/core/truth.h"
#include "reference/exact/exponential.h"
#include "reference/exact/steady_spin.h"
#include "reference/exact/wide.h"

#include <string>
#include <string_view>
#include <vector>

namespace cylon::exact {

class LinearMotion {
 public:
  LinearMotion(const core::Scene&, std::size_t body);
  WideState at(Wide t) const;

 private:
  struct Push {
    WideVector acceleration;
    Wide frequency;
  };
  SteadySpin spin_;
  WideVector centre_, offset_, velocity_;
  Wide friction_ = 0, stiffness_ = 0;  // gamma/m, k/m
  WideComplex slow_, fast_;            // r1, r2
  std::vector<Push> pushes_;
};

/// Truth of a scene whose bodies all move so, after a solution's own checks of bodies and forces; checks
/// joints, contacts and spins.
core::Truth linear_motions(std::string_view solution, const core::Scene&, double horizon, std::string source);

}  // namespace cylon::exact
