#include "harness/hunt/pieces.h"

#include "harness/core/solid.h"

#include <fmt/format.h>

#include <array>

namespace cylon::hunt {

using core::Body;
using core::Scene;
using core::Shape;
using core::Vector3;

Shape some_shape(Dice& dice) {
  const double r = dice.between(0.1, 0.4);
  switch (dice.below(6)) {
    case 0:
      return core::Capsule{r / 2, r};
    case 1:
      return core::Cylinder{r / 2, r};
    case 2:
      return core::Cone{r / 2, r};
    case 3:
      return core::Sphere{r};
    default:
      return core::Box{{r, dice.between(0.1, 0.4), dice.between(0.1, 0.4)}};
  }
}

Body& add_body(Scene& scene, const Shape& shape, double mass, const Vector3& place) {
  Body body;
  body.name = fmt::format("b{}", scene.bodies.size() + 1);
  body.mass = mass, body.shape = shape;
  body.inertia = core::mass_properties(shape, mass).inertia;
  body.initial.position = place;
  return scene.bodies.emplace_back(body);
}

double some_mass(Dice& dice) {
  const double mass = dice.between(0.5, 3);
  return dice.one_in(6) ? mass * dice.of(std::array{0.01, 0.1, 10.0, 100.0, 1000.0}) : mass;
}

void set_moving(Dice& dice, Body& body, double speed, double spin) {
  body.initial.orientation = dice.turn();
  body.initial.velocity = dice.vector(speed);
  body.initial.angular_velocity = dice.vector(spin);
}

void maybe_gravity(Dice& dice, Scene& scene) {
  if (dice.one_in(4)) return;
  scene.forces.emplace_back(core::UniformGravity{dice.one_in(4) ? dice.vector(10) : Vector3(0, -9.81, 0)});
}

void add_material(Dice& dice, Scene& scene) {
  core::Material all;
  all.between[0] = all.between[1] = "*";
  all.restitution = dice.of(std::array{0.0, 0.0, 0.3, 0.5, 0.9, 1.0});
  all.friction = dice.of(std::array{0.0, 0.2, 0.5, 1.0});
  scene.materials.push_back(all);
}

void add_floor(Dice& dice, Scene& scene) {
  core::Plane floor;
  floor.name = "floor";
  if (dice.one_in(4)) floor.normal = (Vector3::UnitY() + 0.3 * dice.direction()).normalized();
  scene.planes.push_back(floor);
}

}  // namespace cylon::hunt
