// The shapes that collide, as data.  Body axes; the reference point of the body is the origin.
#pragma once

#include "engine/vector.h"

#include <array>
#include <variant>
#include <vector>

namespace cylon::engine {

struct Sphere {
  Real radius = 0;  ///< [m], >= 0; 0 is a point.
};

struct Box {
  Vector3 half_extents = Vector3::Zero();  ///< [m], > 0.
};

/// All points within `radius` of the segment from (0, -half_length, 0) to (0, half_length, 0).
struct Capsule {
  Real radius = 0;       ///< [m], >= 0; 0 is a rod.
  Real half_length = 0;  ///< [m]
};

/// A convex polyhedron.  Made by make_hull.
struct Hull {
  std::vector<Vector3> vertices;          ///< [m]
  std::vector<std::vector<int>> faces;    ///< Plane polygons, counter-clockwise seen from outside.
  std::vector<Vector3> normals;           ///< Outward, unit; one per face.
  std::vector<std::array<int, 4>> edges;  ///< From vertex, to vertex, face on its left, face on its right.
  Real half_width =
      0;  ///< Half the way from a face to the vertex farthest behind it, the least [m]; of a triangle 0.
};

/// The convex hull of two discs across y: a cylinder, or a cone where one of them is a point.
struct Frustum {
  Real low_radius = 0, high_radius = 0;  ///< [m], >= 0, one of them > 0.
  Real low = 0, high = 0;                ///< y of the discs [m], low < high.
};

/// Convex shapes rigidly joined; they may overlap.
struct ShapePart;
struct Compound {
  std::vector<ShapePart> parts;
};

/// monostate: nothing can touch it.
using Shape = std::variant<std::monostate, Sphere, Box, Capsule, Hull, Frustum, Compound>;

struct ShapePart {
  Shape shape;                             ///< No compound.
  Vector3 position = Vector3::Zero();      ///< Of its reference point, axes of the body [m].
  Matrix3 rotation = Matrix3::Identity();  ///< Part to body.
};

/// A half-space, solid where normal . x < offset.
struct Plane {
  Vector3 normal = Vector3::UnitY();  ///< Unit.
  Real offset = 0;                    ///< [m]
};

}  // namespace cylon::engine
