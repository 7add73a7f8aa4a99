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
  static constexpr std::array<std::string_view, 4> list = {"ball", "hinge", "distance", "fixed"};
};
template <>
struct Words<Impacts> {
  static constexpr std::array<std::string_view, 2> list = {"sequential", "simultaneous"};
};

// ---- Shapes -------------------------------------------------------------------------------------

namespace field_tables {
inline constexpr About radius{.unit = "m", .range = positive, .required = true, .meaning = "Radius."};
inline constexpr About length{.unit = "m",
                              .range = positive,
                              .required = true,
                              .meaning = "Length along body y; of a capsule, of its cylinder."};
inline constexpr About on_body{.required = true, .meaning = "Name of the body."};
}  // namespace field_tables

template <>
struct Element<Sphere> {
  static constexpr std::string_view name = "sphere";
  static constexpr std::tuple fields{Field{"radius", &Sphere::radius, field_tables::radius}};
};
template <>
struct Element<Box> {
  static constexpr std::string_view name = "box";
  // Half extents are lengths along the body's axes, not the coordinates of a vector: no frame.
  static constexpr std::tuple fields{Field{
      "half_extents",
      &Box::half_extents,
      {.unit = "m", .range = positive, .required = true, .meaning = "Half the edges along body x, y, z."}}};
};
template <>
struct Element<Capsule> {
  static constexpr std::string_view name = "capsule";
  static constexpr std::tuple fields{Field{"radius", &Capsule::radius, field_tables::radius},
                                     Field{"length", &Capsule::length, field_tables::length}};
};
template <>
struct Element<Cylinder> {
  static constexpr std::string_view name = "cylinder";
  static constexpr std::tuple fields{Field{"radius", &Cylinder::radius, field_tables::radius},
                                     Field{"length", &Cylinder::length, field_tables::length}};
};
template <>
struct Element<Cone> {
  static constexpr std::string_view name = "cone";
  static constexpr std::tuple fields{Field{"radius", &Cone::radius, field_tables::radius},
                                     Field{"length", &Cone::length, field_tables::length}};
};
template <>
struct Element<Rod> {
  static constexpr std::string_view name = "rod";
  static constexpr std::tuple fields{Field{"length", &Rod::length, field_tables::length}};
};
template <>
struct Element<Disc> {
  static constexpr std::string_view name = "disc";
  static constexpr std::tuple fields{Field{"radius", &Disc::radius, field_tables::radius}};
};
template <>
struct Element<Hull> {
  static constexpr std::string_view name = "hull";
  static constexpr std::tuple fields{Field{"vertices",
                                           &Hull::vertices,
                                           {.unit = "m",
                                            .in = Expressed::body_axes,
                                            .required = true,
                                            .meaning = "The convex hull of these points."}}};
};
template <>
struct Element<Mesh> {
  static constexpr std::string_view name = "mesh";
  static constexpr std::tuple fields{
      Field{"vertices", &Mesh::vertices, {.unit = "m", .in = Expressed::body_axes}},
      Field{"faces", &Mesh::faces, {.meaning = "Indices from 0, counter-clockwise seen from outside."}}};
};
template <>
struct Element<Part> {
  static constexpr std::string_view name = "part";
  static constexpr std::tuple fields{
      Field{"shape", &Part::shape, {}},
      Field{"mass",
            &Part::mass,
            {.unit = "kg", .range = positive, .required = true, .meaning = "Mass of the part."}},
      Field{"position",
            &Part::position,
            {.unit = "m",
             .in = Expressed::body_axes,
             .meaning = "Centre of mass of the part; the origin is moved to the common centre."}},
      Field{"orientation",
            &Part::orientation,
            {.in = Expressed::body_axes, .meaning = "(w, x, y, z), part to body."}}};
};
template <>
struct Element<Compound> {
  static constexpr std::string_view name = "compound";
  static constexpr std::tuple fields{
      Field{"parts", &Compound::parts, {.required = true, .meaning = "Rigidly joined parts."}}};
};

// ---- Bodies -------------------------------------------------------------------------------------

template <>
struct Element<BodyState> {
  static constexpr std::string_view name = "state";
  static constexpr std::tuple fields{
      Field{"position",
            &BodyState::position,
            {.unit = "m", .in = Expressed::world_point, .meaning = "Of the centre of mass, world axes."}},
      Field{"orientation",
            &BodyState::orientation,
            {.in = Expressed::world_vector, .meaning = "Unit (w, x, y, z), body to world."}},
      Field{"velocity",
            &BodyState::velocity,
            {.unit = "m/s",
             .in = Expressed::world_vector,
             .meaning = "Of the centre of mass, world axes; must fit the joints."}},
      Field{"angular_velocity",
            &BodyState::angular_velocity,
            {.unit = "rad/s", .in = Expressed::world_axial, .meaning = "World axes."}}};
};
/// The keys of `initial` stand beside those of the body.
template <>
struct Element<Body> {
  static constexpr std::string_view name = "body";
  static constexpr std::tuple fields{
      Field{"name",
            &Body::name,
            {.required = true, .meaning = "Unique; forces, joints, materials and claims refer to it."}},
      Field{"mass",
            &Body::mass,
            {.unit = "kg", .range = positive, .meaning = "Required, unless locked or a compound."}},
      Field{"inertia",
            &Body::inertia,
            {.unit = "kg m^2",
             .in = Expressed::body_axes,
             .meaning = "Principal moments about the centre of mass in body axes, or nine numbers by rows; "
                        "absent: from the shape; without a shape, mass x 1 m^2 about every axis, since a "
                        "point has no orientation."}},
      Field{"initial", &Body::initial, {}},
      Field{"shape", &Body::shape, {.meaning = "Absent: a point or bare rigid body."}},
      Field{"locked", &Body::locked, {.meaning = "Does not move, whatever acts on it."}},
      Field{"collide",
            &Body::collide,
            {.meaning = "Takes part in contacts; absent: true where there is a shape."}},
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
            {.unit = "m/s^2", .in = Expressed::world_vector, .meaning = "Absent: none."}}};
};
template <>
struct Element<Spring> {
  static constexpr std::string_view name = "spring";
  static constexpr std::string_view meaning = "A spring with damping.";
  static constexpr std::tuple fields{
      Field{"body", &Spring::body, field_tables::on_body},
      Field{"anchor",
            &Spring::anchor,
            {.unit = "m", .in = Expressed::body_axes, .meaning = "On the body, body axes."}},
      Field{"to", &Spring::to, {.meaning = "Name of the other body; or `pin`."}},
      Field{"to_anchor",
            &Spring::to_anchor,
            {.unit = "m",
             .in = Expressed::other_end,
             .meaning = "On the other body, its axes.",
             .pin = "pin",
             .pin_meaning = "A point of the world."}},
      Field{"stiffness",
            &Spring::stiffness,
            {.unit = "N/m",
             .range = not_negative,
             .required = true,
             .tunable = true,
             .meaning = "F = stiffness (|d| - rest_length) along d."}},
      Field{"rest_length", &Spring::rest_length, {.unit = "m", .range = not_negative, .tunable = true}},
      Field{"damping",
            &Spring::damping,
            {.unit = "N s/m", .range = not_negative, .tunable = true, .meaning = "Along d."}}};
};
template <>
struct Element<Drag> {
  static constexpr std::string_view name = "drag";
  static constexpr std::string_view meaning = "Resistance of a medium.";
  static constexpr std::tuple fields{
      Field{"body", &Drag::body, field_tables::on_body},
      Field{"linear",
            &Drag::linear,
            {.unit = "kg/s", .range = not_negative, .tunable = true, .meaning = "F = -linear v."}},
      Field{"angular",
            &Drag::angular,
            {.unit = "kg m^2/s", .range = not_negative, .tunable = true, .meaning = "Torque = -angular w."}},
      Field{
          "momentum",
          &Drag::momentum,
          {.unit = "1/s", .range = not_negative, .tunable = true, .meaning = "Torque = -momentum L_spin."}}};
};
template <>
struct Element<Thrust> {
  static constexpr std::string_view name = "thrust";
  static constexpr std::string_view meaning = "A motor, a rocket or accretion.";
  static constexpr std::tuple fields{
      Field{"body", &Thrust::body, field_tables::on_body},
      Field{"force",
            &Thrust::force,
            {.unit = "N", .in = Expressed::body_axes, .meaning = "Constant, body axes; or `mass_rate`."}},
      Field{"mass_rate",
            &Thrust::mass_rate,
            {.unit = "kg/s", .meaning = "Of the body's mass; < 0 is a rocket."}},
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
  static constexpr std::string_view meaning = "A harmonic force.";
  static constexpr std::tuple fields{
      Field{"body", &Drive::body, field_tables::on_body},
      Field{"force",
            &Drive::force,
            {.unit = "N",
             .in = Expressed::world_vector,
             .required = true,
             .meaning = "Amplitude of F cos(frequency t), world axes."}},
      Field{"frequency",
            &Drive::frequency,
            {.unit = "rad/s", .range = not_negative, .required = true, .meaning = "Angular frequency."}}};
};
template <>
struct Element<Attraction> {
  static constexpr std::string_view name = "attraction";
  static constexpr std::string_view meaning = "Gravity between two bodies.";
  static constexpr std::tuple fields{
      Field{"body", &Attraction::body, field_tables::on_body},
      Field{"to", &Attraction::to, {.required = true, .meaning = "Name of the other body."}},
      Field{"strength",
            &Attraction::strength,
            {.unit = "m^3/(kg s^2)",
             .required = true,
             .tunable = true,
             .meaning = "F = strength m m' / d^2; < 0 repels."}}};
};
template <>
struct Element<Water> {
  static constexpr std::string_view name = "water";
  static constexpr std::string_view meaning = "A water surface.";
  static constexpr std::tuple fields{
      Field{"level",
            &Water::level,
            {.unit = "m",
             .tunable = true,
             .meaning = "Of the surface at rest; its waves: docs/scenario-format.md."}},
      Field{"wave", &Water::wave, {.unit = "m", .range = not_negative, .meaning = "Amplitude."}},
      Field{"speed", &Water::speed, {.unit = "rad/s", .meaning = "Of the wave's phase."}},
      Field{"buoyancy",  // two dimensions: nothing that needs one can be made for water
            &Water::buoyancy,
            {.unit = "N or kg/m^3",
             .range = not_negative,
             .required = true,
             .tunable = true,
             .meaning = "Mode step: the lift; mode volume: the density."}},
      Field{"drag",
            &Water::drag,
            {.unit = "kg/s", .range = not_negative, .tunable = true, .meaning = "Below the surface."}},
      Field{"mode",
            &Water::mode,
            {.meaning = "Archimedes, or a constant lift below the surface.", .words = {"volume", "step"}}}};
};

// ---- Joints, surfaces, the frame ------------------------------------------------------------------

/// Which keys a joint of one type has in a file is the reader's affair.
template <>
struct Element<Joint> {
  static constexpr std::string_view name = "joint";
  static constexpr std::string_view meaning = "A joint.";
  static constexpr std::tuple fields{
      Field{"type", &Joint::type, {.required = true, .meaning = "Kind of joint."}},
      Field{"body", &Joint::body, field_tables::on_body},
      Field{"to", &Joint::to, {.meaning = "The other body; absent: the world."}},
      Field{"point",
            &Joint::point,
            {.unit = "m",
             .in = Expressed::world_point,
             .required = true,
             .meaning = "World coordinates at t = 0."}},
      Field{"axis",
            &Joint::axis,
            {.in = Expressed::world_vector,
             .required = true,
             .meaning = "World axes at t = 0, any length but zero."}},
      Field{"length",
            &Joint::length,
            {.unit = "m", .range = positive, .meaning = "Absent: the distance at t = 0."}}};
};
template <>
struct Element<Plane> {
  static constexpr std::string_view name = "plane";
  static constexpr std::string_view meaning = "A fixed half-space.";
  static constexpr std::tuple fields{
      Field{"name", &Plane::name, {.required = true, .meaning = "Unique among planes and bodies."}},
      Field{"normal",
            &Plane::normal,
            {.in = Expressed::world_vector, .meaning = "Unit; solid where normal . x < offset; absent: y."}},
      Field{"offset", &Plane::offset, {.unit = "m"}}};
};
template <>
struct Element<Material> {
  static constexpr std::string_view name = "material";
  static constexpr std::string_view meaning = "What happens where a pair touches.";
  static constexpr std::tuple fields{
      Field{"between",
            &Material::between,
            {.required = true,
             .meaning = "Two names of bodies, planes or generators; \"*\" is all, an exact pair wins."}},
      Field{"restitution",
            &Material::restitution,
            {.range = unit_interval, .required = true, .tunable = true, .meaning = "Of the pair."}},
      Field{
          "friction",
          &Material::friction,
          {.range = not_negative, .required = true, .tunable = true, .meaning = "Coulomb's, of the pair."}}};
};
template <>
struct Element<Frame> {
  static constexpr std::string_view name = "frame";
  static constexpr std::string_view meaning = "The frame in which the initial state is given.";
  static constexpr std::tuple fields{
      Field{"velocity",
            &Frame::velocity,
            {.unit = "m/s",
             .in = Expressed::world_vector,
             .meaning = "Of the frame in which the scene is given."}},
      Field{"angular_velocity",
            &Frame::angular_velocity,
            {.unit = "rad/s", .in = Expressed::world_axial, .meaning = "Of that frame."}}};
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

}  // namespace cylon::core
