// The conditions that several solutions share.  Each throws core::OutOfDomain, naming the solution,
// the body or force, and the condition that failed.
#pragma once

#include "harness/core/collision_filter.h"
#include "harness/core/scene.h"
#include "harness/core/truth.h"

#include <initializer_list>
#include <string_view>

namespace cylon::exact {

[[noreturn]] void refuse(std::string_view solution, const std::string& condition);

/// "body 'ball'".
std::string named(const core::Scene&, int body);

/// At least one body, none locked, positive masses, finite positive horizon, no turning frame (one that only
/// moves changes nothing: Galilei).
void check_bodies(std::string_view solution, const core::Scene&, double horizon);

/// No pair of the scene may touch.
void check_no_contacts(std::string_view solution, const core::Scene&);

void check_no_joints(std::string_view solution, const core::Scene&);

/// No force but those of the given kinds, in the words of a scenario file: "gravity", "spring", "drag", ….  Where
/// gravity is none of them, bodies have none of their own either.
void check_forces(std::string_view solution, const core::Scene&,
                  std::initializer_list<std::string_view> kinds);

/// The same, where something may act along joints.
void check_forces_beside_joints(std::string_view solution, const core::Scene&,
                                std::initializer_list<std::string_view> kinds);

/// Every spring ties the centre of a body to the world without damping and every body has one at least.
void check_springs(std::string_view solution, const core::Scene&);

/// No spring has a rest length.
void check_no_rest_length(std::string_view solution, const core::Scene&);

/// The body turns about a fixed axis when no torque acts: the sine of the angle between w and I w is at most 1e-14, and
/// about the axis of the middle moment, from which it grows as exp(growth t), remains so until the horizon [s].
void check_steady_spin(std::string_view solution, const core::Scene&, int body, double horizon);

/// The body is a sphere that collides.  Its radius [m].
double colliding_radius(std::string_view solution, const core::Scene&, int body);

/// Groups and masks let the pair touch.
void check_meets(std::string_view solution, const core::Scene&, const core::ContactRules&, const core::Pair&);

/// The pair has a material, and no friction.
void check_smooth(std::string_view solution, const core::Scene&, const core::Pair&);

/// What makes the body fall [m/s^2].
core::Vector3 gravity(const core::Scene&, std::size_t body);

/// What makes all bodies fall alike [m/s^2]; those that are locked do not count.  check_falls_alike says whether.
core::Vector3 common_gravity(const core::Scene&);

/// Gravity acts on every body.
void check_all_fall(std::string_view solution, const core::Scene&);

/// No body that can move has a gravity that differs from that of another.
void check_falls_alike(std::string_view solution, const core::Scene&);

}  // namespace cylon::exact
