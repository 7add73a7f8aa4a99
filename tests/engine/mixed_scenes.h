// Random models that mix features: forces, joints, shapes, contacts, changing masses, frames.  A model is
// made of its number alone, so that a number in a message is the model.
#pragma once

#include "engine/features.h"
#include "engine/geometry/hull.h"
#include "engine/methods.h"
#include "tests/engine/joint_scenes.h"

#include <cstdint>
#include <random>

namespace cylon::engine {

/// Numbers that do not depend on the standard library's distributions.
class Dice {
 public:
  explicit Dice(std::uint32_t seed) : random_(seed) {}
  Real between(Real low, Real high) {
    return low + (high - low) * static_cast<Real>(static_cast<double>(random_()) / 4294967296.0);
  }
  bool one_in(std::uint32_t n) { return random_() % n == 0; }
  std::size_t below(std::size_t n) { return random_() % n; }
  Vector3 vector(Real size) { return {between(-size, size), between(-size, size), between(-size, size)}; }

 private:
  std::mt19937 random_;
};

enum class Surface {
  none,  ///< Nothing can touch.
  far,   ///< A plane far below: contacts are possible and never come.
  near   ///< A plane that is met.
};

struct MixedScene {
  Model model;
  Surface surface = Surface::none;
  std::string text;  ///< What is in it.
};

namespace mixed {

inline Shape shape(Dice& dice) {
  const Real r = dice.between(0.15, 0.3);
  switch (dice.below(4)) {
    case 0:
      return Sphere{r};
    case 1:
      return Box{{r, Real(0.8) * r, Real(0.6) * r}};
    case 2:
      return Capsule{Real(0.5) * r, Real(0.6) * r};
    default:
      return make_hull({{r, -r, -r}, {-r, -r, Real(-0.9) * r}, {0, -r, r}, {Real(0.1) * r, r, 0}});
  }
}

inline Matrix3 inertia(Dice& dice, Real mass, const Shape& s) {
  if (const auto* sphere = std::get_if<Sphere>(&s))
    return Matrix3::Identity() * (Real(0.4) * mass * sphere->radius * sphere->radius);
  const Real i = Real(0.02) * mass;
  return general_inertia(dice.between(1, Real(1.2)) * i, dice.between(Real(1.2), Real(1.5)) * i,
                         dice.between(Real(1.5), Real(1.9)) * i);
}

inline void add_forces(Dice& dice, Model& m, std::string& text) {
  const int n = static_cast<int>(m.bodies.size());
  const auto some_body = [&] { return static_cast<int>(dice.below(static_cast<std::size_t>(n))); };
  const auto other = [&](int body) {
    return n == 1 || dice.one_in(2)
               ? fixed_world
               : (body + 1 + static_cast<int>(dice.below(static_cast<std::size_t>(n - 1)))) % n;
  };
  if (!dice.one_in(4))
    m.forces.gravity = {dice.between(-1, 1), dice.between(-9, -3), dice.between(-1, 1)}, text += " gravity";
  if (dice.one_in(4)) {
    const int a = some_body(), b = other(a);
    Spring s{a,
             Vector3::Zero(),
             b,
             Vector3::Zero(),
             dice.between(1, 20),
             dice.one_in(2) ? dice.between(Real(0.2), 1) : 0,
             0};
    if (dice.one_in(2)) s.anchor = dice.vector(Real(0.2));
    s.to_anchor = b == fixed_world ? Vector3(dice.vector(2))
                  : dice.one_in(2) ? Vector3(dice.vector(Real(0.2)))
                                   : Vector3(Vector3::Zero());
    if (dice.one_in(3)) s.damping = dice.between(Real(0.1), 1);
    m.forces.springs.push_back(s);
    text += s.damping != 0 ? " damped spring" : " spring";
  }
  if (dice.one_in(5)) {
    m.forces.drags.push_back({some_body(), dice.between(Real(0.05), 1),
                              dice.one_in(2) ? dice.between(Real(0.001), Real(0.01)) : 0,
                              dice.one_in(2) ? dice.between(Real(0.05), Real(0.5)) : 0});
    text += " drag";
  }
  if (dice.one_in(5)) {
    m.forces.thrusts.push_back({.body = some_body(), .force = dice.vector(5)});
    text += " thrust";
  }
  if (dice.one_in(5)) {
    const int body = some_body();
    const Real rate = dice.between(Real(-0.2), Real(0.3)) * m.bodies[static_cast<std::size_t>(body)].mass;
    m.forces.thrusts.push_back(
        {.body = body, .mass_rate = rate, .relative = dice.one_in(2), .exchanged = dice.vector(8)});
    m.bodies[static_cast<std::size_t>(body)].mass_rate = rate;
    text += " changing mass";
  }
  if (dice.one_in(5)) {
    m.forces.drives.push_back({some_body(), dice.vector(4), dice.between(1, 9)});
    text += " drive";
  }
  if (n > 1 && dice.one_in(4)) {
    const int a = some_body();
    m.forces.attractions.push_back({a, (a + 1) % n, dice.between(-1, 2)});
    text += " attraction";
  }
  if (dice.one_in(8)) {
    Water w{.level = dice.between(-1, 1),
            .wave = dice.one_in(2) ? Real(0.1) : 0,
            .speed = 2,
            .buoyancy = dice.between(50, 200),
            .drag = dice.one_in(2) ? dice.between(Real(0.1), 1) : 0};
    w.shapes = m.shapes;
    m.forces.waters.push_back(w);
    text += " water";
  }
}

// A spring, damping, dry friction, limits and a rotor, each of them or not, on a coordinate that the joint leaves free.
inline void add_law(Dice& dice, Model& m, std::string& text) {
  const Joint& joint = m.joints.back();
  const bool turns =
                 joint.type.turn == Joint::Turn::about_axis || joint.type.turn == Joint::Turn::about_two_axes,
             slides =
                 joint.type.place == Joint::Place::along_axis || joint.type.place == Joint::Place::in_plane;
  const bool gimbal = joint.type == joint_types::gimbal;
  if (!turns && !slides && !gimbal) return;
  CoordinateLaw law;
  law.at.kind = turns && (!slides || joint.type.couples || dice.one_in(2)) ? Coordinate::Kind::angle
                                                                           : Coordinate::Kind::displacement;
  const bool angle = law.at.kind == Coordinate::Kind::angle;
  law.at.body = joint.body, law.at.anchor = joint.anchor;
  law.at.to = joint.to, law.at.to_anchor = joint.to_anchor;
  law.at.axis = joint.type.place == Joint::Place::in_plane && !angle ? Vector3(joint.to_axis.unitOrthogonal())
                                                                     : joint.to_axis;
  law.at.zero = joint.to_axis.unitOrthogonal();
  law.at.mark = joint.relative.conjugate() * law.at.zero;
  if (joint.type.turn == Joint::Turn::about_two_axes)  // the other axis, which stays square to the first
    law.at.mark = joint.axis, law.at.zero = joint.relative * joint.axis;
  if (gimbal) law.at = gimbal_angles(m, joint)[dice.below(3)];
  if (dice.one_in(4)) law.armature = dice.between(Real(0.01), Real(0.5));
  if (dice.one_in(2)) law.stiffness = dice.between(Real(0.2), 4), law.target.value = dice.between(-1, 1);
  if (dice.one_in(2)) law.damping = dice.between(Real(0.01), Real(0.2));
  if (dice.one_in(3)) law.friction = dice.between(Real(0.02), Real(0.6));
  if (dice.one_in(2)) {
    law.lower = dice.between(Real(-0.6), Real(-0.05)), law.upper = dice.between(Real(0.05), Real(0.6));
    law.restitution = dice.one_in(3) ? 0 : dice.between(Real(0.2), 1);
  }
  text += law.at.is_angle() ? " law on an angle" : " law on a displacement";
  if (law.armature != 0) text += ", a rotor";
  if (law.friction != 0) text += ", rubbing";
  if (law.is_limited()) text += ", limited";
  m.forces.coordinate_laws.push_back(law);
}

// Joints that the start satisfies: they close where the bodies are, and jointed scenes start at rest.
inline void add_joints(Dice& dice, Model& m, std::string& text) {
  const std::size_t n = m.bodies.size(), count = 1 + dice.below(2);
  for (std::size_t k = 0; k < count && k < n; ++k) {
    const int body = static_cast<int>(k), to = k + 1 < n && dice.one_in(2) ? body + 1 : fixed_world;
    constexpr Joint::Type types[] = {
        joint_types::ball,   joint_types::hinge,       joint_types::distance,
        joint_types::fixed,  joint_types::slider,      joint_types::cylindrical,
        joint_types::planar, joint_types::universal,   joint_types::screw,
        joint_types::gimbal, joint_types::rectangular, joint_types::offset_universal};
    const std::size_t kind = dice.below(std::size(types));
    const Joint::Type type = types[kind];
    const auto turn = [&](int i) {
      return i == fixed_world ? Quaternion(Quaternion::Identity())
                              : m.motions[static_cast<std::size_t>(i)].orientation;
    };
    const auto place = [&](int i) {
      return i == fixed_world ? Vector3(Vector3::Zero()) : m.motions[static_cast<std::size_t>(i)].position;
    };
    const Vector3 point = to == fixed_world ? Vector3(place(body) + dice.vector(Real(0.4)))
                                            : Vector3((place(body) + place(to)) / 2 + dice.vector(Real(0.2)));
    Joint joint{.type = type, .body = body, .to = to};
    if (type == joint_types::distance) {
      joint.to_anchor = to == fixed_world ? Vector3(place(body) + Vector3(Real(0.3), Real(0.7), Real(0.2)))
                                          : Vector3(Vector3::Zero());
      joint.length = (to == fixed_world ? joint.to_anchor : place(to)).operator-(place(body)).norm();
    } else {
      joint.anchor = turn(body).conjugate() * (point - place(body));
      joint.to_anchor = turn(to).conjugate() * (point - place(to));
      const Vector3 axis = Vector3(dice.vector(1) + Vector3(0, 0, 2)).normalized();
      joint.axis = turn(body).conjugate() * axis;
      joint.to_axis = turn(to).conjugate() * axis;
      if (type.turn == Joint::Turn::about_two_axes)
        joint.axis = turn(body).conjugate() * axis.unitOrthogonal();
      if (type.place == Joint::Place::along_normal) {
        joint.length = dice.between(Real(0.05), Real(0.4));
        joint.anchor += turn(body).conjugate() * (joint.length * axis.cross(axis.unitOrthogonal()));
      }
      if (type == joint_types::gimbal)
        joint.axis = turn(body).conjugate() * (Real(0.8) * axis.unitOrthogonal() + Real(0.6) * axis);
      if (type.couples) joint.pitch = dice.between(Real(0.05), Real(0.3));
      joint.relative = turn(to).conjugate() * turn(body);
    }
    m.joints.push_back(joint);
    text += " joint" + std::to_string(kind) + (to == fixed_world ? "w" : "");
    if (dice.one_in(2)) add_law(dice, m, text);
  }
  for (std::size_t i = 0; i < n; ++i)
    m.motions[i].momentum.setZero(), m.motions[i].angular_momentum.setZero();
}

}  // namespace mixed

namespace mixed {

// Two groups, any of which may be in a mask, also none.
inline void add_filters(Dice& dice, Model& m, std::string& text) {
  const auto filter = [&] {
    return Filter{static_cast<std::uint32_t>(1 + dice.below(3)), static_cast<std::uint32_t>(dice.below(4))};
  };
  for (std::size_t i = 0; i < m.bodies.size(); ++i) m.filters.push_back(filter());
  for (std::size_t i = 0; i < m.planes.size(); ++i) m.plane_filters.push_back(filter());
  text += " filters";
  for (const Filter& f : m.filters) text += ' ' + std::to_string(f.groups) + std::to_string(f.mask);
}

}  // namespace mixed

inline MixedScene mixed_scene(std::uint32_t number) {
  Dice dice(number);
  MixedScene scene;
  Model& m = scene.model;
  const std::size_t n = 1 + dice.below(3);
  const bool moves = !dice.one_in(4), spins = dice.one_in(2);
  for (std::size_t i = 0; i < n; ++i) {
    const Real mass = dice.between(Real(0.5), 2);
    const Shape shape = mixed::shape(dice);
    const bool locked = n > 1 && dice.one_in(8);
    if (locked) scene.text += " locked";
    add_body(m, make_body(mass, mixed::inertia(dice, mass, shape), locked),
             {Real(1.6) * static_cast<Real>(i) + dice.between(0, Real(0.3)), dice.between(0, Real(0.3)),
              dice.between(0, Real(0.3))},
             dice.vector(1), moves && !locked ? Vector3(dice.vector(1)) : Vector3(Vector3::Zero()),
             spins && !locked ? Vector3(dice.vector(3)) : Vector3(Vector3::Zero()), shape);
    scene.text += " shape" + std::to_string(shape.index());
  }
  mixed::add_forces(dice, m, scene.text);
  if (dice.one_in(3)) mixed::add_joints(dice, m, scene.text);
  const bool turning = dice.one_in(8);
  if (turning) m.frame = RotatingFrame{dice.vector(Real(0.5))}, scene.text += " frame";
  const std::size_t surface = turning && !dice.one_in(4) ? 3 : dice.below(4);
  scene.surface = surface < 2 ? Surface::far : surface == 2 ? Surface::near : Surface::none;
  if (scene.surface != Surface::none) {
    const bool far = scene.surface == Surface::far;
    m.planes.push_back(
        {Vector3(dice.between(Real(-0.1), Real(0.1)), 1, 0).normalized(), far ? Real(-100) : Real(-0.8)});
    make_touchable(m, dice.one_in(2) ? 0 : dice.between(Real(0.2), Real(0.8)),
                   dice.one_in(2) ? 0 : dice.between(Real(0.1), Real(0.6)));
    // Either one body meets the plane, or all do without friction: a stepped impact with friction takes two
    // steps, and what both leave is not what friction leaves at one instant.
    const bool alone = !far && dice.one_in(2);
    for (std::size_t i = 1; alone && i < n; ++i) m.surfaces[i] = no_surface;
    if (!far && !alone) m.materials[0].friction = 0;
    scene.text += far ? " far plane" : " plane";
    // Not of bodies that attract each other: what nothing keeps apart comes as near as it likes.
    if (m.forces.attractions.empty() && dice.one_in(3)) mixed::add_filters(dice, m, scene.text);
  }
  if (dice.one_in(4)) {
    const std::size_t i = dice.below(n);
    m.bodies[i].gravity = dice.one_in(3) ? Vector3(Vector3::Zero()) : Vector3(dice.vector(9));
    scene.text += " own gravity" + std::to_string(i);
  }
  // As the in-house simulator has it: where something is tied to the frame, the frame's motion is a force.
  constexpr Features ties = {Feature::contact_in_turning_frame, Feature::world_joint_in_turning_frame,
                             Feature::force_in_turning_frame};
  if (m.frame && !(required(m) & ties).empty()) {
    m.forces.frame_forces = {{.angular_velocity = m.frame->angular_velocity}};
    m.frame.reset();
  }
  return scene;
}

/// The largest difference of places, turns and velocities, as parts of the scales of the motion (1 m, 1 rad,
/// 1 m/s at least).
inline Real apart(const std::vector<Body>& bodies, const std::vector<Motion>& a,
                  const std::vector<Motion>& b) {
  Real length = 1, speed = 1, turn = 1, worst = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    length = std::max(length, a[i].position.norm());
    speed = std::max(speed, velocity(bodies[i], a[i]).norm());
    turn = std::max(turn, angular_velocity(bodies[i], a[i]).norm());
  }
  for (std::size_t i = 0; i < a.size(); ++i) {
    const Real d =
        std::max({(a[i].position - b[i].position).norm() / length,
                  (velocity(bodies[i], a[i]) - velocity(bodies[i], b[i])).norm() / speed,
                  angle(a[i].orientation, b[i].orientation),
                  (angular_velocity(bodies[i], a[i]) - angular_velocity(bodies[i], b[i])).norm() / turn});
    if (!(d <= worst)) worst = d;
  }
  return worst;
}

}  // namespace cylon::engine
