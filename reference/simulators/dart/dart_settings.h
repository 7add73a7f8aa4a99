// What each path of DART sets, and its options; knows no DART header.
#pragma once

#include "harness/core/engine.h"
#include "reference/applied/settings.h"
#include "reference/simulators/dart/border/dart_world.h"

#include <string>

namespace cylon::simulators {

/// What the paths look at in a scene.
struct DartKind {
  bool touches = false;  ///< Some pair may touch.
  bool loops = false;    ///< Some joint closes a loop.
};

const applied::Options& dart_options();

/// What DART says of itself.
core::Engine dart_engine(std::string version);

/// The settings that a setup asks for, on a scene of a kind.
/// Throws std::invalid_argument, naming the nearest valid one, for what dart_engine() does not offer.
applied::Settings dart_settings(const core::Engine&, const core::Setup&, const DartKind&);

/// The same for the border, of the step and the gravity of a run, and for the reports.
dart_border::Settings dart_border_settings(const applied::Settings&, double dt, const core::Vector3& gravity);
core::Terms dart_terms(const applied::Settings&);

}  // namespace cylon::simulators
