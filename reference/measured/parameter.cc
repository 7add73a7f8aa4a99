#include "reference/measured/parameter.h"

#include "harness/core/input_error.h"
#include "reference/measured/coordinates.h"
#include "reference/measured/experiment.h"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <limits>

namespace cylon::measured {
namespace {

constexpr double any_size = std::numeric_limits<double>::max();
constexpr double above_zero = std::numeric_limits<double>::min();

// The bodies that a parameter is of.
template <class Change>
void each_body(Experiment& e, const Parameter& p, const Change& change) {
  for (const std::size_t i : e.bodies)
    if (core::Body& body = e.model.scene.bodies[i]; p.body.empty() || body.name == p.body) change(body, i);
}

void friction(Experiment& e, const Parameter&, double value) {
  for (core::Material& m : e.model.scene.materials) m.friction = value;
}

void restitution(Experiment& e, const Parameter&, double value) {
  for (core::Material& m : e.model.scene.materials) m.restitution = value;
}

void inertia(Experiment& e, const Parameter& p, double value) {
  each_body(e, p, [&](core::Body& body, std::size_t) { body.inertia *= value; });
}

void mass(Experiment& e, const Parameter& p, double value) {
  each_body(e, p, [&](core::Body& body, std::size_t) { body.mass *= value; });
}

// The bodies that a parameter of hinges is of, each with its own.
template <class Change>
void each_hinge(Experiment& e, const Parameter& p, const Change& change) {
  each_body(e, p, [&](core::Body& body, std::size_t i) {
    core::Joint* joint = joint_of(e.model.scene, i);
    if (!joint) throw core::InputError(fmt::format("{}: '{}' has no hinge", p.kind, body.name));
    change(body, *joint);
  });
}

// The joint's point is the scene's; the centre moves along the line from there.
void centre(Experiment& e, const Parameter& p, double value) {
  each_hinge(e, p, [&](core::Body& body, const core::Joint& joint) {
    body.initial.position = joint.point + value * (body.initial.position - joint.point);
  });
}

// The line from a body's joint to the next one of the chain; what hangs from there goes with it.
void arm(Experiment& e, const Parameter& p, double value) {
  core::Scene& scene = e.model.scene;
  if (e.bodies.size() < 2 || scene.bodies[e.bodies.back()].name == p.body)
    throw core::InputError(
        fmt::format("{}: no other hinge follows that of '{}'", p.kind, scene.bodies[e.bodies.back()].name));
  for (std::size_t i = 0; i + 1 < e.bodies.size(); ++i) {
    if (!p.body.empty() && scene.bodies[e.bodies[i]].name != p.body) continue;
    const core::Vector3 by =
        (value - 1) * (joint_of(scene, e.bodies[i + 1])->point - joint_of(scene, e.bodies[i])->point);
    for (std::size_t k = i + 1; k < e.bodies.size(); ++k)
      joint_of(scene, e.bodies[k])->point += by, scene.bodies[e.bodies[k]].initial.position += by;
  }
}

// A loss along the angle of a hinge, which nothing may act along yet.
template <double core::JointCoordinate::*loss>
void hinge(Experiment& e, const Parameter& p, double value) {
  each_hinge(e, p, [&](core::Body&, core::Joint& joint) {
    if (joint.angles.empty()) joint.angles.emplace_back();
    joint.angles.front().*loss = value;
  });
}

void gravity(Experiment& e, const Parameter&, double value) {
  for (core::Force& force : e.model.scene.forces)
    if (auto* g = std::get_if<core::UniformGravity>(&force)) g->acceleration *= value;
}

// Data alone: what was measured is `value` times as long as what is.
void length(Experiment& e, const Parameter&, double value) {
  for (Run& run : e.runs)
    for (core::State& state : run.states)
      for (core::BodyState& s : state) s.position /= value, s.velocity /= value;
  e.length *= value, e.noise /= value;
  if (e.coordinates == Coordinates::free)
    for (const Eigen::Index row : {0, 6}) e.start.middleRows(row, 3) /= value;
}

}  // namespace

const std::vector<ParameterKind>& parameter_kinds() {
  static const std::vector<ParameterKind> rows = {
      {"friction", "coefficient of friction of every material of the scene", 0, any_size, friction},
      {"restitution", "restitution of every material of the scene", 0, 1, restitution},
      {"inertia", "factor of a body's tensor of inertia about its centre of mass", above_zero, any_size,
       inertia},
      {"mass", "factor of a body's mass; its tensor of inertia stays", above_zero, any_size, mass},
      {"centre", "factor of the distance of a body's centre of mass from its joint", above_zero, any_size,
       centre},
      {"arm", "of a chain: factor of the distance from a body's joint to the next one's", above_zero,
       any_size, arm},
      {"hinge_damping", "viscous loss of a body's hinge, c of the torque -c q' [N m s/rad]", 0, any_size,
       hinge<&core::JointCoordinate::damping>},
      {"hinge_quadratic_damping", "quadratic loss of a body's hinge, c of -c q' |q'| [N m s^2/rad^2]", 0,
       any_size, hinge<&core::JointCoordinate::quadratic_damping>},
      {"hinge_friction", "Coulomb's loss of a body's hinge, the greatest torque of dry friction [N m]", 0,
       any_size, hinge<&core::JointCoordinate::friction>},
      {"gravity", "factor of the scene's uniform gravity", above_zero, any_size, gravity},
      {"length", "measured over true length, about the origin of the data", above_zero, any_size, length}};
  return rows;
}

Experiment with_values(const Experiment& e, std::span<const Parameter> parameters,
                       std::span<const double> values) {
  assert(parameters.size() == values.size());
  Experiment made = e;
  for (std::size_t i = 0; i < parameters.size(); ++i)
    for (const ParameterKind& kind : parameter_kinds())
      if (kind.name == parameters[i].kind) kind.apply(made, parameters[i], values[i]);
  return made;
}

}  // namespace cylon::measured
