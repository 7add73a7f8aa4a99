// Shapes of Bullet's API, which its rigid bodies and its btMultiBody share.
#pragma once

#include "harness/hunt/program/dialect.h"

namespace cylon::hunt::program {

inline constexpr ShapeRow bullet_shapes[] = {
    {"sphere", "new btSphereShape(${radius})"},
    {"box", "sharp(new btBoxShape(btVector3(${x}, ${y}, ${z})))"},
    {"capsule", "new btCapsuleShape(${radius}, ${length})"},
    {"cylinder", "sharp(new btCylinderShape(btVector3(${radius}, ${length} / 2, ${radius})))"},
};

}  // namespace cylon::hunt::program
