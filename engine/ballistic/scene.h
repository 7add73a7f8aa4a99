// What the ballistic stepper asks of a model.
#pragma once

#include "engine/model.h"

namespace cylon::engine::ballistic {

/// How many principal moments are equal.
enum class Symmetry { none, axis, sphere };
Symmetry symmetry(const Body&);

/// The surface of a body; no_surface where it never touches.
inline int surface(const Model& model, std::size_t body) {
  const bool touches = body < model.surfaces.size() && body < model.shapes.size() &&
                       !std::holds_alternative<std::monostate>(model.shapes[body]);
  return touches ? model.surfaces[body] : no_surface;
}

/// Whether any partner of the body has friction with it.
bool meets_friction(const Model&, std::size_t body);

}  // namespace cylon::engine::ballistic
