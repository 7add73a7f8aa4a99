// shape = { type = … } -> core::Shape.
#include "harness/scenario/budget.h"
#include "harness/scenario/draft.h"
#include "harness/scenario/read_element.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace cylon::scenario {
namespace {

// The library and this define must agree, or every coordinate is garbage.
static_assert(std::is_same_v<tinyobj::real_t, double>);

// Vertices and triangles of an OBJ file's text; polygons are cut into triangles, materials ignored.  Throws
// std::invalid_argument for text that is no OBJ or that holds no face.
core::Mesh parse_obj(const std::string& text) {
  tinyobj::ObjReaderConfig config;
  config.triangulate = true;
  config.vertex_color = false;
  tinyobj::ObjReader reader;
  if (!reader.ParseFromString(text, "", config)) throw std::invalid_argument("no OBJ: " + reader.Error());
  core::Mesh mesh;
  const auto& coordinates = reader.GetAttrib().vertices;
  for (std::size_t i = 0; i + 2 < coordinates.size(); i += 3) {
    const core::Vector3 vertex(coordinates[i], coordinates[i + 1], coordinates[i + 2]);
    if (!vertex.allFinite()) throw std::invalid_argument(fmt::format("vertex {} is not finite", i / 3 + 1));
    mesh.vertices.push_back(vertex);
  }
  for (const auto& shape : reader.GetShapes()) {
    const auto& indices = shape.mesh.indices;
    for (std::size_t i = 0; i + 2 < indices.size(); i += 3)
      mesh.faces.push_back(
          {indices[i].vertex_index, indices[i + 1].vertex_index, indices[i + 2].vertex_index});
  }
  if (mesh.faces.empty()) throw std::invalid_argument("no OBJ: it holds no face");
  return mesh;
}

core::Mesh mesh(const Table& table, Draft& draft) {
  if (table.has("file") == (table.has("vertices") || table.has("faces")))
    table.fail("a mesh needs either 'file' or both 'vertices' and 'faces'");
  core::Mesh result;
  if (table.has("file")) {
    try {
      result = parse_obj(draft.read(table, "file"));
    } catch (const std::invalid_argument& error) {
      table.fail("file", fmt::format("{}: {}", table.text("file"), error.what()));
    }
  } else {
    if (!table.has("vertices") || !table.has("faces")) table.fail("a mesh needs 'vertices' and 'faces'");
    result.vertices = read_points(table, "vertices");
    for (const auto& row : table.rows("faces")) {
      for (const double i : row)
        if (!(i >= 0 && i < static_cast<double>(result.vertices.size())))
          table.fail("faces",
                     fmt::format("faces: index {} is outside 0 … {}", i, result.vertices.size() - 1));
      result.faces.push_back({static_cast<std::int32_t>(row[0]), static_cast<std::int32_t>(row[1]),
                              static_cast<std::int32_t>(row[2])});
    }
  }
  if (result.vertices.empty() || result.faces.empty()) table.fail("a mesh needs vertices and faces");
  for (const auto& face : result.faces)
    for (const std::int32_t i : face)
      if (i < 0 || static_cast<std::size_t>(i) >= result.vertices.size())
        table.fail("file", fmt::format("{}: a face names vertex {}, but there are {}", table.text("file"),
                                       static_cast<std::int64_t>(i) + 1, result.vertices.size()));
  const double scale = table.number("scale", 1);
  for (core::Vector3& vertex : result.vertices) vertex *= scale;
  return result;
}

core::Primitive primitive(const Table& table, Draft& draft) {
  const std::string type = table.text("type");
  core::Primitive result;
  core::for_each_shape<core::Primitive>([&]<class Kind>() {
    if (type != core::Element<Kind>::name) return;
    if constexpr (std::is_same_v<Kind, core::Mesh>)
      result = mesh(table, draft);
    else
      result = read_element<Kind>(table, draft);
    if constexpr (std::is_same_v<Kind, core::Hull>) {
      const std::size_t points = std::get<core::Hull>(result).vertices.size();
      if (points < 4)
        table.fail("vertices", fmt::format("vertices: a hull needs four points or more, but has {}", points));
      draft.hull_work += static_cast<double>(points) * static_cast<double>(points);
      if (draft.hull_work > budget::hull_work)
        table.fail("vertices",
                   fmt::format("vertices: the hulls of this scenario have too many points, the last one {}",
                               points));
    }
  });
  return result;
}

}  // namespace

core::Shape read_shape(const Table& table, Draft& draft) {
  if (table.text("type") != "compound")
    return std::visit([](auto&& shape) { return core::Shape(shape); }, primitive(table, draft));
  core::Compound compound;
  for (const Table& table_of_part : table.tables("parts", "a part of a compound")) {
    auto& part = compound.parts.emplace_back(read_element<core::Part>(table_of_part, draft));
    part.shape = primitive(table_of_part, draft);
  }
  if (compound.parts.empty()) table.fail("parts", "a compound needs one part or more");
  return compound;
}

core::Quaternion read_orientation(const Table& table, std::string_view key) {
  if (!table.has(key)) return core::Quaternion::Identity();
  const std::vector<double> v = table.numbers(key);
  const core::Quaternion q(v[0], v[1], v[2], v[3]);
  if (std::abs(q.norm() - 1) <= 1e-9) return q.normalized();
  if (!(q.norm() > 0) || !std::isfinite(q.norm()))
    table.fail(key,
               fmt::format("{} has the norm {}, but must be a unit quaternion (w, x, y, z)", key, q.norm()));
  const core::Quaternion u(q.coeffs() / q.norm());
  table.fail(key, fmt::format("{} has the norm {}, but must be a unit quaternion (w, x, y, z) within 1e-9; "
                              "normalised: [{}, {}, {}, {}]",
                              key, q.norm(), u.w(), u.x(), u.y(), u.z()));
}

}  // namespace cylon::scenario
