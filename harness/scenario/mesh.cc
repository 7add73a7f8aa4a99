#include "harness/scenario/mesh.h"

#include <tiny_obj_loader.h>

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <type_traits>

namespace cylon::scenario {

// The library and this define must agree, or every coordinate is garbage.
static_assert(std::is_same_v<tinyobj::real_t, double>);

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

}  // namespace cylon::scenario
