// What may be set in ODE and what each path sets, as words and numbers; knows no ODE header.
#pragma once

#include "harness/core/engine.h"
#include "harness/core/scene_kind.h"

#include <map>
#include <optional>
#include <string>

namespace cylon::simulators {

/// Contacts per pair of shapes at most: a box's face on a box's face has eight corners.
inline constexpr int ode_most_contacts = 8;

/// One run's settings of ODE.  Those below are ODE's own; what ODE leaves to its caller is at the least.
struct OdeSettings {
  std::string path = "step";     ///< "step", "quick", "as-shipped" or "as-expert".
  bool quick = false;            ///< dWorldQuickStep (projected SOR) in place of dWorldStep (Dantzig's LCP).
  bool gyro = true;              ///< The implicit gyroscopic torque.
  bool finite_rotation = false;  ///< Turns by |w| dt; else by 2 atan(|w| dt/2).
  double erp = 0.2;              ///< Share of a constraint's error corrected per step, in [0, 1].
  double cfm = 1e-10;            ///< Softness of a constraint, >= 0 [s/kg].
  int iterations = 20;           ///< Sweeps of QuickStep, >= 1.
  double over_relaxation = 1.3;  ///< Of QuickStep's sweeps, in (0, 2).
  int contacts = ode_most_contacts;   ///< Asked for per pair of shapes, from 1.
  bool coulomb = false;               ///< dContactApprox1: friction is a coefficient; else a largest force.
  bool along_slip = false;            ///< dContactFDir1: the first friction direction is that of the slip.
  double bounce_velocity = 0;         ///< Approach speed up to which nothing bounces [m/s].
  std::optional<double> contact_cfm;  ///< dContactSoftCFM: a contact's own softness [s/kg].
  std::optional<double> contact_erp;  ///< dContactSoftERP: a contact's own ERP, in [0, 1].
  std::optional<double> stop_erp;     ///< dParamStopERP: the ERP of stops of joints, in [0, 1].
  double surface_layer = 0;           ///< Depth up to which contacts are left alone [m].
  bool stiff_springs = false;         ///< Springs too stiff for a force are soft joints (implicit).
  bool all_springs = false;           ///< All springs are.

  /// Why an option is as it is, by the option's name, where a path or the run sets it.
  std::map<std::string, std::string> reasons;

  /// Why the path has not what the run asks for on this scene; nothing: it has.
  std::optional<std::string> refused;
};

/// What ODE says of itself.
core::Engine ode_engine(std::string version);

/// What the path "as-expert" looks at in a scene.
struct OdeKind : core::SceneKind {
  bool stacked = false;  ///< Two moving bodies touch each other at the start.
};

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what ode_engine() does not offer, and for
/// options that the path never has, whatever the scene.
OdeSettings ode_settings(const core::Engine&, const core::Setup&, const OdeKind&);

/// The same for the reports.
core::Terms ode_terms(const OdeSettings&);

}  // namespace cylon::simulators
