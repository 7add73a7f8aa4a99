#include "harness/core/event_signal.h"

namespace cylon::core {
namespace {

EventSubject subject_of(const Observable& q, const Scene& scene, const Pair& pair) {
  const auto body = static_cast<std::size_t>(pair.body);
  const Vector3 pole = event_pole(scene, scene.bodies[body]);
  int least = 0;  // the world axis farthest from the pole
  pole.cwiseAbs().minCoeff(&least);
  const Vector3 first = pole.cross(Vector3::Unit(least)).normalized();
  return {.scene = scene,
          .pair = pair,
          .body = body,
          .about = q.about,
          .up = event_up(scene, scene.bodies[body]),
          .pole = pole,
          .first = first,
          .second = pole.cross(first),
          .water = event_water(scene)};
}

}  // namespace

Vector3 event_up(const Scene& scene, const Body& body) {
  const Vector3 g = gravity_of(scene, body);
  return g.isZero(0) ? Vector3::UnitY() : Vector3(-g.normalized());
}

Vector3 event_pole(const Scene& scene, const Body& body) {
  if (!gravity_of(scene, body).isZero(0)) return event_up(scene, body);
  const BodyState& s = body.initial;
  const Vector3 spin = world_inertia(body, s.orientation) * s.angular_velocity;
  return spin.isZero(0) ? spin : Vector3(spin.normalized());
}

const Water* event_water(const Scene& scene) {
  for (const Force& force : scene.forces)
    if (const auto* water = std::get_if<Water>(&force)) return water;
  return nullptr;
}

EventSignal::EventSignal(const Observable& q, const Scene& scene, const Pair& pair)
    : row_(event_row(q.event)), subject_(subject_of(q, scene, pair)) {
  if (row_.prepare) row_.prepare(subject_);
}

std::vector<Pair> event_subjects(const Observable& q, const Scene& scene) {
  if (event_type(q.event).of_pairs) return q.body ? touching_pairs(scene, *q.body) : touching_pairs(scene);
  std::vector<Pair> bodies;
  for (int i = 0; i < static_cast<int>(scene.bodies.size()); ++i)
    if (q.body ? *q.body == i : !scene.bodies[static_cast<std::size_t>(i)].locked && q.to != i)
      bodies.push_back({i, q.to.value_or(world), -1});
  return bodies;
}

std::optional<std::string> event_undefined(const Observable& q, const Scene& scene) {
  const EventRow& row = event_row(q.event);
  const std::vector<Pair> subjects = event_subjects(q, scene);
  if (subjects.empty()) return row.type.of_pairs ? "no two things in the scene may touch" : "no body moves";
  if (!row.undefined) return std::nullopt;
  for (const Pair& pair : subjects)
    if (auto why = row.undefined(scene, pair)) return why;
  return std::nullopt;
}

}  // namespace cylon::core
