// What each path of Siconos sets, its integrators and options; knows no Siconos header.
#pragma once

#include "harness/core/engine.h"
#include "reference/applied/settings.h"
#include "reference/simulators/siconos/border/siconos_world.h"

#include <string>

namespace cylon::simulators {

/// What the paths and the terms of a run look at in a scene.
struct SiconosKind {
  bool touches = false;  ///< Some pair may touch.
  bool forced = false;   ///< Something but gravity acts, constant during a step.
  bool rough = false;    ///< Some pair that may touch has friction.
};

const applied::Options& siconos_options();

/// What Siconos says of itself.
core::Engine siconos_engine(std::string version);

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what siconos_engine() does not offer.
applied::Settings siconos_settings(const core::Engine&, const core::Setup&, const SiconosKind&);

/// The same for the border and for the reports.
siconos_border::Settings siconos_border_settings(const applied::Settings&, double dt);
core::Terms siconos_terms(const applied::Settings&, const SiconosKind&);

}  // namespace cylon::simulators
