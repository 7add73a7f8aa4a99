// Shapes, each with the table of its fields (fields.h).  Body frame, centred on the centre of mass, axis of
// revolution along body y.  What follows from a shape is in solid.h.
#pragma once

#include "harness/core/field.h"

#include <Eigen/Core>
#include <Eigen/Geometry>

#include <array>
#include <cstdint>
#include <string_view>
#include <tuple>
#include <variant>
#include <vector>

namespace cylon::core {

using Vector3 = Eigen::Vector3d;
using Matrix3 = Eigen::Matrix3d;
using Quaternion = Eigen::Quaterniond;

namespace field_tables {
inline constexpr About radius{.unit = "m", .range = positive, .required = true, .meaning = "Radius."};
inline constexpr About length{.unit = "m",
                              .range = positive,
                              .required = true,
                              .meaning = "Length along body y; of a capsule, of its cylinder."};
}  // namespace field_tables

struct Sphere {
  double radius = 0;  ///< [m]
};
template <>
struct Element<Sphere> {
  static constexpr std::string_view name = "sphere";
  static constexpr std::tuple fields{Field{"radius", &Sphere::radius, field_tables::radius}};
};

struct Box {
  Vector3 half_extents = Vector3::Zero();  ///< [m]
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

struct Capsule {
  double radius = 0, length = 0;  ///< [m]; length of the cylindrical part.
};
template <>
struct Element<Capsule> {
  static constexpr std::string_view name = "capsule";
  static constexpr std::tuple fields{Field{"radius", &Capsule::radius, field_tables::radius},
                                     Field{"length", &Capsule::length, field_tables::length}};
};

struct Cylinder {
  double radius = 0, length = 0;  ///< [m]
};
template <>
struct Element<Cylinder> {
  static constexpr std::string_view name = "cylinder";
  static constexpr std::tuple fields{Field{"radius", &Cylinder::radius, field_tables::radius},
                                     Field{"length", &Cylinder::length, field_tables::length}};
};

struct Cone {
  double radius = 0, length = 0;  ///< [m]; tip towards +y; centre of mass length/4 above the base.
};
template <>
struct Element<Cone> {
  static constexpr std::string_view name = "cone";
  static constexpr std::tuple fields{Field{"radius", &Cone::radius, field_tables::radius},
                                     Field{"length", &Cone::length, field_tables::length}};
};

struct Rod {
  double length = 0;  ///< [m]; no thickness.
};
template <>
struct Element<Rod> {
  static constexpr std::string_view name = "rod";
  static constexpr std::tuple fields{Field{"length", &Rod::length, field_tables::length}};
};

struct Disc {
  double radius = 0;  ///< [m]; no thickness.
};
template <>
struct Element<Disc> {
  static constexpr std::string_view name = "disc";
  static constexpr std::tuple fields{Field{"radius", &Disc::radius, field_tables::radius}};
};

struct Hull {
  std::vector<Vector3> vertices;  ///< [m]; the convex hull of these points.
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

struct Mesh {
  std::vector<Vector3> vertices;                   ///< [m]
  std::vector<std::array<std::int32_t, 3>> faces;  ///< Counter-clockwise seen from outside.
};
template <>
struct Element<Mesh> {
  static constexpr std::string_view name = "mesh";
  static constexpr std::tuple fields{
      Field{"vertices",
            &Mesh::vertices,
            {.unit = "m", .in = Expressed::body_axes, .meaning = "Corners of the closed surface."}},
      Field{"faces",
            &Mesh::faces,
            {.meaning = "Triples of indices from 0, counter-clockwise seen from outside."}}};
};

/// monostate: a point, or a bare rigid body that nothing can touch.
using Primitive = std::variant<std::monostate, Sphere, Box, Capsule, Cylinder, Cone, Rod, Disc, Hull, Mesh>;

struct Part {
  Primitive shape;
  double mass = 0;                                  ///< [kg]
  Vector3 position = Vector3::Zero();               ///< In the body frame [m].
  Quaternion orientation = Quaternion::Identity();  ///< Part to body.
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
            {.in = Expressed::body_axes, .meaning = "Unit quaternion (w, x, y, z), part to body."}}};
};

struct Compound {
  std::vector<Part> parts;
};
template <>
struct Element<Compound> {
  static constexpr std::string_view name = "compound";
  static constexpr std::tuple fields{
      Field{"parts", &Compound::parts, {.required = true, .meaning = "Shapes rigidly joined: one or more."}}};
};

using Shape =
    std::variant<std::monostate, Sphere, Box, Capsule, Cylinder, Cone, Rod, Disc, Hull, Mesh, Compound>;

}  // namespace cylon::core
