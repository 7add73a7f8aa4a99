// Scene shapes as Bullet's collision shapes.
#pragma once

#include "harness/core/scene.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

class btCollisionShape;

namespace cylon::simulators {

/// Owns shapes; a compound refers to its children.
using Shapes = std::vector<std::unique_ptr<btCollisionShape>>;

/// Why a shape, of a body that is locked or not, cannot touch anything in Bullet, or nothing.
std::optional<std::string> untouchable(const core::Shape&, bool locked);

/// The shape in a frame that is turned by `rotation` (frame to body axes) from the body's.  `margin` [m] of
/// all but spheres and capsules; absent: Bullet's own, at most 0.04 m.
/// Requires untouchable(shape, locked) to be empty; what nothing can touch becomes an empty shape.
btCollisionShape* make_shape(const core::Shape&, const core::Quaternion& rotation,
                             std::optional<double> margin, Shapes&);

/// Radius of the largest sphere about the centre of mass that is inside the shape [m]; 0 where there is none,
/// or where make_shape() gives a compound, which Bullet's continuous collision detection does not sweep.
double swept_radius(const core::Shape&, const core::Quaternion& rotation);

/// A static half-space.
btCollisionShape* make_shape(const core::Plane&, Shapes&);

}  // namespace cylon::simulators
