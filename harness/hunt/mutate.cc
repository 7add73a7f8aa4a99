#include "harness/hunt/mutate.h"

#include "harness/core/collision_filter.h"
#include "harness/core/fields.h"
#include "harness/hunt/dice.h"
#include "harness/hunt/scene_parts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Body;
using core::Scene;

// Calls visit(about, value) for each number or vector of the scene; those of bodies' starts too.
template <class Visit>
void each_number(Scene& scene, const Visit& visit) {
  const auto of = [&](auto& element) {
    core::for_each_field(element, [&]<class Value>(const auto& field, Value& value) {
      if (field.applies && !field.applies(element)) return;
      if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, core::Vector3>)
        visit(field.about, value);
      if constexpr (std::is_same_v<Value, core::BodyState>)
        core::for_each_field(value, [&]<class Part>(const auto& part, Part& inner) {
          if constexpr (std::is_same_v<Part, core::Vector3>) visit(part.about, inner);
        });
    });
  };
  core::for_each_element(scene, of);
}

// Speeds, gravity, stiffnesses: those of one rank by one factor, which keeps joints and contacts closed.
bool another_start(Dice& dice, Trial& trial) {
  std::set<int> ranks;
  each_number(trial.scene, [&](const core::About& about, auto&) {
    if (about.start_rank > 0) ranks.insert(about.start_rank);
  });
  if (ranks.empty()) return false;
  const int rank = *std::next(ranks.begin(), static_cast<std::ptrdiff_t>(dice.below(ranks.size())));
  const double factor = dice.between(0.2, 4);
  each_number(trial.scene, [&](const core::About& about, auto& value) {
    if (about.start_rank == rank) value *= factor;
  });
  return true;
}

// A stiffness, a drag, a friction, …: none of it, less, or more.
bool another_law(Dice& dice, Trial& trial) {
  std::size_t count = 0;
  // Lengths stay: a spring whose ends meet has no direction, unless it has no length.
  const auto tunable = [](const core::About& about) { return about.tunable && about.unit != "m"; };
  each_number(trial.scene, [&](const core::About& about, auto&) { count += tunable(about); });
  if (count == 0) return false;
  std::size_t pick = dice.below(count);
  const double factor = dice.of(std::array{0.0, 0.1, 0.5, 2.0, 10.0});
  const double fresh = dice.of(std::array{0.0, 0.3, 0.5, 1.0});  // of a number that was 0
  each_number(trial.scene, [&]<class Value>(const core::About& about, Value& value) {
    if (!tunable(about) || pick-- != 0) return;
    if constexpr (std::is_same_v<Value, double>) {
      value = value == 0 ? fresh : value * factor;
      value = std::clamp(value, about.range.low, about.range.high);
      if (about.range.open && value <= about.range.low) value = 1;
    } else {
      value *= factor;
    }
  });
  return true;
}

// Masses of compounds are those of their parts, and what loses mass must have it.
bool another_mass(Dice& dice, Trial& trial) {
  std::vector<std::size_t> free;
  for (std::size_t i = 0; i < trial.scene.bodies.size(); ++i) {
    const Body& body = trial.scene.bodies[i];
    if (!body.locked && !std::holds_alternative<core::Compound>(body.shape)) free.push_back(i);
  }
  if (free.empty()) return false;
  Body& body = trial.scene.bodies[dice.of(free)];
  const bool loses = std::ranges::any_of(trial.scene.forces, [](const core::Force& force) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    return thrust && thrust->mass_rate < 0;
  });
  const double factor = loses ? dice.of(std::array{2.0, 10.0}) : dice.of(std::array{0.01, 0.1, 10.0, 100.0});
  body.mass *= factor, body.inertia *= factor;
  return true;
}

// Whether something that may touch is in every group that a mask names, as the reader asks.
bool masks_have_members(const Scene& scene) {
  std::set<std::string> known, named;
  const auto add = [&](const auto& thing) {
    if (thing.collision_groups.empty()) known.insert(std::string(core::default_group));
    known.insert(thing.collision_groups.begin(), thing.collision_groups.end());
    named.insert(thing.collision_mask.begin(), thing.collision_mask.end());
  };
  for (const Body& body : scene.bodies)
    if (body.collide) add(body);
  for (const core::Plane& plane : scene.planes) add(plane);
  return std::ranges::includes(known, named);
}

bool fewer_bodies(Dice& dice, Trial& trial) {
  const std::vector<Body>& bodies = trial.scene.bodies;
  const auto moving = std::ranges::count_if(bodies, [](const Body& body) { return !body.locked; });
  const std::size_t i = bodies.empty() ? 0 : dice.below(bodies.size());
  if (moving < 2 || bodies[i].locked) return false;
  Scene fewer = without_body(trial.scene, i);
  if (!masks_have_members(fewer)) return false;
  trial.scene = std::move(fewer);
  return true;
}

// Far away and touching nothing: it must change nothing.
bool a_bystander(Dice& dice, Trial& trial) {
  Body body;
  body.name = "bystander";
  for (const Body& other : trial.scene.bodies)
    if (other.name == body.name) return false;
  for (const core::Plane& plane : trial.scene.planes)
    if (plane.name == body.name) return false;
  body.mass = dice.between(0.5, 3);
  body.inertia = core::Vector3(0.3, 0.2, 0.4).asDiagonal();
  body.initial.position = {50, 40, 30};
  body.initial.velocity = dice.vector(1), body.initial.angular_velocity = dice.vector(3);
  trial.scene.bodies.push_back(body);
  return true;
}

bool another_step(Dice& dice, Trial& trial) {
  trial.step *= dice.of(std::array{0.5, 2.0});
  return true;
}

constexpr std::array all = {
    Mutation{"speeds, gravity or stiffnesses by one factor", another_start},
    Mutation{"a stiffness, drag, friction or restitution: none, less or more", another_law},
    Mutation{"a body that is lighter or heavier by up to a hundred", another_mass},
    Mutation{"a body less, with what names it", fewer_bodies},
    Mutation{"a body far away that touches nothing", a_bystander},
    Mutation{"half the step, or twice", another_step},
};

}  // namespace

std::span<const Mutation> mutations() { return all; }

Trial mutated(Dice& dice, Trial trial) {
  const std::size_t changes = 1 + dice.below(3);
  std::size_t made = 0;
  for (int tries = 0; made < changes && tries < 20; ++tries) made += dice.of(all).make(dice, trial);
  return trial;
}

}  // namespace cylon::hunt
