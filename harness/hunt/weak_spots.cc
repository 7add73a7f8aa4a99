#include "harness/hunt/weak_spots.h"

#include "harness/hunt/pieces.h"

#include <array>
#include <cmath>

namespace cylon::hunt {
namespace {

using core::Body;
using core::Scene;
using core::Vector3;

constexpr double g = 9.81;  // [m/s^2]

void add_level_floor(Scene& scene) {
  scene.forces.emplace_back(core::UniformGravity{{0, -g, 0}});
  core::Plane floor;
  floor.name = "floor";
  scene.planes.push_back(floor);
}

void add_pair_of_all(Scene& scene, double restitution, double friction) {
  scene.materials.push_back(core::Material{{"*", "*"}, restitution, friction});
}

}  // namespace

// Of a ball no torque turns the axis, so that only the turn of a step is asked.  The middle axis is the unstable one: what a
// gyroscopic term gains or loses shows within few turns.
void make_spin(Dice& dice, Scene& scene) {
  if (dice.one_in(2)) {
    Body& ball = add_body(scene, core::Sphere{dice.between(0.1, 0.4)}, some_mass(dice), Vector3::Zero());
    ball.initial.angular_velocity = dice.vector(100);
    return;
  }
  const core::Box box{{dice.between(0.1, 0.15), dice.between(0.2, 0.25), dice.between(0.3, 0.4)}};
  Body& body = add_body(scene, box, dice.between(0.5, 3), Vector3::Zero());
  body.initial.angular_velocity = Vector3(0, dice.between(10, 100), 0) + dice.vector(5);
}

// The blow comes within 0.2 s, and the next one later than that.
void make_drop(Dice& dice, Scene& scene) {
  add_pair_of_all(scene, dice.of(std::array{0.0, 0.3, 0.5, 0.8, 0.9, 1.0}), 0);
  add_level_floor(scene);
  const double radius = dice.between(0.1, 0.5);
  Body& ball =
      add_body(scene, core::Sphere{radius}, some_mass(dice), Vector3(0, radius + dice.between(0.05, 0.3), 0));
  ball.initial.velocity = Vector3(0, -dice.between(0.5, 5), 0);
  ball.collide = true;
}

// They meet after some tenths of a second, half a radius or less beside their centres.
void make_blow(Dice& dice, Scene& scene) {
  add_pair_of_all(scene, dice.of(std::array{0.0, 0.5, 1.0, 1.0}), 0);
  const double radius = dice.between(0.1, 0.5), mass = dice.between(0.5, 3), speed = dice.between(1, 8);
  Body& first = add_body(scene, core::Sphere{radius}, mass, Vector3::Zero());
  first.initial.velocity = dice.vector(0.5);
  first.collide = true;
  const double way = 2 * radius + 0.1 * speed;
  const Vector3 aside(0, radius * dice.between(-0.4, 0.4), radius * dice.between(-0.4, 0.4));
  Body& second = add_body(scene, core::Sphere{radius}, mass * dice.of(std::array{0.3, 1.0, 3.0, 5.0, 7.0}),
                          Vector3(way, 0, 0) + aside);
  second.initial.velocity = Vector3(-speed, 0, 0);
  second.collide = true;
}

// Flat enough not to tip (friction times the height of its centre, against half its width).
void make_slide(Dice& dice, Scene& scene) {
  add_pair_of_all(scene, 0, dice.of(std::array{0.1, 0.2, 0.5, 0.8}));
  add_level_floor(scene);
  const core::Box box{{dice.between(0.2, 0.5), dice.between(0.05, 0.15), dice.between(0.2, 0.5)}};
  Body& body = add_body(scene, box, some_mass(dice), Vector3(0, box.half_extents.y(), 0));
  body.initial.velocity = Vector3(dice.between(-3, 3), 0, dice.between(-3, 3));
  body.collide = true;
}

void make_tower(Dice& dice, Scene& scene) {
  add_pair_of_all(scene, 0, dice.of(std::array{0.5, 1.0}));
  add_level_floor(scene);
  const std::size_t count = 2 + dice.below(9);
  const double half = dice.between(0.2, 0.5), mass = dice.between(0.5, 3);
  for (std::size_t i = 0; i < count; ++i)
    add_body(scene, core::Box{Vector3::Constant(half)}, mass,
             Vector3(0, (2 * static_cast<double>(i) + 1) * half, 0))
        .collide = true;
  if (!dice.one_in(3)) return;
  Body& top = scene.bodies.back();
  const double times = dice.of(std::array{10.0, 100.0, 1000.0});
  top.mass *= times, top.inertia *= times;
}

void make_cradle(Dice& dice, Scene& scene) {
  add_pair_of_all(scene, dice.of(std::array{0.0, 0.5, 1.0}), 0);
  const std::size_t count = 2 + dice.below(4);
  const double radius = dice.of(std::array{0.125, 0.25, 0.5}), mass = dice.between(0.5, 3);
  for (std::size_t i = 0; i < count; ++i) {
    const double gap = i == 0 ? 0.5 : 0;
    Body& ball =
        add_body(scene, core::Sphere{radius}, mass, Vector3(2 * radius * static_cast<double>(i) - gap, 0, 0));
    ball.collide = true;
    if (i == 0) ball.initial.velocity = Vector3(dice.between(1, 4), 0, 0);
  }
}

}  // namespace cylon::hunt
