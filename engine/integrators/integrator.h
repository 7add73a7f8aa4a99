// The integrators that carry a System through time, as rows of one table: adding one is one row in table.h
// and, if it is new, its coefficients.  Knows nothing of bodies.
#pragma once

#include "engine/integrators/coefficient.h"

#include <cstddef>
#include <span>
#include <string_view>

namespace cylon::engine {

/// The two parts of a System that are each solved exactly.
enum class Part : unsigned char { kick, drift };

/// A step as kicks and drifts in turn, each over its coefficient times h.
struct Composition {
  Part first = Part::kick;
  std::span<const Coefficient> coefficients;  ///< Those of each part sum to 1.
  /// The same step as a composition of velocity Verlet steps (or stormer_verlet, symplectic_euler), each over
  /// its weight times h; empty where it is none.  An integrator can only keep constraints when it has them.
  std::span<const Coefficient> weights;
};

/// Explicit Runge-Kutta.  k_i = f(t + c_i h, y + h sum_j<i a_ij k_j),  y' = y + h sum b_i k_i.
struct Tableau {
  std::span<const Coefficient> nodes;    ///< c_i
  std::span<const Coefficient> matrix;   ///< a_ij, strictly lower triangle, row by row.
  std::span<const Coefficient> weights;  ///< b_i
};

enum class Kind : unsigned char {
  splitting,    ///< Exact parts in turn; Advance.
  runge_kutta,  ///< Fixed step; Advance.
  adaptive      ///< Error-controlled; Dop853.
};

struct Integrator {
  std::string_view name;
  int order = 1;        ///< Of the global error in smooth motion.
  int drag_order = 1;   ///< The same where forces depend on velocities.
  int evaluations = 1;  ///< Of the forces, in a step; a run of steps saves one a step where kicks meet.
  Kind kind = Kind::splitting;
  bool symplectic = false;   ///< Energy error bounded, without damping and impacts.
  bool reversible = false;   ///< step(-h) after step(h) is the identity, to rounding.
  bool constraints = false;  ///< Right with joints that are kept as constraints (RATTLE), at its full order.
  std::string_view conserves;  ///< In words, and when it does not.
  Composition splitting = {};
  Tableau tableau = {};
};

/// All integrators.
std::span<const Integrator> integrators();

/// The integrator of that name, or null.
const Integrator* find_integrator(std::string_view name);

}  // namespace cylon::engine
