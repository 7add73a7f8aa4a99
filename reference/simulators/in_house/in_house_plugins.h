// Plug-ins with forces of the user's own: shared libraries behind cylon/force.h.
#pragma once

#include "engine/user_force.h"
#include "harness/core/scene.h"

#include <map>
#include <memory>
#include <string>
#include <variant>

namespace cylon::simulators {

/// Why a force of a plug-in cannot act.
using NoLaw = std::string;

/// The libraries that may take part, and no other.
class Plugins {
 public:
  /// The file is loaded when a scene first names it, and stays loaded.  Throws std::invalid_argument where the name is taken.
  void admit(const std::string& name, const std::string& file);

  /// The law of a force in a scene, with the parameters that it states.
  std::variant<std::shared_ptr<const engine::UserLaw>, NoLaw> law(const core::Scene&,
                                                                  const core::PluginForce&) const;

 private:
  std::map<std::string, std::string> files_;  // by name
};

}  // namespace cylon::simulators
