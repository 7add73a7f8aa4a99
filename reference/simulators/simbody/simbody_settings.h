// What each path of Simbody sets, its integrators and options; knows no Simbody header.
#pragma once

#include "harness/core/engine.h"
#include "reference/applied/settings.h"

#include <string>

namespace cylon::simulators {

/// What the paths and the terms of a run look at in a scene.
struct SimbodyKind {
  bool loops = false;    ///< Some joint is a constraint and no part of the tree.
  bool changes = false;  ///< The mass of some body changes.
};

/// The integrators of Simbody, each at a fixed step and, where it has one, with its own error control.
enum class SimbodyMethod { semi_explicit_euler, semi_explicit_euler_2, verlet, rk3, merson, feldberg };

struct SimbodyIntegrator {
  const char* name;
  SimbodyMethod method;
  bool adaptive;  ///< Its own error control; else every step is dt.
  int order;
  const char* remark;
};

/// Throws std::logic_error for a name that is none.
const SimbodyIntegrator& simbody_integrator(const std::string& name);

const applied::Options& simbody_options();

/// Every setting as Simbody has it by itself, and the integrator of its examples.
applied::Settings simbody_as_shipped();

/// What Simbody says of itself.
core::Engine simbody_engine(std::string version);

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what simbody_engine() does not offer.
applied::Settings simbody_settings(const core::Engine&, const core::Setup&, const SimbodyKind&);

/// The same for the reports.
core::Terms simbody_terms(const applied::Settings&, const SimbodyKind&);

}  // namespace cylon::simulators
