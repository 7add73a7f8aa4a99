#include "harness/core/force_balance.h"

#include "harness/core/joint_coordinates.h"
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

Vector3 spin(const Body& body, const BodyState& s) {
  return world_inertia(body, s.orientation) * s.angular_velocity;
}

bool rough(const Scene& scene, const Pair& pair) {
  const auto material = material_of(scene, pair);
  return !material || material->friction > 0;
}

// Which of two things that a force acts between are asked for.
struct Asked {
  const Observable& q;
  const Scene& scene;
  bool one(int body) const { return body != world && asked(q, scene, static_cast<std::size_t>(body)); }
  bool any(const Pair& pair) const { return one(pair.body) || one(pair.other); }
  bool any(const Joint& joint) const { return one(joint.body) || one(joint.to); }
};

}  // namespace

std::optional<std::string> balance_undefined(const Observable& q, const Scene& scene) {
  if (scene.frame) return "the scene's frame moves";
  for (const Force& force : scene.forces)
    if (!std::holds_alternative<UniformGravity>(force))
      return "a force other than gravity, contacts and joints acts in the scene";
  if (any_coordinate(scene, [](const JointCoordinate&) { return true; }))
    return "something acts along a coordinate of a joint";
  if (q.body && scene.bodies[static_cast<std::size_t>(*q.body)].locked) return "the body is locked";
  const Asked of{q, scene};
  const auto concerns = [&](const auto& between) { return of.any(between); };
  if (std::ranges::none_of(scene.joints, concerns) && !any_touching_pair(scene, concerns))
    return "nothing may touch the body, and no joint holds it";
  return std::nullopt;
}

std::optional<std::string> untold(const Observable& q, const Scene& scene, const Recording& recording) {
  const Asked of{q, scene};
  bool hangs = false;
  for (std::size_t j = 0; j < scene.joints.size(); ++j) {
    if (!of.any(scene.joints[j])) continue;
    hangs = true;
    if (!recording.reactions) return "the engine tells no forces of joints";
    if (std::ranges::none_of(*recording.reactions, [&](const Reaction& r) { return r.joint == j; }))
      return "the engine tells no force of a joint in the last step";
  }
  if (!recording.contacts) return "the engine tells no contact forces";
  if (recording.contacts->empty() && !hangs) return "the engine tells no contact force of the last step";
  for (const Contact& c : *recording.contacts) {
    if (!of.any(c.pair)) continue;
    if (!c.impulse) return "the engine tells where surfaces press in the last step, but not how hard";
    if (!c.friction && rough(scene, c.pair)) return "the engine tells no friction of the last step";
  }
  return std::nullopt;
}

double force_imbalance(const Observable& q, const Scene& scene, const Recording& recording) {
  const std::size_t n = recording.steps.size();
  if (n < 2 || recording.steps[n - 1] - recording.steps[n - 2] != 1)
    throw std::logic_error("a balance needs the states of the last two steps");
  const State &before = recording.states[n - 2], &now = recording.states[n - 1];
  const bool turns = q.quantity == Quantity::angular_momentum_balance;
  const Vector3 of_all = gravity(scene);

  std::vector<Vector3> missing(now.size(), Vector3::Zero());  // impulse [N s] or its moment [N m s]
  for (std::size_t i = 0; i < now.size(); ++i) {
    const Body& body = scene.bodies[i];
    const Vector3 g = body.gravity.value_or(of_all);
    missing[i] = turns ? Vector3(spin(body, now[i]) - spin(body, before[i]))
                       : Vector3(body.mass * (now[i].velocity - before[i].velocity - recording.dt * g));
  }
  const auto give = [&](int body, const Vector3& point, const Vector3& impulse, const Vector3& moment) {
    if (body == world) return;
    const auto i = static_cast<std::size_t>(body);
    missing[i] -= turns ? Vector3((point - now[i].position).cross(impulse) + moment) : impulse;
  };
  const Vector3 none = Vector3::Zero();
  if (recording.contacts)
    for (const Contact& c : *recording.contacts) {
      const Vector3 impulse = c.impulse.value_or(0) * c.normal + c.friction.value_or(none);
      give(c.pair.body, c.point, impulse, none);
      give(c.pair.other, c.point, -impulse, none);
    }
  if (recording.reactions)
    for (const Reaction& r : *recording.reactions) {
      const Joint& joint = scene.joints.at(r.joint);
      give(joint.body, r.point, r.impulse, r.moment);
      give(joint.to, r.point, -r.impulse, -r.moment);
    }
  double result = 0;
  for (std::size_t i = 0; i < now.size(); ++i)
    if (asked(q, scene, i)) result = worst(missing[i].norm() / recording.dt, result);
  return result;
}

}  // namespace cylon::core
