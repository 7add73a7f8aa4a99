// Conserved quantities of a scene, from its parts: a part that is not listed as harmless breaks the law.
#include "harness/core/force_law.h"
#include "harness/study/yardstick.h"

namespace cylon::study {
namespace {

// Whether energy, and whether both momenta are conserved.
struct Part {
  bool conservative = true, internal = true;
};

}  // namespace

std::vector<core::Quantity> conserved(const core::Scene& scene) {
  Part whole;
  for (const core::Broken& broken : core::broken_by(scene)) {
    whole.conservative &= !broken.energy, whole.internal &= !broken.momentum;
  }
  for (const core::Joint& joint : scene.joints) whole.internal &= joint.to != core::world;
  for (const core::Body& body : scene.bodies) whole.internal &= !body.locked;
  if (core::has_fictitious_forces(scene)) whole = {false, false};
  core::any_touching_pair(scene, [&](const core::Pair& pair) {
    const auto material = core::material_of(scene, pair);
    whole.conservative &= material && material->restitution == 1 && material->friction == 0;
    whole.internal &= pair.plane < 0;
    return !whole.conservative && !whole.internal;
  });
  std::vector<core::Quantity> kept;
  if (whole.conservative) kept.push_back(core::Quantity::energy);
  if (whole.internal)
    kept.insert(kept.end(), {core::Quantity::linear_momentum, core::Quantity::angular_momentum});
  return kept;
}

}  // namespace cylon::study
