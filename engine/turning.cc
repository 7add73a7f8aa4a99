#include "engine/turning.h"

#include <algorithm>

namespace cylon::engine {

namespace {

// A touch without friction goes through the centre of a sphere.
bool a_touch_turns(const Model& model, std::size_t body) {
  const int surface = model.surfaces.empty() ? no_surface : model.surfaces[body];
  if (surface == no_surface) return false;
  if (!std::holds_alternative<Sphere>(model.shapes[body]) || !model.bodies[body].centre.isZero(0))
    return true;
  for (int other = 0; other < model.surface_count; ++other) {
    if (model.material(surface, other).friction > 0) return true;
  }
  return false;
}

}  // namespace

std::vector<char> bodies_that_turn(const Model& model) {
  std::vector<char> turns(model.bodies.size());
  for (std::size_t i = 0; i < turns.size(); ++i) {
    turns[i] = model.bodies[i].pinned || model.bodies[i].one_axis || a_touch_turns(model, i) ||
               model.frame.has_value() || !model.motions[i].angular_momentum.isZero(0);
  }
  each_force(model.forces, [&](const auto& force) { force.mark_turned(turns); });
  const auto held_at = [&](int body, const Vector3& anchor) {
    if (body != fixed_world && !anchor.isZero(0)) turns[static_cast<std::size_t>(body)] = 1;
  };
  for (const Joint& j : model.joints) {
    const bool twists = j.type.twists();
    held_at(j.body, twists ? Vector3(Vector3::Ones()) : j.anchor);
    held_at(j.to, twists ? Vector3(Vector3::Ones()) : j.to_anchor);
  }
  for (std::size_t i = 0; i < turns.size(); ++i) {
    const Body& body = model.bodies[i];
    if (body.locked || (body.guide && !body.one_axis)) turns[i] = 0;
  }
  return turns;
}

}  // namespace cylon::engine
