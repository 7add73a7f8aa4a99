// Bodies on joints to the world in general places, with what acts along the joints.
#pragma once

#include "tests/reference/exact/random_scenes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

namespace cylon::exact {

/// The laws along a coordinate that the tests go through.
inline const char* const jointed_laws[] = {
    "nothing", "force",        "under",  "critical", "over",         "driven",          "resonant",
    "bounces", "bounces_down", "buffer", "plastic",  "slides_stops", "friction_spring", "friction_stops"};

class JointedScenes {
 public:
  explicit JointedScenes(unsigned seed) : random_(seed) {}

  /// One body on a joint of that kind with that law along each of its coordinates; gravity may point anywhere that
  /// leaves the coordinates uncoupled.
  core::Scene scene(core::JointType type, const std::string& law) {
    const core::JointKind& kind = core::kind_of(type);
    core::Scene s;
    s.bodies.push_back(random_.body({between(0.5, 0.7), between(0.75, 0.95), between(1, 1.2)}));
    core::Body& body = s.bodies.back();
    core::Joint joint;
    joint.type = type;
    joint.body = 0;
    joint.axis = random_.rotation() * core::Vector3::UnitX();
    if (kind.has_second_axis()) joint.axis_2 = joint.axis.unitOrthogonal();
    if (kind.screws) joint.pitch = between(0, 1) < 0.5 ? between(0.2, 0.6) : -between(0.2, 0.6);

    // Off the axis in half of the scenes, and gravity along it then.
    const bool off = !kind.has_second_axis() && (kind.angles() == 0 || between(0, 1) < 0.5);
    const core::Vector3 arm = off ? random_.vector(0.8) : core::Vector3(joint.axis * between(-0.8, 0.8));
    joint.point = body.initial.position - arm;
    const bool along = kind.angles() > 0 && off;
    s.forces.emplace_back(
        core::UniformGravity{along ? core::Vector3(joint.axis * between(-6, 6)) : random_.vector(4)});

    body.initial.velocity.setZero(), body.initial.angular_velocity.setZero();
    const core::Vector3 across = joint.axis_2 ? joint.axis.cross(*joint.axis_2) : core::Vector3::Zero();
    for (int i = 0; i < kind.displacements(); ++i) {
      const double rate = speed();
      body.initial.velocity += rate * (!joint.axis_2 ? joint.axis : i == 0 ? *joint.axis_2 : across);
      joint.displacements.emplace_back(coordinate(law, body.mass));
      joint.displacements.back().which = i == 0 ? core::Ordinal::first : core::Ordinal::second;
    }
    if (kind.angles() > 0) {
      const double rate = speed();
      body.initial.angular_velocity = rate * joint.axis;
      body.initial.velocity += rate * (joint.axis.cross(arm) + joint.pitch * joint.axis);
      const core::Vector3 own = body.initial.orientation.conjugate() * joint.axis;
      joint.angles.emplace_back(
          coordinate(law, own.dot(body.inertia * own) +
                              body.mass * (joint.axis.cross(arm).squaredNorm() + joint.pitch * joint.pitch)));
    }
    s.joints.push_back(joint);
    return s;
  }

 private:
  double between(double low, double high) { return random_.between(low, high); }
  double speed() { return between(0, 1) < 0.5 ? between(0.8, 2) : -between(0.8, 2); }

  // In units in which the inertia is 1: forces are accelerations.
  struct Coordinate : core::JointDisplacement, core::JointAngle {
    explicit Coordinate(const core::JointCoordinate& c) : JointDisplacement{c}, JointAngle{c} {}
  };
  Coordinate coordinate(const std::string& law, double inertia) {
    core::JointCoordinate c;
    if (law == "nothing") return Coordinate(c);
    c.start = between(-0.4, 0.4);
    c.force = between(-2, 2);
    const auto stops = [&](double restitution) {
      c.lower = c.start - between(0.2, 0.6), c.upper = c.start + between(0.2, 0.6);
      c.restitution = restitution;
    };
    const auto spring = [&](double rate, double ratio) {
      c.stiffness = rate * rate, c.damping = 2 * ratio * rate;
      c.target = between(-0.5, 0.5);
    };
    if (law == "under") spring(between(3, 9), between(0.05, 0.3));
    if (law == "critical") spring(between(3, 9), 1);
    if (law == "over") spring(between(2, 4), between(1.5, 4));
    if (law == "driven" || law == "resonant") {
      // Less than half a turn: a state does not tell more.
      spring(between(3, 6), law == "driven" ? between(0.05, 0.3) : 0);
      c.target_amplitude = between(0.05, 0.15);
      c.target_frequency = law == "driven" ? between(1, 9) : std::sqrt(c.stiffness);
      c.target_phase = between(-3, 3);
    }
    if (law == "bounces") stops(1), c.force = 0;
    if (law == "bounces_down") stops(between(0.9, 0.98));
    if (law == "buffer") {  // at rest between the stops
      stops(between(0.5, 0.9));
      spring(between(8, 10), between(0.02, 0.1));
      c.target = c.start;
    }
    if (law == "plastic") stops(0);
    if (law == "slides_stops") c.friction = between(7, 9);
    if (law == "friction_spring") spring(between(5, 9), between(0, 0.1)), c.friction = between(2, 6);
    if (law == "friction_stops") stops(between(0.8, 1)), c.friction = between(0.2, 1);
    for (double* number : {&c.force, &c.stiffness, &c.damping, &c.friction}) *number *= inertia;
    return Coordinate(c);
  }

  RandomScenes random_;
};

}  // namespace cylon::exact
