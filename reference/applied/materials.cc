#include "reference/applied/materials.h"

#include <fmt/format.h>

namespace cylon::applied {

std::string no_material(const core::Scene& scene, const core::Pair& pair) {
  const std::string& other = pair.plane >= 0 ? scene.planes[static_cast<std::size_t>(pair.plane)].name
                                             : scene.bodies[static_cast<std::size_t>(pair.other)].name;
  return fmt::format("'{}' may touch '{}', but the scene has no material for them.",
                     scene.bodies[static_cast<std::size_t>(pair.body)].name, other);
}

std::optional<std::string> without_material(const core::Scene& scene) {
  const auto pair = core::pair_without_material(scene);
  return pair ? std::optional(no_material(scene, *pair)) : std::nullopt;
}

}  // namespace cylon::applied
