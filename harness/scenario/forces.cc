// Gravity, springs and the other forces.
#include "harness/scenario/draft.h"

#include <fmt/format.h>

namespace cylon::scenario {
namespace {

using core::Vector3;

Vector3 world_point(const core::Body& body, const Vector3& local) {
  return body.initial.position + body.initial.orientation * local;
}

core::Spring read_spring(const Table& t, const Draft& draft) {
  if (t.has("to") == t.has("pin"))
    t.fail("[[spring]] needs either 'to' (a body) or 'pin' (a point of the world)");
  if (t.has("pin") && t.has("to_anchor"))
    t.fail("to_anchor", "to_anchor belongs to 'to'; a pin is a point by itself");
  core::Spring spring{.body = draft.body(t, "body"),
                      .anchor = t.vector("anchor"),
                      .to = t.has("to") ? draft.body(t, "to") : core::world,
                      .to_anchor = t.has("to") ? t.vector("to_anchor") : t.vector("pin"),
                      .stiffness = t.number("stiffness"),
                      .rest_length = t.number("rest_length"),
                      .damping = t.number("damping")};
  if (spring.to == spring.body) t.fail("to", "a spring joins two different bodies");
  const auto& bodies = draft.scene.bodies;
  const Vector3 from = world_point(bodies[static_cast<std::size_t>(spring.body)], spring.anchor);
  const Vector3 end = spring.to == core::world
                          ? spring.to_anchor
                          : world_point(bodies[static_cast<std::size_t>(spring.to)], spring.to_anchor);
  if (spring.rest_length > 0 && (end - from).norm() == 0)
    t.fail(
        "rest_length",
        fmt::format(
            "rest_length = {}: both ends start at {}, so the force has no direction; valid: 0, or ends apart",
            spring.rest_length, written(from)));
  return spring;
}

core::Drag read_drag(const Table& t, const Draft& draft) {
  if (!t.has("linear") && !t.has("angular") && !t.has("momentum"))
    t.fail("[[drag]] needs 'linear', 'angular' or 'momentum'");
  return {draft.body(t, "body"), t.number("linear"), t.number("angular"), t.number("momentum")};
}

core::Thrust read_thrust(const Table& t, const Draft& draft) {
  core::Thrust thrust;
  thrust.body = draft.body(t, "body");
  thrust.force = t.vector("force");
  thrust.mass_rate = t.number("mass_rate");
  if (t.has("force") == t.has("mass_rate")) t.fail("[[thrust]] needs either 'force' or 'mass_rate'");
  const bool exhaust = t.has("exhaust_velocity"), exchanged = t.has("exchanged_velocity");
  if (t.has("force") && (exhaust || exchanged))
    t.fail(exhaust ? "exhaust_velocity" : "exchanged_velocity",
           "a velocity of the mass belongs to 'mass_rate', not to 'force'");
  if (t.has("mass_rate") && exhaust == exchanged)
    t.fail("mass_rate",
           "mass_rate needs either 'exhaust_velocity' (body axes) or 'exchanged_velocity' (world axes)");
  if (exhaust) thrust.exhaust_velocity = t.vector("exhaust_velocity");
  if (exchanged) thrust.exchanged_velocity = t.vector("exchanged_velocity");
  return thrust;
}

core::Attraction read_attraction(const Table& t, const Draft& draft) {
  core::Attraction pull{draft.body(t, "body"), draft.body(t, "to"), t.number("strength")};
  const auto& bodies = draft.scene.bodies;
  if (pull.to == pull.body) t.fail("to", "an attraction joins two different bodies");
  if (bodies[static_cast<std::size_t>(pull.to)].initial.position ==
      bodies[static_cast<std::size_t>(pull.body)].initial.position)
    t.fail("to", "the two bodies start at one point, where the attraction is infinite");
  return pull;
}

core::Water read_water(const Table& t) {
  return {.level = t.number("level"),
          .wave = t.number("wave"),
          .speed = t.number("speed"),
          .buoyancy = t.number("buoyancy"),
          .drag = t.number("drag"),
          .mode = t.text("mode", "volume")};
}

}  // namespace

void read_forces(const Table& root, Draft& draft) {
  auto& forces = draft.scene.forces;
  if (root.has("gravity")) forces.emplace_back(core::UniformGravity{root.vector("gravity")});
  for (const Table& t : root.tables("spring")) forces.emplace_back(read_spring(t, draft));
  for (const Table& t : root.tables("drag")) forces.emplace_back(read_drag(t, draft));
  for (const Table& t : root.tables("thrust")) forces.emplace_back(read_thrust(t, draft));
  for (const Table& t : root.tables("drive"))
    forces.emplace_back(core::Drive{draft.body(t, "body"), t.vector("force"), t.number("frequency")});
  for (const Table& t : root.tables("attraction")) forces.emplace_back(read_attraction(t, draft));
  for (const Table& t : root.tables("water")) forces.emplace_back(read_water(t));
}

}  // namespace cylon::scenario
