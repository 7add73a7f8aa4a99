#include "reference/simulators/in_house/in_house_shapes.h"

#include "engine/geometry/hull.h"
#include "harness/core/overloaded.h"

#include <stdexcept>
#include <vector>

namespace cylon::simulators {
namespace {

using engine::Real;
using Result = std::variant<engine::Shape, Missing>;

std::vector<engine::Vector3> points(const std::vector<core::Vector3>& vertices) {
  std::vector<engine::Vector3> result;
  result.reserve(vertices.size());
  for (const core::Vector3& v : vertices) result.push_back(v.cast<Real>());
  return result;
}

Result hull(const std::vector<engine::Vector3>& vertices) {
  try {
    return engine::Shape(engine::make_hull(vertices));
  } catch (const std::invalid_argument& error) {
    return "a hull of such points: " + std::string(error.what());
  }
}

Result mesh(const core::Mesh& mesh) {
  const std::vector<engine::Vector3> vertices = points(mesh.vertices);
  std::vector<std::array<int, 3>> triangles;
  for (const auto& face : mesh.faces) triangles.push_back({face[0], face[1], face[2]});
  if (!engine::is_convex(vertices, triangles)) return "a mesh that is not convex";
  return hull(vertices);
}

}  // namespace

Result in_house_shape(const core::Shape& shape) {
  const auto real = [](double x) { return static_cast<Real>(x); };
  return std::visit(
      core::Overloaded{
          [](const std::monostate&) -> Result { return engine::Shape(); },
          [&](const core::Sphere& s) -> Result { return engine::Shape(engine::Sphere{real(s.radius)}); },
          [](const core::Box& s) -> Result {
            return engine::Shape(engine::Box{s.half_extents.cast<Real>()});
          },
          [&](const core::Capsule& s) -> Result {
            return engine::Shape(engine::Capsule{real(s.radius), real(s.length / 2)});
          },
          [&](const core::Rod& s) -> Result {
            return engine::Shape(engine::Capsule{0, real(s.length / 2)});
          },
          [](const core::Hull& s) -> Result { return hull(points(s.vertices)); },
          [](const core::Mesh& s) -> Result { return mesh(s); },
          [](const core::Cylinder&) -> Result { return "a cylinder"; },
          [](const core::Cone&) -> Result { return "a cone"; },
          [](const core::Disc&) -> Result { return "a disc"; },
          [](const core::Compound&) -> Result { return "a compound"; },
      },
      shape);
}

}  // namespace cylon::simulators
