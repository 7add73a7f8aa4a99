#include "harness/hunt/generator.h"

#include "harness/hunt/dice.h"
#include "harness/hunt/pieces.h"
#include "harness/hunt/unusual.h"
#include "harness/hunt/weak_spots.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace cylon::hunt {
namespace {

using core::Body;
using core::Scene;
using core::Shape;
using core::Vector3;

void flight(Dice& dice, Scene& scene) {
  maybe_gravity(dice, scene);
  const std::size_t count = 1 + dice.below(3);
  for (std::size_t i = 0; i < count; ++i)
    set_moving(dice, add_body(scene, some_shape(dice), some_mass(dice), dice.vector(3)), 4,
               dice.one_in(3) ? 40 : 6);
  if (dice.one_in(3)) scene.forces.emplace_back(core::Drag{0, dice.between(0, 1), dice.between(0, 0.05), 0});
  if (dice.one_in(4)) scene.forces.emplace_back(core::Drive{0, dice.vector(5), dice.between(1, 10)});
  if (dice.one_in(4)) {
    core::Thrust thrust;
    thrust.force = dice.vector(5);
    if (dice.one_in(3)) {
      thrust.mass_rate = dice.between(-0.04, 0.04) * scene.bodies[0].mass;  // 20 s at most
      (dice.one_in(2) ? thrust.exhaust_velocity : thrust.exchanged_velocity) = dice.vector(3);
    }
    scene.forces.emplace_back(thrust);
  }
  if (dice.one_in(8)) scene.bodies.back().gravity = dice.vector(10);
  if (count > 1 && dice.one_in(3)) scene.forces.emplace_back(core::Attraction{0, 1, dice.between(0.1, 3)});
}

// Seen from a frame that turns or accelerates, mostly unevenly.
void frames(Dice& dice, Scene& scene) {
  flight(dice, scene);
  core::Frame& frame = scene.frame.emplace();
  frame.velocity = dice.vector(2);
  if (!dice.one_in(4)) frame.angular_velocity = dice.vector(1.5);
  if (dice.one_in(2)) frame.angular_acceleration = dice.vector(1);
  if (dice.one_in(2)) frame.acceleration = dice.vector(4);
  if (dice.one_in(2)) frame.frequency = dice.between(1, 8);
}

void springs(Dice& dice, Scene& scene) {
  maybe_gravity(dice, scene);
  const std::size_t count = 1 + dice.below(4);
  for (std::size_t i = 0; i < count; ++i) {
    Body& body =
        add_body(scene, some_shape(dice), some_mass(dice), Vector3(1.5 * static_cast<double>(i), 0, 0));
    set_moving(dice, body, 1, 4);
    core::Spring spring;
    spring.body = static_cast<int>(i);
    if (dice.one_in(2)) spring.anchor = dice.vector(0.2);
    if (i > 0 && !dice.one_in(4)) {
      spring.to = static_cast<int>(i) - 1;
    } else {
      spring.to_anchor = body.initial.position + dice.vector(1);
    }
    spring.stiffness = dice.between(5, 60) * body.mass;
    if (dice.one_in(2)) spring.rest_length = dice.between(0.2, 1.5);
    if (dice.one_in(3)) spring.damping = dice.between(0.1, 2) * body.mass;
    scene.forces.emplace_back(spring);
  }
}

// What acts along a free coordinate that has so much inertia [kg, kg m^2]: a spring, a damper, a motor, a servo; now and
// then stops or dry friction.
template <class Coordinate>
Coordinate some_law(Dice& dice, double inertia) {
  Coordinate c;
  if (dice.one_in(8)) {
    c.lower = dice.between(-0.6, -0.1), c.upper = dice.between(0.1, 0.6);
    c.restitution = dice.of(std::array{0.0, 0.5, 1.0});
  }
  if (dice.one_in(8)) c.friction = dice.between(0.1, 1) * inertia;
  if (dice.one_in(3)) c.force = dice.between(-3, 3) * inertia;
  if (dice.one_in(3)) c.damping = dice.between(0.1, 2) * inertia;
  if (!dice.one_in(3)) {
    c.stiffness = dice.between(5, 60) * inertia;
    c.target = dice.between(-0.3, 0.3);
    if (dice.one_in(2)) c.target_amplitude = dice.between(0.1, 0.4), c.target_frequency = dice.between(1, 6);
  }
  return c;
}

void add_laws(Dice& dice, const Body& body, core::Joint& joint) {
  const core::JointKind& kind = core::kind_of(joint.type);
  const double arm = (joint.point - body.initial.position).norm();
  if (kind.displacements() > 0 && dice.one_in(2))
    joint.displacements.push_back(some_law<core::JointDisplacement>(dice, body.mass));
  if (kind.angles() > 0 && dice.one_in(2))
    joint.angles.push_back(some_law<core::JointAngle>(dice, body.mass * (arm * arm + 0.01)));
}

// A tree of bodies at rest, each with a joint to an earlier one or to the world half a link before it.
void tree(Dice& dice, Scene& scene, std::size_t kinds, bool laws) {
  maybe_gravity(dice, scene);
  const std::size_t count = 1 + dice.below(4);
  const bool floats = count > 1 && dice.one_in(3);
  for (std::size_t i = 0; i < count; ++i) {
    const int parent = i == 0 ? core::world : static_cast<int>(dice.one_in(3) ? dice.below(i) : i - 1);
    const Vector3 from = parent == core::world
                             ? Vector3::Zero().eval()
                             : scene.bodies[static_cast<std::size_t>(parent)].initial.position;
    Body& body = add_body(scene, some_shape(dice), some_mass(dice), from + dice.direction());
    body.initial.orientation = dice.turn();
    if (i == 0 && floats) {
      body.initial.velocity = dice.vector(1);
      continue;
    }
    if (floats) body.initial.velocity = scene.bodies[0].initial.velocity;
    core::Joint joint;
    joint.type = core::joint_kinds[dice.below(kinds)].type;
    joint.body = static_cast<int>(i), joint.to = parent;
    joint.point = (from + body.initial.position) / 2;
    joint.axis = dice.direction();
    const core::JointKind& kind = core::kind_of(joint.type);
    if (kind.joins_centres())
      joint.length = (body.initial.position - (parent == core::world ? joint.point : from)).norm();
    if (kind.has_second_axis()) joint.axis_2 = joint.axis.unitOrthogonal();
    if (kind.place == core::JointPlace::along_normal) joint.length = dice.between(0.05, 0.3);
    if (kind.screws) joint.pitch = (dice.one_in(2) ? 1 : -1) * dice.between(0.05, 0.3);
    if (joint.type == core::JointType::fixed && parent == core::world && count == 1)
      joint.type = core::JointType::hinge;  // else nothing moves
    if (laws) add_laws(dice, body, joint);
    scene.joints.push_back(joint);
  }
}

void mechanism(Dice& dice, Scene& scene) {
  constexpr std::size_t kinds = 4;  // ball, hinge, distance, fixed: what every engine is asked about
  tree(dice, scene, kinds, false);
}

void machine(Dice& dice, Scene& scene) { tree(dice, scene, core::joint_kinds.size(), true); }

// Groups at random: some bodies pass through each other, and through the floor.  A mask names groups that are there.
void filter(Dice& dice, Scene& scene) {
  std::vector<std::string> there;
  const auto each = [&](const auto& what) {
    for (Body& body : scene.bodies) what(body.collision_groups, body.collision_mask);
    for (core::Plane& plane : scene.planes) what(plane.collision_groups, plane.collision_mask);
  };
  each([&](auto& groups, auto&) {
    there.emplace_back(dice.of(std::array<const char*, 3>{"one", "two", "default"}));
    groups = {there.back()};
  });
  each([&](auto&, auto& mask) {
    if (dice.one_in(2)) mask = {there[dice.below(there.size())]};
  });
}

// Bodies that fly at each other, or onto a plane.  Cells 1.5 m apart keep them from overlapping.
void collisions(Dice& dice, Scene& scene, const Shape (*shape)(Dice&)) {
  add_material(dice, scene);
  const bool falls = !dice.one_in(3);
  if (falls) scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}}), add_floor(dice, scene);
  const std::size_t count = 1 + dice.below(4) + (falls ? 0 : 1);
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t column = i % 2, row = i / 2;
    const double x = static_cast<double>(column), z = static_cast<double>(row);
    Body& body = add_body(scene, shape(dice), some_mass(dice),
                          Vector3(1.5 * x, 1.5 + dice.between(-0.2, 0.2), 1.5 * z));
    set_moving(dice, body, 1, 5);
    body.collide = true;
    if (count > 1) body.initial.velocity += Vector3(1.5 - 3 * x, 0, 1.5 - 3 * z);
  }
  if (dice.one_in(5)) filter(dice, scene);
  if (dice.one_in(6)) scene.forces.emplace_back(core::Drag{0, dice.between(0, 1), dice.between(0, 0.05), 0});
}

void spheres(Dice& dice, Scene& scene) {
  collisions(dice, scene, [](Dice& d) -> const Shape { return core::Sphere{d.between(0.1, 0.4)}; });
}

void solids(Dice& dice, Scene& scene) {
  collisions(dice, scene, [](Dice& d) -> const Shape { return some_shape(d); });
}

// Boxes that stand on a floor, also on each other; with luck one slides.
void standing(Dice& dice, Scene& scene) {
  add_material(dice, scene);
  scene.materials[0].friction = dice.of(std::array{0.2, 0.5, 1.0});
  scene.forces.emplace_back(core::UniformGravity{{0, -9.81, 0}});
  core::Plane floor;
  floor.name = "floor";
  scene.planes.push_back(floor);
  const std::size_t count = 1 + dice.below(4);
  double height = 0, x = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const core::Box box{{dice.between(0.2, 0.5), dice.between(0.1, 0.4), dice.between(0.2, 0.5)}};
    if (i > 0 && dice.one_in(3)) height = 0, x += 2;
    Body& body = add_body(scene, box, some_mass(dice), Vector3(x, height + box.half_extents.y(), 0));
    body.collide = true;
    height += 2 * box.half_extents.y();
    if (count == 1 && dice.one_in(2))
      body.initial.velocity = Vector3(dice.between(0.5, 3), 0, dice.between(-1, 1));
  }
}

constexpr std::array all = {
    Family{"flight", "free bodies, with drag, drives, thrust, mass that changes and attraction", 3, 8,
           flight},
    Family{"spin", "one free body that spins fast", 2, 2, make_spin},
    Family{"frames", "the same as flight, seen from a frame that turns or accelerates", 2, 0, frames},
    Family{"springs", "chains of springs", 3, 0, springs},
    Family{"mechanism", "trees of joints", 4, 0, mechanism},
    Family{"machine",
           "trees of all kinds of joints, with springs, dampers, motors, servos, stops and friction", 3, 0,
           machine},
    Family{"spheres", "spheres that collide", 2, 0, spheres},
    Family{"drop", "one ball that falls onto a plane", 1, 0, make_drop},
    Family{"blow", "two balls that hit each other", 1, 0, make_blow},
    Family{"solids", "solids that collide", 3, 0, solids},
    Family{"standing", "boxes that stand, lie on each other or slide", 2, 0, standing},
    Family{"slide", "one box that slides", 1, 0, make_slide},
    Family{"tower", "equal cubes on each other, now and then under a heavy one", 1, 0, make_tower},
    Family{"cradle", "balls in a row that touch, and one that hits them", 1, 0, make_cradle},
    Family{"furniture", "solids that fall onto locked ones, one pair with a material of its own", 1, 0,
           make_furniture, true},
    Family{"points and parts", "hulls and compounds that fly, spin and hit", 1, 0, make_points_and_parts,
           true},
    Family{"bath", "solids in water", 1, 0, make_bath, true},
};

// One of the families that are unusual, or are not, as often as its weight says.
const Family& some_family(Dice& dice, bool unusual) {
  int sum = 0;
  for (const Family& family : all) sum += family.unusual == unusual ? family.weight : 0;
  auto pick = static_cast<int>(dice.below(static_cast<std::size_t>(sum)));
  for (const Family& family : all) {
    if (family.unusual != unusual) continue;
    if (pick < family.weight) return family;
    pick -= family.weight;
  }
  return all.back();
}

}  // namespace

std::span<const Family> families() { return all; }

Generated generate(std::uint64_t seed, std::uint64_t n) {
  Dice dice(seed, n);
  // By the number, so that the other scenes of a seed stay what they were.
  const bool unusual = n % 16 == 4, far_from_one = n % 16 == 12;
  const Family& family = some_family(dice, unusual);
  Generated made{{}, std::string(family.name)};
  family.make(dice, made.trial.scene);
  made.trial.step = dice.of(std::array{0.02, 0.01, 0.01, 0.005});
  made.trial.steps = dice.of(std::array<std::int64_t, 3>{40, 60, 100});
  if (family.long_runs > 0 && dice.one_in(family.long_runs)) made.trial.steps = 1000;
  if (far_from_one) set_far_from_one(dice, made.trial);
  return made;
}

}  // namespace cylon::hunt
