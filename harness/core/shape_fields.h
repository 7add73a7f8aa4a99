// The tables of fields of shapes; see fields.h.
#pragma once

#include "harness/core/field.h"
#include "harness/core/scene.h"

#include <string_view>
#include <tuple>

namespace cylon::core {

namespace field_tables {
inline constexpr About radius{.unit = "m", .range = positive, .required = true, .meaning = "Radius."};
inline constexpr About length{.unit = "m",
                              .range = positive,
                              .required = true,
                              .meaning = "Length along body y; of a capsule, of its cylinder."};
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
      Field{"vertices",
            &Mesh::vertices,
            {.unit = "m", .in = Expressed::body_axes, .meaning = "Corners of the closed surface."}},
      Field{"faces",
            &Mesh::faces,
            {.meaning = "Triples of indices from 0, counter-clockwise seen from outside."}}};
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
template <>
struct Element<Compound> {
  static constexpr std::string_view name = "compound";
  static constexpr std::tuple fields{
      Field{"parts", &Compound::parts, {.required = true, .meaning = "Shapes rigidly joined: one or more."}}};
};

}  // namespace cylon::core
