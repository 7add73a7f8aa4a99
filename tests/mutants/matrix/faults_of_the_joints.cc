#include "tests/mutants/matrix/decorator.h"

#include "harness/core/joint_coordinates.h"

#include <algorithm>
#include <numbers>

namespace cylon::mutants {
namespace {

using core::Joint;
using core::JointCoordinate;
using core::JointType;
using core::Scene;

Mask scene(std::function<void(Scene&)> change) { return {.scene = std::move(change)}; }

Mask every_coordinate(std::function<void(JointCoordinate&)> change) {
  return scene([change = std::move(change)](Scene& s) {
    for (Joint& joint : s.joints) core::for_each_coordinate(joint, change);
  });
}

Mask every_joint(JointType type, std::function<void(Joint&)> change) {
  return scene([type, change = std::move(change)](Scene& s) {
    for (Joint& joint : s.joints)
      if (joint.type == type) change(joint);
  });
}

void bare(Joint& joint) { joint.displacements.clear(), joint.angles.clear(); }

// A screw of another pitch, whose body starts as that lets it.
Mask pitch_by(double factor) {
  return scene([factor](Scene& s) {
    for (Joint& joint : s.joints) {
      if (joint.type != JointType::screw) continue;
      core::BodyState& b = s.bodies[static_cast<std::size_t>(joint.body)].initial;
      b.velocity += (factor - 1) * joint.pitch * joint.axis.dot(b.angular_velocity) * joint.axis;
      joint.pitch *= factor;
    }
  });
}

}  // namespace

std::vector<MaskedRow> faults_of_the_joints() {
  return {
      {"slider taken for a cylinder", "it keeps its line and may turn about it", "rail_spring",
       "angular_joint_gap",
       every_joint(JointType::slider, [](Joint& joint) { joint.type = JointType::cylindrical; })},
      {"universal taken for a ball", "it may spin", "cardan", "angular_joint_gap",
       every_joint(JointType::universal, [](Joint& joint) { joint.type = JointType::ball, bare(joint); })},
      {"universal without what acts", "no spring and no damper on its axes", "cardan", "position follows",
       every_joint(JointType::universal, bare)},
      {"universal's axes exchanged", "what acts on the one acts on the other", "cardan", "position follows",
       every_joint(JointType::universal,
                   [](Joint& joint) {
                     for (core::JointAngle& c : joint.angles)
                       c.which =
                           c.which == core::Ordinal::first ? core::Ordinal::second : core::Ordinal::first;
                   })},
      {"gimbal's angles counted from the other side", "what acts turns round but between its axes", "gimbal",
       "position follows",
       every_joint(JointType::gimbal,
                   [](Joint& joint) {
                     for (core::JointAngle& c : joint.angles)
                       if (c.which != core::Ordinal::third) core::reverse(c);
                   })},
      {"gimbal's third angle closes", "its force takes the angle between its axes the other way", "gimbal",
       "position follows",
       every_joint(JointType::gimbal,
                   [](Joint& joint) {
                     for (core::JointAngle& c : joint.angles)
                       if (c.which == core::Ordinal::third) core::reverse(c);
                   })},
      {"gimbal's second and third exchanged", "in the order of its turns", "gimbal", "position follows",
       every_joint(JointType::gimbal,
                   [](Joint& joint) {
                     for (core::JointAngle& c : joint.angles)
                       if (c.which != core::Ordinal::first)
                         c.which =
                             c.which == core::Ordinal::second ? core::Ordinal::third : core::Ordinal::second;
                   })},
      {"gimbal's axes taken for square", "its torques act about its axes", "gimbal", "position follows",
       every_joint(JointType::gimbal,
                   [](Joint& joint) {
                     joint.axis_2 = (*joint.axis_2 - joint.axis.dot(*joint.axis_2) * joint.axis).normalized();
                   })},
      {"rotors left out", "the head falls at once", "pan_tilt", "position follows",
       every_coordinate([](JointCoordinate& c) { c.armature = 0; })},
      {"rotors 1 % heavy", "as a rounded gear ratio makes them", "pan_tilt", "position follows",
       every_coordinate([](JointCoordinate& c) { c.armature *= 1.01; })},
      {"rotor of the first hinge alone", "the other's is forgotten", "pan_tilt", "position follows",
       every_joint(JointType::offset_universal,
                   [](Joint& joint) {
                     for (core::JointAngle& c : joint.angles)
                       if (c.which == core::Ordinal::second) c.armature = 0;
                   })},
      {"offset to the other side", "the mount's second hinge lies behind its first", "pan_tilt", "joint_gap",
       every_joint(JointType::offset_universal,
                   [](Joint& joint) {
                     joint.point += 2 * joint.length * joint.axis.cross(*joint.axis_2);
                     joint.axis = -joint.axis;
                     for (core::JointAngle& c : joint.angles)
                       if (c.which == core::Ordinal::first) core::reverse(c);
                   })},
      {"screw of the other hand", "the sign of its pitch", "screw", "position follows", pitch_by(-1)},
      {"screw by the turn", "its pitch is for a turn, not for a radian", "screw", "position follows",
       pitch_by(1 / (2 * std::numbers::pi))},
      {"one stop alone", "the upper one is forgotten", "rail_stops", "position follows",
       every_coordinate([](JointCoordinate& c) { c.upper.reset(); })},
      {"stops mirrored", "their coordinate is counted the other way", "rail_stops", "position follows",
       every_coordinate([](JointCoordinate& c) {
         if (!c.lower || !c.upper) return;
         const double lower = *c.lower;
         c.lower = 2 * c.start - *c.upper, c.upper = 2 * c.start - lower;
       })},
      {"stops counted from zero", "where the joint starts is forgotten", "rail_stops", "position follows",
       every_coordinate([](JointCoordinate& c) { c.start = 0; })},
      {"stops that do not give back", "their restitution is ignored", "rail_stops", "position follows",
       every_coordinate([](JointCoordinate& c) { c.restitution = 0; })},
      {"stops give back 1 % more", "of the rate", "rail_stops", "position follows",
       every_coordinate([](JointCoordinate& c) { c.restitution = std::min(1.0, 1.01 * c.restitution); })},
      {"motor turned round", "its force acts the other way", "rail_spring", "position follows",
       every_coordinate([](JointCoordinate& c) { c.force = -c.force; })},
      {"servo stands still", "its target does not move", "driven_cart", "position follows",
       every_coordinate([](JointCoordinate& c) { c.target_amplitude = 0; })},
      {"servo turned round", "its target moves the other way", "driven_cart", "position follows",
       every_coordinate([](JointCoordinate& c) { c.target_amplitude = -c.target_amplitude; })},
      {"rest value of a joint's spring ignored", "it pulls to zero", "rail_spring", "position follows",
       every_coordinate([](JointCoordinate& c) { c.target = 0; })},
      {"joint's damping ignored", "it swings for ever", "rail_spring", "position follows",
       every_coordinate([](JointCoordinate& c) { c.damping = 0; })},
      {"joint's stiffness off by 1e-5", "as a printed number is", "rail_spring", "theory: position follows",
       every_coordinate([](JointCoordinate& c) { c.stiffness *= 1 + 1e-5; })},
      {"joint's dry friction off", "it glides", "rail_friction", "position follows",
       every_coordinate([](JointCoordinate& c) { c.friction = 0; })},
      {"joint's dry friction 1 % high", "as a rounded number is", "rail_friction", "position follows",
       every_coordinate([](JointCoordinate& c) { c.friction *= 1.01; })},
      {"joint's dry friction as damping", "in proportion to the rate", "rail_friction", "position follows",
       every_coordinate([](JointCoordinate& c) { c.damping += c.friction, c.friction = 0; })},
      {"joint's dry friction feeds", "it pushes along the way", "rail_friction", "energy never rises",
       every_coordinate([](JointCoordinate& c) {
         if (c.friction > 0) c.damping -= c.friction, c.friction = 0;
       })},
  };
}

}  // namespace cylon::mutants
