// What the families of random scenes have in common: a body, how it moves, gravity, a floor, a material.
#pragma once

#include "harness/core/scene.h"
#include "harness/hunt/dice.h"

namespace cylon::hunt {

core::Shape some_shape(Dice&);

/// 1 : 1 mostly, now and then up to 1 : 100 000 [kg].
double some_mass(Dice&);

/// A body at rest at a place, with the mass properties of its shape.  The reference holds until the next one is added.
core::Body& add_body(core::Scene&, const core::Shape&, double mass, const core::Vector3& place);

/// Turned anyhow; each component of its velocities up to `speed` [m/s] and `spin` [rad/s].
void set_moving(Dice&, core::Body&, double speed, double spin);

/// Three times in four, mostly downwards.
void maybe_gravity(Dice&, core::Scene&);

/// One restitution and one friction for all pairs.
void add_material(Dice&, core::Scene&);

/// A plane through the origin, level three times in four.
void add_floor(Dice&, core::Scene&);

}  // namespace cylon::hunt
