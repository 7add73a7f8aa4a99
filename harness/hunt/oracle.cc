#include "harness/hunt/oracle.h"

#include "harness/core/force_balance.h"
#include "harness/core/force_law.h"
#include "harness/core/joint_coordinates.h"
#include "harness/core/observable.h"
#include "harness/core/size.h"
#include "harness/hunt/recorded.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Scene;
using Reason = std::optional<std::string>;

// ---- Where an oracle has nothing to say -----------------------------------------------------------------

Reason broken(const Scene& scene, const char* core::Broken::*law) {
  for (const core::Broken& force : core::broken_by(scene))
    if (force.*law) return force.*law;
  return {};
}

Reason held(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (!scene.planes.empty()) return "planes are at rest";
  for (const core::Body& body : scene.bodies)
    if (body.locked) return "a body is locked";
  for (const core::Joint& joint : scene.joints)
    if (joint.to == core::world) return "a joint ends at the world";
  return {};
}

Reason not_isolated(const Scene& scene) {
  if (const Reason why = broken(scene, &core::Broken::momentum)) return why;
  return held(scene);
}

bool is_ball(const core::Body& body) { return std::holds_alternative<core::Sphere>(body.shape); }

// Balls without friction that rebound with all of their speed: whether the blows of one instant come one after the other or
// together, none takes energy.
bool is_elastic(const Scene& scene, const core::Pair& pair) {
  const auto body = [&](int i) -> const core::Body& { return scene.bodies[static_cast<std::size_t>(i)]; };
  if (!is_ball(body(pair.body)) || (pair.plane < 0 && !is_ball(body(pair.other)))) return false;
  const auto material = core::material_of(scene, pair);
  return material && material->restitution == 1 && material->friction == 0;
}

// A scene of somebody's may begin with bodies in each other, which must come out, and gain energy by it.
Reason overlap_at_start(const Scene& scene) {
  const core::State start = core::initial_state(scene);
  for (const core::Pair& pair : core::touching_pairs(scene)) {
    if (core::gap_undefined(scene, pair)) return "a gap is not computed";
    double least = core::size(scene.bodies[static_cast<std::size_t>(pair.body)]);
    if (pair.plane < 0)
      least = std::min(least, core::size(scene.bodies[static_cast<std::size_t>(pair.other)]));
    if (core::gap(scene, pair, start) < -1e-6 * least) return "bodies begin in each other";
  }
  return {};
}

Reason loses_energy(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (core::any_touching_pair(scene, [&](const core::Pair& pair) { return !is_elastic(scene, pair); }))
    return "blows and friction take energy";
  if (const Reason why = overlap_at_start(scene)) return why;
  return broken(scene, &core::Broken::energy);
}

// Gravity, springs, attraction and drag give no energy; contacts and joints do not.
Reason may_gain_energy(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (core::any_coordinate(scene, core::target_moves)) return "a servo does work";
  for (const core::Force& force : scene.forces)
    if (!std::holds_alternative<core::UniformGravity>(force) &&
        !std::holds_alternative<core::Spring>(force) && !std::holds_alternative<core::Attraction>(force) &&
        !std::holds_alternative<core::Drag>(force))
      return "a force does work";
  return {};
}

Reason touches_nothing(const Scene& scene) { return may_touch(scene) ? Reason() : Reason("nothing touches"); }

// A certified solution costs the cube of the number of its unknowns.
Reason too_dear(const Scene& scene) {
  if (may_touch(scene)) return "bodies touch";
  const auto moving = std::ranges::count_if(scene.bodies, [](const core::Body& b) { return !b.locked; });
  return moving > 2 ? Reason("more than two bodies move") : Reason();
}

Reason no_joints(const Scene& scene) { return scene.joints.empty() ? Reason("no joint") : Reason(); }

Reason no_axes(const Scene& scene) {
  for (const core::Joint& joint : scene.joints)
    if (!core::kind_of(joint.type).turns_freely()) return {};
  return "no joint keeps an axis";
}

// Boxes at rest, each with a face on the floor, or on a box with its middle within a tenth of that one's: so that no
// pile of less than twenty leans too far.
Reason not_at_rest(const Scene& scene) {
  if (scene.planes.size() != 1 || !scene.joints.empty() || scene.frame) return "not one floor";
  const core::Vector3 n = scene.planes[0].normal;
  if (scene.forces.size() != 1 || !std::holds_alternative<core::UniformGravity>(scene.forces[0]))
    return "not gravity alone";
  const core::Vector3 g = core::gravity(scene);
  if (!(g.dot(n) < 0) || g.cross(n).norm() > 1e-12 * g.norm()) return "gravity is not across the floor";
  std::vector<double> tops = {scene.planes[0].offset};
  std::vector<std::pair<double, const core::Body*>> by_height;
  for (const core::Body& body : scene.bodies) {
    const auto* box = std::get_if<core::Box>(&body.shape);
    if (!box || !body.collide || body.locked || body.gravity) return "not boxes alone";
    if (!body.initial.velocity.isZero(0) || !body.initial.angular_velocity.isZero(0))
      return "something moves";
    if (!body.collision_groups.empty() || !body.collision_mask.empty()) return "some do not touch";
    if (!body.initial.orientation.vec().isZero(0) || !n.isApprox(core::Vector3::UnitY()))
      return "a box is turned";
    by_height.emplace_back(body.initial.position.y(), &body);
  }
  for (const core::Body& body : scene.bodies) {
    const core::Vector3 half = std::get<core::Box>(body.shape).half_extents, at = body.initial.position;
    const double bottom = at.y() - half.y();
    if (std::abs(bottom - scene.planes[0].offset) < 1e-12) continue;
    const bool lies = std::ranges::any_of(scene.bodies, [&](const core::Body& below) {
      const core::Vector3 h = std::get<core::Box>(below.shape).half_extents, p = below.initial.position;
      return &below != &body && std::abs(p.y() + h.y() - bottom) < 1e-12 &&
             std::abs(at.x() - p.x()) < 0.1 * h.x() && std::abs(at.z() - p.z()) < 0.1 * h.z();
    });
    if (!lies) return "a box has nothing below it";
  }
  return {};
}

Reason may_gain_energy_by_touch(const Scene& scene) {
  if (const Reason why = may_gain_energy(scene)) return why;
  return overlap_at_start(scene);
}

Reason no_penetration(const Scene& scene) {
  if (const Reason why = touches_nothing(scene)) return why;
  return overlap_at_start(scene);
}

Reason no_locked(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, &core::Body::locked) ? Reason() : Reason("no body is locked");
}

// Forces that are known beforehand, and whatever joints and contacts do, which is no work.
Reason speed_without_bound(const Scene& scene) {
  if (scene.frame) return "the frame moves";
  if (core::any_coordinate(scene, core::has_force)) return "a force along a joint has no bound";
  for (const core::Force& force : scene.forces) {
    const auto* thrust = std::get_if<core::Thrust>(&force);
    const bool bounded = std::holds_alternative<core::UniformGravity>(force) ||
                         std::holds_alternative<core::Drag>(force) ||
                         std::holds_alternative<core::Drive>(force) || (thrust && thrust->mass_rate == 0);
    if (!bounded) return "a force has no bound";
  }
  return overlap_at_start(scene);
}

Reason no_ball_that_falls(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.planes.size() != 1 || scene.frame || !scene.joints.empty() ||
      !may_touch(scene) || !is_ball(scene.bodies[0]))
    return "not one ball and one plane";
  for (const core::Force& force : scene.forces)
    if (!std::holds_alternative<core::UniformGravity>(force)) return "not gravity alone";
  return overlap_at_start(scene);
}

// A box whose lower face begins on a level plane, without spin, and whose weight stays over that face however it brakes:
// the pressure's middle moves by mu h, h the height of the centre.
Reason no_box_that_slides(const Scene& scene) {
  if (scene.bodies.size() != 1 || scene.planes.size() != 1 || scene.frame || !scene.joints.empty() ||
      !may_touch(scene) || scene.forces.size() != 1 ||
      !std::holds_alternative<core::UniformGravity>(scene.forces[0]))
    return "not one body, one plane and gravity";
  const core::Body& body = scene.bodies[0];
  const auto* box = std::get_if<core::Box>(&body.shape);
  const core::Vector3 n = scene.planes[0].normal, v = body.initial.velocity,
                      g = core::gravity_of(scene, body);
  if (!box || !n.isApprox(core::Vector3::UnitY()) || !body.initial.orientation.vec().isZero(0))
    return "not a box upright";
  if (!(g.y() < 0) || g.cross(n).norm() > 1e-12 * g.norm()) return "gravity is not across the plane";
  const core::Vector3 h = box->half_extents;
  if (std::abs(body.initial.position.y() - h.y() - scene.planes[0].offset) > 1e-12 * h.y())
    return "it does not begin on the plane";
  if (!(v.norm() > 0) || v.y() != 0 || !body.initial.angular_velocity.isZero(0)) return "it does not slide";
  const auto material = core::material_of(scene, {0, core::world, 0});
  if (!material) return "no material";
  if (material->friction * h.y() > 0.8 * std::min(h.x(), h.z())) return "it may tip";
  return {};
}

// Free balls: their axes stay, and their rates.
Reason no_free_balls(const Scene& scene) {
  if (scene.frame || !scene.joints.empty() || may_touch(scene)) return "not free bodies";
  for (const core::Body& body : scene.bodies)
    if (body.locked || !is_ball(body) ||
        !body.inertia.isApprox(body.inertia(0, 0) * core::Matrix3::Identity(), 1e-12))
      return "not balls alone";
  for (const core::Force& force : scene.forces)
    if (!std::holds_alternative<core::UniformGravity>(force)) return "not gravity alone";
  return {};
}

// Forces of joints; of contacts they are told of an instant of the step.
Reason no_balance(const Scene& scene) {
  if (const Reason why = no_joints(scene)) return why;
  if (may_touch(scene)) return "bodies touch";
  return core::balance_undefined({.quantity = core::Quantity::momentum_balance}, scene);
}

// ---- Where a step makes no error ------------------------------------------------------------------------

bool always(const Scene&) { return true; }

// Balls that fly on until they hit: a blow that comes late finds the same speeds.
bool flies_on_between_blows(const Scene& scene) {
  return scene.forces.empty() && scene.joints.empty() && !scene.frame && may_touch(scene) &&
         std::ranges::all_of(scene.bodies, is_ball);
}

constexpr std::string_view rounding_and_a_decade = "truncation is told by its course; ten times this is seen";

constexpr std::array all = {
    Oracle{.name = "linear momentum",
           .says = "what nothing holds keeps its momentum",
           .relative = 1e-4,
           .why = "forces come in pairs, whatever the step; ten times this is far from single precision",
           .undefined_in = not_isolated,
           .claim = "conserves = \"linear_momentum\""},
    Oracle{.name = "angular momentum",
           .says = "what nothing holds keeps its angular momentum",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = not_isolated,
           .claim = "conserves = \"angular_momentum\""},
    Oracle{.name = "energy",
           .says = "without losses the energy stays; balls that rebound with all of their speed lose none",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = loses_energy,
           .claim = "conserves = \"energy\"\nsample = \"step\"",
           .stepless_in = flies_on_between_blows},
    Oracle{.name = "energy from nowhere",
           .says = "the energy never rises: blows, friction, dampers and drag give none",
           .relative = 1e-3,
           .why = "a step may end between a blow and its rebound",
           .undefined_in = may_gain_energy_by_touch,
           .claim = "conserves = \"energy\"\nmeasure = \"increase\"\nsample = \"step\"",
           .one_sided = true,
           .stepless_in = flies_on_between_blows},
    Oracle{.name = "penetration",
           .says = "solids do not pass into each other",
           .relative = 5e-3,
           .why = "engines leave a slop of some thousandths of a body, so that contacts stay",
           .undefined_in = no_penetration,
           .claim = "conserves = \"normal_gap\"\nsample = \"step\""},
    Oracle{.name = "joint gap",
           .says = "what a joint joins stays together",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = no_joints,
           .claim = "conserves = \"joint_gap\"\nsample = \"step\""},
    Oracle{.name = "joint axis",
           .says = "what a joint does not let turn does not turn",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = no_axes,
           .claim = "conserves = \"angular_joint_gap\"\nsample = \"step\"",
           .of_angle = true},
    Oracle{.name = "joint forces",
           .says = "the forces of joints, as the engine tells them, moved the bodies",
           .relative = 1e-3,
           .why = "truncation is told by its course; an engine may tell the force of one instant",
           .undefined_in = no_balance,
           .claim = "conserves = \"momentum_balance\"",
           .of_steps = true},
    Oracle{.name = "joint torques",
           .says = "the torques of joints, as the engine tells them, turned the bodies",
           .relative = 1e-3,
           .why = "as of joint forces",
           .undefined_in = no_balance,
           .claim = "conserves = \"angular_momentum_balance\"",
           .of_steps = true},
    Oracle{.name = "rest",
           .says = "what stands at rest stays there",
           .relative = 1e-3,
           .why = "as of penetration, for a tenth of it creeps",
           .undefined_in = not_at_rest,
           .claim = "conserves = \"position\"\nsample = \"step\"",
           .stepless_in = always},
    Oracle{.name = "statics",
           .says = "the contact forces on what stands at rest balance its weight",
           .relative = 1e-2,
           .why = "an iterative solver leaves some thousandths",
           .undefined_in = not_at_rest,
           .read = read_statics,
           .of_contacts = true,
           .stepless_in = always},
    Oracle{.name = "rebound",
           .says = "a ball leaves a plane with the coefficient of restitution times its speed of approach",
           .relative = 1e-2,
           .why = "a blow may come a step late, by g dt of its speed",
           .undefined_in = no_ball_that_falls,
           .read = read_rebound},
    Oracle{.name = "slide",
           .says = "a box that slides is braked by the coefficient of friction times its weight",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = no_box_that_slides,
           .read = read_slide},
    Oracle{.name = "spin",
           .says = "a ball that no torque turns turns evenly",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = no_free_balls,
           .read = read_spin,
           .of_angle = true},
    Oracle{.name = "locked",
           .says = "what is locked does not move",
           .relative = 1e-6,
           .why = "single precision",
           .undefined_in = no_locked,
           .read = read_locked},
    Oracle{.name = "speed",
           .says = "no speed is above what the forces can give",
           .relative = 1e-3,
           .why = "the bound is that of the worst direction at every instant",
           .undefined_in = speed_without_bound,
           .read = read_speed,
           .one_sided = true,
           .stepless_in = flies_on_between_blows},
    Oracle{.name = "place",
           .says = "the places are those of the certified solution",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = too_dear,
           .claim = "follows = \"certified\"\nobservable = \"position\"",
           .of_trajectories = true},
    Oracle{.name = "turn",
           .says = "the turns are those of the certified solution",
           .relative = 1e-3,
           .why = rounding_and_a_decade,
           .undefined_in = too_dear,
           .claim = "follows = \"certified\"\nobservable = \"orientation\"",
           .of_trajectories = true,
           .of_angle = true},
};

}  // namespace

std::span<const Oracle> oracles() { return all; }

std::string claim_of(const Oracle& oracle) {
  if (oracle.claim.empty()) return {};
  return fmt::format(
      "[[claim]]\n{}\ntolerance = {{ {} = {}, reason = \"convention: ten times this is a fault\" }}\n",
      oracle.claim, oracle.of_angle ? "absolute" : "relative", oracle.relative);
}

bool may_touch(const Scene& scene) {
  return core::any_touching_pair(scene, [](const core::Pair&) { return true; });
}

bool is_smooth(const Scene& scene) {
  return !may_touch(scene) && !core::any_coordinate(scene, [](const core::JointCoordinate& c) {
    return core::has_limit(c) || c.friction != 0 || !c.target_times.empty();
  });
}

}  // namespace cylon::hunt
