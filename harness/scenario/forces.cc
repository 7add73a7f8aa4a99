// Gravity, springs and the other forces.
#include "harness/core/force_law.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <type_traits>
#include <utility>
#include <vector>

namespace cylon::scenario {
namespace {

using core::Vector3;

Vector3 world_point(const core::Body& body, const Vector3& local) {
  return body.initial.position + body.initial.orientation * local;
}

// What the key tables cannot say of one kind of force.

void check(const Table& t, const Draft& draft, const core::Spring& spring) {
  if (t.has("to") == t.has("pin"))
    t.fail("[[spring]] needs either 'to' (a body) or 'pin' (a point of the world)");
  if (t.has("pin") && t.has("to_anchor"))
    t.fail("to_anchor", "to_anchor belongs to 'to'; a pin is a point by itself");
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
}

void check(const Table& t, const Draft&, const core::Drag&) {
  if (!t.has("linear") && !t.has("angular") && !t.has("momentum"))
    t.fail("[[drag]] needs 'linear', 'angular' or 'momentum'");
}

void check(const Table& t, const Draft&, const core::Thrust&) {
  if (t.has("force") == t.has("mass_rate")) t.fail("[[thrust]] needs either 'force' or 'mass_rate'");
  const bool exhaust = t.has("exhaust_velocity"), exchanged = t.has("exchanged_velocity");
  if (t.has("force") && (exhaust || exchanged))
    t.fail(exhaust ? "exhaust_velocity" : "exchanged_velocity",
           "a velocity of the mass belongs to 'mass_rate', not to 'force'");
  if (t.has("mass_rate") && exhaust == exchanged)
    t.fail("mass_rate",
           "mass_rate needs either 'exhaust_velocity' (body axes) or 'exchanged_velocity' (world axes)");
}

void check(const Table& t, const Draft& draft, const core::PluginForce& force) {
  if (force.bodies.empty()) t.fail("bodies", "bodies = []: must name one body at least");
  for (std::size_t i = 0; i < force.bodies.size(); ++i)
    if (std::find(force.bodies.begin(), force.bodies.begin() + static_cast<std::ptrdiff_t>(i),
                  force.bodies[i]) != force.bodies.begin() + static_cast<std::ptrdiff_t>(i))
      t.fail("bodies", fmt::format("bodies: '{}' is named twice",
                                   draft.scene.bodies[static_cast<std::size_t>(force.bodies[i])].name));
}

// The masses of bodies change evenly; those of locked ones do not.
void require_mass_to_the_end(const std::vector<std::pair<Table, core::Thrust>>& thrusts,
                             const core::Scene& scene, double duration) {
  std::map<int, double> rates;
  for (const auto& [t, thrust] : thrusts) rates[thrust.body] += thrust.mass_rate;
  for (const auto& [t, thrust] : thrusts) {
    const core::Body& body = scene.bodies[static_cast<std::size_t>(thrust.body)];
    const double rate = rates[thrust.body];
    if (body.locked || !(thrust.mass_rate < 0) || body.mass + rate * duration > 0) continue;
    t.fail("mass_rate",
           fmt::format("mass_rate = {}: of '{}' nothing is left at t = {} s; valid: a mass above 0 until the "
                       "end, at {} s",
                       thrust.mass_rate, body.name, body.mass / -rate, duration));
  }
}

// What holds for every kind: two ends are two bodies, and the force is finite at the start.
template <class Kind>
void check_any(const Table& t, const Draft& draft, const core::State& start, const Kind& force) {
  if constexpr (requires { force.to; })
    if (force.to == force.body)
      t.fail("to", fmt::format("a force of kind {} joins two different bodies", core::Element<Kind>::name));
  if (!std::isfinite(core::potential(force, draft.scene, start)))
    t.fail(
        fmt::format("the {} has no finite energy at the start: two places that coincide, or a number "
                    "too large",
                    core::Element<Kind>::name));
}

}  // namespace

void read_forces(const Table& root, Draft& draft) {
  auto& forces = draft.scene.forces;
  core::State start;
  std::vector<std::pair<Table, core::Thrust>> thrusts;
  core::for_each_force([&]<class Kind>() {
    constexpr std::string_view name = core::Element<Kind>::name;
    if constexpr (std::is_same_v<Kind, core::UniformGravity>) {
      if (root.has(name)) forces.emplace_back(read_element<Kind>(root, draft));
    } else {
      for (const Table& t : root.tables(name)) {
        if (start.empty()) start = core::initial_state(draft.scene);
        auto force = read_element<Kind>(t, draft);
        check_any(t, draft, start, force);
        if constexpr (requires { check(t, draft, force); }) check(t, draft, force);
        if constexpr (std::is_same_v<Kind, core::Thrust>) thrusts.emplace_back(t, force);
        forces.emplace_back(std::move(force));
      }
    }
  });
  require_mass_to_the_end(thrusts, draft.scene, root.number("duration"));
}

}  // namespace cylon::scenario
