// Conserved quantities of a scene, from its parts: a part that is not listed as harmless breaks the law.
#include "harness/core/overloaded.h"
#include "harness/study/yardstick.h"

#include <algorithm>

namespace cylon::study {
namespace {

// Whether a force takes or gives energy; whether it acts between bodies of the scene alone.
struct Part {
  bool conservative = true, internal = true;
};

constexpr Part spoils{false, false};

Part part(const core::Force& force) {
  return std::visit(core::Overloaded{
                        [](const core::UniformGravity& g) {
                          return Part{true, g.acceleration.isZero(0)};
                        },
                        [](const core::Spring& s) {
                          return Part{s.damping == 0, s.to != core::world};
                        },
                        [](const core::Attraction&) {
                          return Part{true, true};
                        },
                        [](const core::Drag&) { return spoils; },
                        [](const core::Thrust&) { return spoils; },
                        [](const core::Drive&) { return spoils; },
                        [](const core::Water&) { return spoils; },
                    },
                    force);
}

}  // namespace

std::vector<core::Quantity> conserved(const core::Scene& scene) {
  Part whole;
  for (const core::Force& force : scene.forces) {
    const Part p = part(force);
    whole.conservative &= p.conservative, whole.internal &= p.internal;
  }
  for (const core::Joint& joint : scene.joints) whole.internal &= joint.to != core::world;
  for (const core::Body& body : scene.bodies) whole.internal &= !body.locked;
  if (scene.frame && !scene.frame->angular_velocity.isZero(0)) whole = {false, false};
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
