#include "harness/core/contact_balance.h"

#include "harness/core/worst.h"

#include <algorithm>
#include <stdexcept>
#include <variant>

namespace cylon::core {
namespace {

// Whether the observable asks for the body's balance; a locked body moves by no law.
bool asked(const Observable& q, const Scene& scene, std::size_t i) {
  return !scene.bodies[i].locked && (!q.body || static_cast<std::size_t>(*q.body) == i);
}

Vector3 gravity(const Scene& scene) {
  Vector3 g = Vector3::Zero();
  for (const Force& force : scene.forces)
    if (const auto* uniform = std::get_if<UniformGravity>(&force)) g += uniform->acceleration;
  return g;
}

Vector3 spin(const Body& body, const BodyState& s) {
  return world_inertia(body, s.orientation) * s.angular_velocity;
}

bool rough(const Scene& scene, const Pair& pair) {
  const auto material = material_of(scene, pair);
  return !material || material->friction > 0;
}

}  // namespace

std::optional<std::string> balance_undefined(const Observable& q, const Scene& scene) {
  if (scene.frame) return "the scene's frame moves";
  for (const Force& force : scene.forces)
    if (!std::holds_alternative<UniformGravity>(force))
      return "a force other than gravity and contacts acts in the scene";
  const auto holds = [&](int body) {
    return body != world && asked(q, scene, static_cast<std::size_t>(body));
  };
  for (const Joint& joint : scene.joints)
    if (holds(joint.body) || holds(joint.to))
      return "a joint holds the body, and engines tell no forces of joints";
  if (q.body && scene.bodies[static_cast<std::size_t>(*q.body)].locked) return "the body is locked";
  if (!any_touching_pair(scene, [&](const Pair& pair) { return holds(pair.body) || holds(pair.other); }))
    return "nothing may touch the body";
  return std::nullopt;
}

std::optional<std::string> untold(const Observable& q, const Scene& scene, const Recording& recording) {
  if (!recording.contacts) return "the engine tells no contact forces";
  if (recording.contacts->empty()) return "the engine tells no contact force of the last step";
  const auto concerns = [&](int body) {
    return body != world && asked(q, scene, static_cast<std::size_t>(body));
  };
  for (const Contact& c : *recording.contacts) {
    if (!concerns(c.pair.body) && !concerns(c.pair.other)) continue;
    if (!c.impulse) return "the engine tells where surfaces press in the last step, but not how hard";
    if (!c.friction && rough(scene, c.pair)) return "the engine tells no friction of the last step";
  }
  return std::nullopt;
}

double contact_imbalance(const Observable& q, const Scene& scene, const Recording& recording) {
  const std::size_t n = recording.steps.size();
  if (n < 2 || recording.steps[n - 1] - recording.steps[n - 2] != 1)
    throw std::logic_error("a balance needs the states of the last two steps");
  const State &before = recording.states[n - 2], &now = recording.states[n - 1];
  const bool turns = q.quantity == Quantity::angular_momentum_balance;
  const Vector3 g = gravity(scene);

  std::vector<Vector3> missing(now.size(), Vector3::Zero());  // impulse [N s] or its moment [N m s]
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = scene.bodies[i];
    missing[i] = turns ? Vector3(spin(body, now[i]) - spin(body, before[i]))
                       : Vector3(body.mass * (now[i].velocity - before[i].velocity - recording.dt * g));
  }
  const auto give = [&](int body, const Vector3& point, const Vector3& impulse) {
    if (body == world) return;
    const auto i = static_cast<std::size_t>(body);
    missing[i] -= turns ? Vector3((point - now[i].position).cross(impulse)) : impulse;
  };
  if (recording.contacts)
    for (const Contact& c : *recording.contacts) {
      const Vector3 impulse = c.impulse.value_or(0) * c.normal + c.friction.value_or(Vector3::Zero());
      give(c.pair.body, c.point, impulse);
      give(c.pair.other, c.point, -impulse);
    }
  double result = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (asked(q, scene, i)) result = worst(missing[i].norm() / recording.dt, result);
  return result;
}

}  // namespace cylon::core
