#include "reference/simulators/in_house/in_house_shapes.h"

#include "engine/geometry/hull.h"
#include "engine/geometry/pose.h"
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

Result mesh(const core::Mesh& mesh, bool locked) {
  const std::vector<engine::Vector3> vertices = points(mesh.vertices);
  std::vector<std::array<int, 3>> triangles;
  for (const auto& face : mesh.faces) triangles.push_back({face[0], face[1], face[2]});
  if (engine::is_convex(vertices, triangles)) return hull(vertices);
  if (!locked) return "a moving mesh that is not convex (a compound of its convex parts is none)";
  engine::Compound surface;
  for (const auto& t : triangles) {
    const auto at = [&](std::size_t k) { return vertices[static_cast<std::size_t>(t[k])]; };
    surface.parts.push_back(
        {engine::make_triangle({at(0), at(1), at(2)}), engine::Vector3::Zero(), engine::Matrix3::Identity()});
  }
  return engine::Shape(std::move(surface));
}

// Parts that are compounds themselves, as the surface of a mesh is, are taken apart.
Result compound(const core::Compound& compound, bool locked) {
  engine::Compound result;
  for (const core::Part& part : compound.parts) {
    auto shape =
        std::visit([&](const auto& s) { return in_house_shape(core::Shape(s), locked); }, part.shape);
    if (const Missing* what = std::get_if<Missing>(&shape)) return "a compound with " + *what;
    const engine::Pose at = {part.position.cast<Real>(), part.orientation.toRotationMatrix().cast<Real>()};
    engine::each_part(std::get<engine::Shape>(shape), at,
                      [&](int, const engine::Shape& convex, const engine::Pose& there) {
                        result.parts.push_back({convex, there.position, there.rotation});
                      });
  }
  return engine::Shape(std::move(result));
}

}  // namespace

Result in_house_shape(const core::Shape& shape, bool locked) {
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
          [&](const core::Mesh& s) -> Result { return mesh(s, locked); },
          [&](const core::Cylinder& s) -> Result {
            return engine::Shape(
                engine::Frustum{real(s.radius), real(s.radius), real(-s.length / 2), real(s.length / 2)});
          },
          [&](const core::Cone& s) -> Result {
            return engine::Shape(
                engine::Frustum{real(s.radius), 0, real(-s.length / 4), real(3 * s.length / 4)});
          },
          [](const core::Disc&) -> Result { return "a disc"; },
          [&](const core::Compound& s) -> Result { return compound(s, locked); },
      },
      shape);
}

}  // namespace cylon::simulators
