#include "harness/core/scene_kind.h"

#include <algorithm>
#include <limits>
#include <variant>

namespace cylon::core {

SceneKind scene_kind(const Scene& scene) {
  SceneKind kind;
  const bool may_bounce =
      std::ranges::any_of(scene.materials, [](const Material& m) { return m.restitution > 0; });
  const auto moves = [&](int body) {
    return body != world && !scene.bodies[static_cast<std::size_t>(body)].locked;
  };
  any_touching_pair(scene, [&](const Pair& pair) {
    kind.touches = true;
    kind.piles |= moves(pair.body) && moves(pair.other);
    if (may_bounce && !kind.bounces) {
      const std::optional<Material> material = material_of(scene, pair);
      kind.bounces = material && material->restitution > 0;
    }
    return kind.piles && kind.bounces == may_bounce;  // no other pair tells more
  });
  kind.applied = std::ranges::any_of(
      scene.forces, [](const Force& force) { return !std::holds_alternative<UniformGravity>(force); });
  kind.applied |= has_fictitious_forces(scene);
  double lightest = std::numeric_limits<double>::infinity(), heaviest = 0;
  for (const Body& body : scene.bodies)
    if (!body.locked) lightest = std::min(lightest, body.mass), heaviest = std::max(heaviest, body.mass);
  if (heaviest > 0) kind.mass_ratio = heaviest / lightest;
  return kind;
}

}  // namespace cylon::core
