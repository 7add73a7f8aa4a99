// From a foreign model to a scene, one step after the other.  Each changes the model in place or adds to its losses.
#pragma once

#include "harness/core/scene.h"
#include "harness/imports/model/model.h"

#include <optional>
#include <string>
#include <vector>

namespace cylon::imports {

/// z up becomes y up, (x, y, z) -> (x, z, -y), in all axes, those of bodies too: exact, no number is rounded.
/// Solids of revolution then have their axis along y, and planes are solid below y = 0, also where `keep_axes` leaves all
/// others as they are.
void turn_up(foreign::Model&, bool keep_axes);

/// Whether a body is no more than planes of the world.
bool is_ground(const foreign::Body&);

/// Bodies without mass, and those that the format takes for one, become one with what they are fixed to; joints to
/// what is locked and has no surface but planes become joints to the world.  Ground comes last among the bodies.
/// Throws core::InputError at a body that moves and has no mass, and at a joint of a body with itself.
void merge_fixed(foreign::Model&, const std::string& file);

/// Legal, unique names of bodies.
void name_bodies(foreign::Model&);

/// The name, without what no name of a scene may have.
std::string legal_name(std::string);

/// Coordinates that equal limits hold where they start are no freedoms.  Throws core::InputError at a joint whose lower
/// limit is above the upper.
void check_limits(foreign::Model&, const std::string& file);

/// Throws core::InputError at a joint of the scene that starts outside of its limits.
void check_starts(const foreign::Model&, const std::string& file);

/// The joints of the scene, of the kinds that it has; the rest is added to the losses.
std::vector<core::Joint> joints_of(foreign::Model&);

/// Leaves the rotors of all joints out, each told as a loss.
void leave_rotors_out(foreign::Model&);

/// Shapes, planes, materials and collision groups.
void add_contacts(foreign::Model&, core::Scene&);

/// The whole scene of a model whose bodies are named.
core::Scene scene_of(foreign::Model&);

}  // namespace cylon::imports
