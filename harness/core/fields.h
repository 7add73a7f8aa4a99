// Every element of a scene described once: the words that files and workers use, unit, frame, range, meaning.
// Readers, writers, restatements and the viewer's parameters follow from these tables.  An element without a
// table does not compile there.  Knows no file format.
#pragma once

#include "harness/core/field.h"
#include "harness/core/scene.h"
#include "harness/core/unit.h"

#include <array>
#include <string_view>
#include <tuple>
#include <variant>

namespace cylon::core {

template <>
struct Words<JointType> {
  static constexpr auto list = [] {
    std::array<std::string_view, joint_kinds.size()> names;
    for (std::size_t i = 0; i < names.size(); ++i) names[i] = joint_kinds[i].name;
    return names;
  }();
};
template <>
struct Words<Ordinal> {
  static constexpr std::array<std::string_view, 3> list = {"first", "second", "third"};
};
template <>
struct Words<Impacts> {
  static constexpr std::array<std::string_view, 2> list = {"sequential", "simultaneous"};
};

// ---- Bodies -------------------------------------------------------------------------------------

namespace field_tables {
inline constexpr About on_body{.required = true, .meaning = "Name of the body on which it acts."};
inline constexpr About groups{.meaning = "Names of the groups in which it is.", .absent = "[\"default\"]"};
inline constexpr About mask{.meaning =
                                "Names of the groups that it touches. Two things touch only if the mask "
                                "of each names a group of the other.",
                            .absent = "all groups"};
}  // namespace field_tables

template <>
struct Element<BodyState> {
  static constexpr std::string_view name = "state";
  static constexpr std::tuple fields{
      Field{"position",
            &BodyState::position,
            {.unit = "m", .in = Expressed::world_point, .meaning = "Of the centre of mass, world axes."}},
      Field{"velocity",
            &BodyState::velocity,
            {.unit = "m/s",
             .in = Expressed::world_vector,
             .start_rank = 1,
             .meaning = "Of the centre of mass, world axes; must satisfy the joints."}},
      Field{"angular_velocity",
            &BodyState::angular_velocity,
            {.unit = "rad/s", .in = Expressed::world_axial, .start_rank = 1, .meaning = "In world axes."}},
      Field{"orientation",
            &BodyState::orientation,
            {.in = Expressed::world_vector, .meaning = "Unit quaternion (w, x, y, z), body to world."}}};
};
/// The keys of `initial` stand beside those of the body.
template <>
struct Element<Body> {
  static constexpr std::string_view name = "body";
  static constexpr std::string_view meaning = "A rigid body.";
  static constexpr std::tuple fields{
      Field{"name",
            &Body::name,
            {.required = true, .meaning = "Unique; forces, joints, materials and claims refer to it."}},
      Field{"initial", &Body::initial, {}},
      Field{"gravity",
            &Body::gravity,
            {.unit = "m/s^2",
             .in = Expressed::world_vector,
             .start_rank = 2,
             .meaning =
                 "Acceleration of this body in place of the scene's `gravity`, world axes. Zero switches it "
                 "off. Not of a locked body.",
             .absent = "that of the scene"},
            [](const Body& b) { return !b.locked; }},
      Field{"mass",
            &Body::mass,
            {.unit = "kg",
             .range = positive,
             .meaning = "Mass of the body.",
             .absent = "1 if locked; of a compound the sum of its parts; else an error"}},
      Field{"inertia",
            &Body::inertia,
            {.unit = "kg m^2",
             .in = Expressed::body_axes,
             .meaning = "About the centre of mass in body axes: the full tensor row by row, or in a file its "
                        "principal moments; each moment > 0.",
             .absent = "from the shape; without a shape mass x 1 m^2 about every axis"}},
      Field{"shape",
            &Body::shape,
            {.meaning = "What can be touched, and what the inertia follows from.",
             .absent = "a point, or a rigid body without a surface"}},
      Field{"locked", &Body::locked, {.meaning = "The body never moves, whatever acts on it."}},
      Field{"collide",
            &Body::collide,
            {.meaning =
                 "The body takes part in contacts, except with bodies that a joint ties to it. `false` is "
                 "the empty mask.",
             .absent = "true if it has a shape"}},
      Field{"collision_groups", &Body::collision_groups, field_tables::groups,
            [](const Body& b) { return b.collide; }},
      Field{"collision_mask", &Body::collision_mask, field_tables::mask,
            [](const Body& b) { return b.collide; }},
      Field{"color", &Body::color, {.meaning = "For viewers: \"#rrggbb\"."}}};
};

// ---- Forces -------------------------------------------------------------------------------------

/// One key of the scene, not a table: several of them add up.
template <>
struct Element<UniformGravity> {
  static constexpr std::string_view name = "gravity";
  static constexpr std::string_view meaning = "Gravity, the same everywhere.";
  static constexpr std::tuple fields{
      Field{"gravity",
            &UniformGravity::acceleration,
            {.unit = "m/s^2",
             .in = Expressed::world_vector,
             .start_rank = 2,
             .meaning = "Acceleration of every body that states none of its own.",
             .absent = "none"}}};
};
template <>
struct Element<Spring> {
  static constexpr std::string_view name = "spring";
  static constexpr std::string_view meaning =
      "A spring with damping: with d from the anchor to the other end, F = (stiffness (|d| - rest_length) + "
      "damping d|d|/dt) d/|d| on `body` and -F on `to`; zero at d = 0.";
  static constexpr std::tuple fields{
      Field{"body", &Spring::body, field_tables::on_body},
      Field{"anchor",
            &Spring::anchor,
            {.unit = "m", .in = Expressed::body_axes, .meaning = "On the body, body axes."}},
      Field{"to", &Spring::to, {.meaning = "Name of the other body. Either this or `pin`."}},
      Field{"to_anchor",
            &Spring::to_anchor,
            {.unit = "m",
             .in = Expressed::other_end,
             .meaning = "On the body `to`, its axes.",
             .pin = "pin",
             .pin_meaning = "A point of the world in place of `to`."}},
      Field{"stiffness",
            &Spring::stiffness,
            {.unit = "N/m",
             .range = not_negative,
             .required = true,
             .tunable = true,
             .start_rank = 3,
             .meaning = "Force per elongation."}},
      Field{"rest_length",
            &Spring::rest_length,
            {.unit = "m", .range = not_negative, .tunable = true, .meaning = "Length without force."}},
      Field{"damping",
            &Spring::damping,
            {.unit = "N s/m", .range = not_negative, .tunable = true, .meaning = "Along the spring."}}};
};
template <>
struct Element<Drag> {
  static constexpr std::string_view name = "drag";
  static constexpr std::string_view meaning =
      "Resistance of a medium: F = -linear v; torque = -angular w - momentum L, with L the spin angular "
      "momentum.";
  static constexpr std::tuple fields{
      Field{"body", &Drag::body, field_tables::on_body},
      Field{"linear",
            &Drag::linear,
            {.unit = "kg/s", .range = not_negative, .tunable = true, .meaning = "Of the velocity."}},
      Field{"angular",
            &Drag::angular,
            {.unit = "kg m^2/s",
             .range = not_negative,
             .tunable = true,
             .meaning = "Of the angular velocity."}},
      Field{"momentum",
            &Drag::momentum,
            {.unit = "1/s",
             .range = not_negative,
             .tunable = true,
             .meaning = "Of the spin angular momentum."}}};
};
template <>
struct Element<Thrust> {
  static constexpr std::string_view name = "thrust";
  static constexpr std::string_view meaning =
      "A motor, a rocket or accretion: a constant force, or the momentum of the mass that leaves or arrives.";
  static constexpr std::tuple fields{
      Field{"body", &Thrust::body, field_tables::on_body},
      Field{"force",
            &Thrust::force,
            {.unit = "N", .in = Expressed::body_axes, .meaning = "In body axes. Either this or `mass_rate`."},
            [](const Thrust& t) { return !t.exhaust_velocity && !t.exchanged_velocity; }},
      Field{"mass_rate",
            &Thrust::mass_rate,
            {.unit = "kg/s", .meaning = "Of the mass of the body; < 0 is a rocket. Needs a velocity."},
            [](const Thrust& t) { return t.exhaust_velocity || t.exchanged_velocity; }},
      Field{"exhaust_velocity",
            &Thrust::exhaust_velocity,
            {.unit = "m/s",
             .in = Expressed::body_axes,
             .meaning = "Of the mass, relative to the body, body axes."}},
      Field{
          "exchanged_velocity",
          &Thrust::exchanged_velocity,
          {.unit = "m/s", .in = Expressed::world_vector, .meaning = "Of the mass, world axes (accretion)."}}};
};
template <>
struct Element<Drive> {
  static constexpr std::string_view name = "drive";
  static constexpr std::string_view meaning =
      "A harmonic force: F = force cos(frequency t) at the centre of mass.";
  static constexpr std::tuple fields{
      Field{"body", &Drive::body, field_tables::on_body},
      Field{"force",
            &Drive::force,
            {.unit = "N",
             .in = Expressed::world_vector,
             .required = true,
             .meaning = "Amplitude, world axes."}},
      Field{"frequency",
            &Drive::frequency,
            {.unit = "rad/s", .range = not_negative, .required = true, .meaning = "Angular frequency."}}};
};
template <>
struct Element<Attraction> {
  static constexpr std::string_view name = "attraction";
  static constexpr std::string_view meaning =
      "Gravity between two bodies: F = strength m m' d/|d|^3 on `body` and -F on `to`, with d from `body` to "
      "`to`.";
  static constexpr std::tuple fields{
      Field{"body", &Attraction::body, field_tables::on_body},
      Field{"to", &Attraction::to, {.required = true, .meaning = "Name of the other body."}},
      Field{"strength",
            &Attraction::strength,
            {.unit = "m^3/(kg s^2)",
             .required = true,
             .tunable = true,
             .meaning = "The gravitational constant; < 0 repels."}}};
};
template <>
struct Element<Water> {
  static constexpr std::string_view name = "water";
  static constexpr std::string_view meaning =
      "A water surface; its two models are in docs/scenario-format.md#water.";
  static constexpr std::tuple fields{
      Field{"level",
            &Water::level,
            {.unit = "m", .tunable = true, .meaning = "Height of the surface at rest."}},
      Field{"wave", &Water::wave, {.unit = "m", .range = not_negative, .meaning = "Amplitude of the wave."}},
      Field{"speed", &Water::speed, {.unit = "rad/s", .meaning = "Of the wave's phase."}},
      Field{"buoyancy",  // two dimensions: nothing that needs one can be made for water
            &Water::buoyancy,
            {.unit = "N or kg/m^3",
             .range = not_negative,
             .required = true,
             .tunable = true,
             .meaning = "The density of the water in mode volume, the lift in mode step."}},
      Field{"drag",
            &Water::drag,
            {.unit = "kg/s",
             .range = not_negative,
             .tunable = true,
             .meaning = "Of the velocity, below the surface."}},
      Field{"mode",
            &Water::mode,
            {.meaning = "Archimedes' law, or a constant lift below the surface.",
             .words = {"volume", "step"}}}};
};

template <>
struct Element<PluginForce> {
  static constexpr std::string_view name = "plugin_force";
  static constexpr std::string_view meaning =
      "A force whose law is code of your own (docs/in-house.md#forces-of-your-own). A scene loads no code: "
      "the "
      "command line must let the plug-in take part by `--plugin NAME=FILE`.";
  static constexpr bool later = true;
  static constexpr std::tuple fields{
      Field{"plugin",
            &PluginForce::plugin,
            {.required = true, .meaning = "Name of the plug-in, as in `--plugin NAME=FILE`."}},
      Field{"law", &PluginForce::law, {.required = true, .meaning = "Which of the laws in it."}},
      Field{"bodies",
            &PluginForce::bodies,
            {.required = true,
             .meaning = "Names of the bodies on which it acts, each once, in the order that the law "
                        "expects."}},
      Field{"parameters",
            &PluginForce::parameters,
            {.meaning = "Numbers that the law takes, by name, in its own units: { k = 4.0 }.",
             .absent = "those of the law"}}};
};

// ---- Joints, surfaces, the frame ------------------------------------------------------------------

namespace field_tables {
/// Units along a displacement and along an angle.
struct AlongDisplacement {
  static constexpr std::string_view value = "m", force = "N", stiffness = "N/m", damping = "N s/m",
                                    quadratic = "N s^2/m^2", inertia = "kg";
};
struct AlongAngle {
  static constexpr std::string_view value = "rad", force = "N m", stiffness = "N m/rad",
                                    damping = "N m s/rad", quadratic = "N m s^2/rad^2", inertia = "kg m^2";
};

template <class Units>
constexpr auto coordinate() {
  using C = JointCoordinate;
  return std::tuple{
      Field{"which", &C::which, {.meaning = "Of a joint that has several such coordinates: which."}},
      Field{"start",
            &C::start,
            {.unit = Units::value,
             .meaning = "Value of the coordinate at t = 0; limits and targets are in these terms."}},
      Field{"lower", &C::lower, {.unit = Units::value, .meaning = "Lower limit.", .absent = "no limit"}},
      Field{"upper", &C::upper, {.unit = Units::value, .meaning = "Upper limit.", .absent = "no limit"}},
      Field{"restitution",
            &C::restitution,
            {.range = unit_interval, .meaning = "Coefficient of restitution at the limits."}},
      Field{"force", &C::force, {.unit = Units::force, .meaning = "Constant, along the coordinate."}},
      Field{"stiffness",
            &C::stiffness,
            {.unit = Units::stiffness,
             .range = not_negative,
             .meaning = "Force per distance from the target."}},
      Field{
          "damping",
          &C::damping,
          {.unit = Units::damping, .range = not_negative, .meaning = "Of the rate less that of the target."}},
      Field{"quadratic_damping",
            &C::quadratic_damping,
            {.unit = Units::quadratic, .range = not_negative, .meaning = "c of the force -c q' |q'|."}},
      Field{"friction",
            &C::friction,
            {.unit = Units::force,
             .range = not_negative,
             .meaning = "Largest force of dry friction, static and kinetic."}},
      Field{"armature",
            &C::armature,
            {.unit = Units::inertia,
             .range = not_negative,
             .meaning = "Of a rotor geared to the coordinate: its kinetic energy is armature q'^2/2."}},
      Field{"target", &C::target, {.unit = Units::value, .meaning = "Where the spring is without force."}},
      Field{"target_amplitude",
            &C::target_amplitude,
            {.unit = Units::value, .meaning = "The target moves: + amplitude cos(frequency t + phase)."}},
      Field{"target_frequency",
            &C::target_frequency,
            {.unit = "rad/s", .range = not_negative, .meaning = "Angular frequency of the target."}},
      Field{"target_phase", &C::target_phase, {.unit = "rad", .meaning = "Phase of the target at t = 0."}},
      Field{"target_times",
            &C::target_times,
            {.unit = "s", .meaning = "Ascending times of `target_values`.", .absent = "no table"}},
      Field{"target_values",
            &C::target_values,
            {.unit = Units::value,
             .meaning = "A table in place of the above: linear between its times, constant outside.",
             .absent = "no table"}}};
}
}  // namespace field_tables

template <>
struct Element<JointDisplacement> {
  static constexpr std::string_view name = "displacement";
  static constexpr std::string_view meaning = "What acts along a displacement that the joint leaves free.";
  static constexpr std::tuple fields = field_tables::coordinate<field_tables::AlongDisplacement>();
};
template <>
struct Element<JointAngle> {
  static constexpr std::string_view name = "angle";
  static constexpr std::string_view meaning = "What acts along an angle that the joint leaves free.";
  static constexpr std::tuple fields = field_tables::coordinate<field_tables::AlongAngle>();
};

template <>
struct Element<Joint> {
  static constexpr std::string_view name = "joint";
  static constexpr std::string_view meaning = "A joint between a body and another, or the world.";
  static constexpr std::tuple fields{
      Field{"type", &Joint::type, {.required = true, .meaning = "Kind of joint."}},
      Field{"name",
            &Joint::name,
            {.later = true, .meaning = "Unique among joints; claims refer to it.", .absent = "none"}},
      Field{"body", &Joint::body, field_tables::on_body},
      Field{"to", &Joint::to, {.meaning = "Name of the other body.", .absent = "the world"}},
      Field{"point",
            &Joint::point,
            {.unit = "m",
             .in = Expressed::world_point,
             .required = true,
             .meaning =
                 "World coordinates at t = 0. Not of a distance joint of two bodies, which connects "
                 "their centres. Of an offset universal joint, the point of `axis` nearest to `axis_2`."},
            [](const Joint& j) { return !kind_of(j.type).joins_centres() || j.to == world; }},
      Field{
          "axis",
          &Joint::axis,
          {.in = Expressed::world_vector,
           .required = true,
           .meaning = "Of a joint about or along an axis, or in the plane square to it; world axes at t = 0, "
                      "any length but zero."},
          [](const Joint& j) { return kind_of(j.type).has_axis(); }},
      Field{"axis_2",
            &Joint::axis_2,
            {.in = Expressed::world_vector,
             .required = true,
             .meaning = "The second axis of a universal joint, offset or not, or of a gimbal, fixed in "
                        "`body`, or the first "
                        "displacement of a planar or rectangular joint, fixed in `to`. Square to `axis`; of "
                        "a gimbal, only "
                        "not parallel to it."},
            [](const Joint& j) { return kind_of(j.type).has_second_axis(); }},
      Field{
          "length",
          &Joint::length,
          {.unit = "m",
           .range = positive,
           .meaning = "Of a distance joint, between its two ends; of an offset universal joint, from `axis` "
                      "to `axis_2` along the line square to both, towards `axis` x `axis_2`.",
           .absent = "the distance at t = 0"},
          [](const Joint& j) { return kind_of(j.type).has_length(); }},
      Field{"pitch",
            &Joint::pitch,
            {.unit = "m/rad",
             .required = true,
             .later = true,
             .meaning = "Of a screw: displacement per angle, not 0; < 0 is left-handed."},
            [](const Joint& j) { return kind_of(j.type).screws; }},
      Field{"displacement",
            &Joint::displacements,
            {.meaning = "What acts along a free displacement."},
            [](const Joint& j) { return kind_of(j.type).displacements() > 0; }},
      Field{"angle", &Joint::angles, {.meaning = "What acts along a free angle."}, [](const Joint& j) {
              return kind_of(j.type).angles() > 0;
            }}};
};
template <>
struct Element<Plane> {
  static constexpr std::string_view name = "plane";
  static constexpr std::string_view meaning = "A fixed half-space, solid where normal . x < offset.";
  static constexpr std::tuple fields{
      Field{"name", &Plane::name, {.required = true, .meaning = "Unique among planes and bodies."}},
      Field{"normal", &Plane::normal, {.in = Expressed::world_vector, .meaning = "Unit vector, world axes."}},
      Field{"offset",
            &Plane::offset,
            {.unit = "m", .meaning = "Of the surface from the origin along `normal`."}},
      Field{"collision_groups", &Plane::collision_groups, field_tables::groups},
      Field{"collision_mask", &Plane::collision_mask, field_tables::mask}};
};
template <>
struct Element<Material> {
  static constexpr std::string_view name = "material";
  static constexpr std::string_view meaning =
      "What happens where a pair touches; all numbers are of the pair.";
  static constexpr std::tuple fields{
      Field{"between",
            &Material::between,
            {.required = true,
             .meaning = "Two names of bodies, planes or generators; \"*\" "
                        "matches all, an exact pair wins over a pattern. Two patterns that "
                        "match one pair say the same."}},
      Field{"restitution",
            &Material::restitution,
            {.range = unit_interval,
             .required = true,
             .tunable = true,
             .meaning = "Coefficient of restitution."}},
      Field{"friction",
            &Material::friction,
            {.range = not_negative,
             .required = true,
             .tunable = true,
             .meaning = "Coulomb's coefficient, static and kinetic."}}};
};
template <>
struct Element<Frame> {
  static constexpr std::string_view name = "frame";
  static constexpr std::string_view meaning =
      "The frame in which the whole scene is given, as seen from an inertial frame: initial state, pins, "
      "planes, gravity and results are all expressed in it. A frame that turns or accelerates has fictitious "
      "forces; a frame that only moves on changes nothing.";
  static constexpr std::tuple fields{
      Field{"velocity",
            &Frame::velocity,
            {.unit = "m/s", .in = Expressed::world_vector, .meaning = "Of its origin."}},
      Field{"acceleration",
            &Frame::acceleration,
            {.unit = "m/s^2",
             .in = Expressed::world_vector,
             .later = true,
             .meaning = "Of its origin, times cos(frequency t); in the axes of the frame."}},
      Field{"frequency",
            &Frame::frequency,
            {.unit = "rad/s",
             .range = not_negative,
             .later = true,
             .meaning = "Of the acceleration; 0: constant."}},
      Field{"angular_velocity",
            &Frame::angular_velocity,
            {.unit = "rad/s", .in = Expressed::world_axial, .meaning = "About its origin, at t = 0."}},
      Field{"angular_acceleration",
            &Frame::angular_acceleration,
            {.unit = "rad/s^2",
             .in = Expressed::world_axial,
             .later = true,
             .meaning = "Constant in the axes of the frame."}}};
};

// ---- Every alternative has a table --------------------------------------------------------------

/// Calls visit.template operator()<T>() for each kind of force, in the order of core::Force.
template <class Visit>
constexpr void for_each_force(Visit&& visit) {
  [&]<class... Kind>(std::variant<Kind...>*) {
    (visit.template operator()<Kind>(), ...);
  }(static_cast<Force*>(nullptr));
}

/// The same for the alternatives of core::Shape or core::Primitive, bar monostate.
template <class Any, class Visit>
constexpr void for_each_shape(Visit&& visit) {
  [&]<class... Kind>(std::variant<std::monostate, Kind...>*) {
    (visit.template operator()<Kind>(), ...);
  }(static_cast<Any*>(nullptr));
}

/// The key of a member, that of a pin where the other end is a place of the world; its data() ends in a zero.
template <class T>
constexpr std::string_view key_of(const T& element, const auto& field) {
  if constexpr (requires { element.to; })
    if (!field.about.pin.empty() && element.to == world) return field.about.pin;
  return field.key;
}

/// Calls visit(element) for each body, force, joint, plane, the frame and each material of a scene.
template <class AScene, class Visit>
void for_each_element(AScene& scene, Visit&& visit) {
  for (auto& body : scene.bodies) visit(body);
  for (auto& force : scene.forces) std::visit(visit, force);
  for (auto& joint : scene.joints) visit(joint);
  for (auto& plane : scene.planes) visit(plane);
  if (scene.frame) visit(*scene.frame);
  for (auto& material : scene.materials) visit(material);
}

}  // namespace cylon::core
