#include "harness/hunt/unusual.h"

#include "harness/core/force_law.h"
#include "harness/core/solid.h"
#include "harness/hunt/pieces.h"
#include "harness/study/restate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace cylon::hunt {
namespace {

using core::Body;
using core::Scene;
using core::Shape;
using core::Vector3;

// About its centre of mass, as a reader of the scene takes it.
Shape centred(Shape shape) {
  core::move(shape, -core::mass_properties(shape, 1).centre);
  return shape;
}

// Points on either side of each axis, so that there is a volume.
Shape some_hull(Dice& dice) {
  core::Hull hull;
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1.0, 1.0}) {
      Vector3 point = dice.vector(0.1);
      point[axis] = side * dice.between(0.15, 0.35);
      hull.vertices.push_back(point);
    }
  return centred(hull);
}

core::Primitive some_part(Dice& dice) {
  const double r = dice.between(0.08, 0.15);
  switch (dice.below(4)) {
    case 0:
      return core::Sphere{r};
    case 1:
      return core::Capsule{r / 2, r};
    case 2:
      return core::Cylinder{r / 2, r};
    default:
      return core::Box{{r, dice.between(0.05, 0.15), dice.between(0.05, 0.15)}};
  }
}

Shape some_compound(Dice& dice) {
  core::Compound compound;
  const std::size_t count = 2 + dice.below(2);
  for (std::size_t i = 0; i < count; ++i) {
    core::Part part;
    part.shape = some_part(dice), part.mass = dice.between(0.2, 2);
    part.position = dice.vector(0.2), part.orientation = dice.turn();
    compound.parts.push_back(part);
  }
  return centred(compound);
}

Shape shape_of_points_or_parts(Dice& dice) { return dice.one_in(2) ? some_hull(dice) : some_compound(dice); }

// A compound weighs what its parts do.
double mass_for(Dice& dice, const Shape& shape) {
  return std::holds_alternative<core::Compound>(shape) ? core::mass_properties(shape, 0).mass
                                                       : some_mass(dice);
}

Body& add(Dice& dice, Scene& scene, const Shape& shape, const Vector3& place) {
  const double mass = mass_for(dice, shape);
  Body& body = add_body(scene, shape, mass, place);
  body.collide = true;
  return body;
}

// Cells as wide as this keep bodies of any of these shapes from overlapping at the start [m].
constexpr double cell = 1.6;

}  // namespace

void make_furniture(Dice& dice, Scene& scene) {
  add_material(dice, scene);
  scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}});
  const std::size_t locked = 1 + dice.below(2), falling = 1 + dice.below(3);
  for (std::size_t i = 0; i < locked; ++i) {
    Body& body = add(dice, scene, some_shape(dice), Vector3(cell * static_cast<double>(i), 0, 0));
    body.initial.orientation = dice.turn();
    body.locked = true;
  }
  for (std::size_t i = 0; i < falling; ++i) {
    const Shape shape = dice.one_in(4) ? shape_of_points_or_parts(dice) : some_shape(dice);
    const std::size_t column = i % 2, row = 1 + i / 2;
    Body& body =
        add(dice, scene, shape, cell * Vector3(static_cast<double>(column), static_cast<double>(row), 0));
    set_moving(dice, body, 0.5, 3);
    body.initial.velocity += Vector3(0, -2, 0);
  }
  if (dice.one_in(2)) {
    core::Plane floor;
    floor.name = "floor";
    floor.offset = -1.5;
    scene.planes.push_back(floor);
  }
  core::Material pair = scene.materials[0];
  pair.between[0] = scene.bodies[0].name, pair.between[1] = scene.bodies.back().name;
  pair.restitution = dice.of(std::array{0.0, 0.5, 1.0}), pair.friction = dice.of(std::array{0.0, 0.5});
  scene.materials.push_back(pair);
}

void make_points_and_parts(Dice& dice, Scene& scene) {
  add_material(dice, scene);
  const bool falls = dice.one_in(2);
  if (falls) scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}}), add_floor(dice, scene);
  const std::size_t count = 1 + dice.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i);
    Body& body = add(dice, scene, shape_of_points_or_parts(dice), Vector3(cell * x, falls ? 1.2 : 0, 0));
    set_moving(dice, body, 1, 5);
    if (!falls) body.initial.velocity += Vector3(2 - 2 * x, 0, 0);
  }
}

void make_bath(Dice& dice, Scene& scene) {
  scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}});
  core::Water water;
  water.buoyancy = dice.between(20, 200), water.drag = dice.between(0, 3);
  if (dice.one_in(2)) water.wave = dice.between(0.02, 0.2), water.speed = dice.between(0.5, 4);
  scene.forces.emplace_back(water);
  const std::size_t count = 1 + dice.below(3);
  for (std::size_t i = 0; i < count; ++i) {
    const Shape shape = dice.one_in(3) ? shape_of_points_or_parts(dice) : some_shape(dice);
    const double mass = mass_for(dice, shape);
    Body& body =
        add_body(scene, shape, mass, Vector3(2 * static_cast<double>(i), dice.between(-0.6, 0.6), 0));
    set_moving(dice, body, 1, 2);
  }
}

void set_far_from_one(Dice& dice, Trial& trial) {
  const bool restatable = std::ranges::all_of(core::broken_by(trial.scene),
                                              [](const core::Broken& one) { return !one.restatement; });
  const int size = dice.of(std::array{-5, -4, -3, 3, 4, 5}), mass = dice.of(std::array{-20, -10, 0, 10, 20});
  const double step = dice.of(std::array{1.0, 1.0, 0.1, 1.0 / 0.6});
  trial.step *= step;
  if (!restatable) return;
  study::Restatement change;
  change.length = std::ldexp(1, 2 * size), change.time = std::ldexp(1, size),
  change.mass = std::ldexp(1, mass);
  trial.scene = change(trial.scene);
  trial.step *= change.time;
}

}  // namespace cylon::hunt
