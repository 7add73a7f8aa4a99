// What may be set in ODE and what each path sets, as words and numbers; knows no ODE header.
#pragma once

#include "harness/core/engine.h"

#include <string>

namespace cylon::simulators {

/// Contacts per pair of shapes at most: a box's face on a box's face has eight corners.
inline constexpr int ode_most_contacts = 8;

/// Over-relaxation of QuickStep's sweeps; ODE's own default.
inline constexpr double ode_over_relaxation = 1.3;

/// One run's settings of ODE, every default written out.
struct OdeSettings {
  bool quick = false;           ///< dWorldQuickStep (projected SOR) in place of dWorldStep (Dantzig's LCP).
  bool gyro = true;             ///< The implicit gyroscopic torque.
  bool finite_rotation = true;  ///< Turns by |w| dt; else by 2 atan(|w| dt/2).
  double erp = 0.2;             ///< Share of a constraint's error corrected per step, in [0, 1].
  double cfm = 1e-10;           ///< Softness of a constraint, >= 0 [s/kg].
  int iterations = 20;          ///< Sweeps of QuickStep, >= 1.
  int contacts = ode_most_contacts;  ///< Asked for per pair of shapes, from 1.
};

/// What ODE says of itself.
core::Engine ode_engine(std::string version);

/// The settings that a setup asks for.
/// Throws std::invalid_argument, naming the nearest valid one, for what ode_engine() does not offer.
OdeSettings ode_settings(const core::Engine&, const core::Setup&);

/// The same for the reports.
core::Terms ode_terms(const OdeSettings&);

}  // namespace cylon::simulators
