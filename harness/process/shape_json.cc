#include "harness/process/shape_json.h"

#include "harness/process/json_fields.h"

#include <fmt/format.h>

#include <array>
#include <limits>

namespace cylon::process {
namespace {

using core::Vector3;
using nlohmann::json;

json vertices_json(const std::vector<Vector3>& vertices) {
  json result = json::array();
  for (const Vector3& v : vertices) result.push_back(vector_json(v));
  return result;
}

json write(std::monostate) { return nullptr; }
json write(const core::Sphere& s) { return {{"type", "sphere"}, {"radius", s.radius}}; }
json write(const core::Box& s) { return {{"type", "box"}, {"half_extents", vector_json(s.half_extents)}}; }
json write(const core::Capsule& s) {
  return {{"type", "capsule"}, {"radius", s.radius}, {"length", s.length}};
}
json write(const core::Cylinder& s) {
  return {{"type", "cylinder"}, {"radius", s.radius}, {"length", s.length}};
}
json write(const core::Cone& s) { return {{"type", "cone"}, {"radius", s.radius}, {"length", s.length}}; }
json write(const core::Rod& s) { return {{"type", "rod"}, {"length", s.length}}; }
json write(const core::Disc& s) { return {{"type", "disc"}, {"radius", s.radius}}; }
json write(const core::Hull& s) { return {{"type", "hull"}, {"vertices", vertices_json(s.vertices)}}; }
json write(const core::Mesh& s) {
  return {{"type", "mesh"}, {"vertices", vertices_json(s.vertices)}, {"faces", s.faces}};
}
json write(const core::Compound& s) {
  json parts = json::array();
  for (const core::Part& part : s.parts)
    parts.push_back({{"shape", std::visit([](const auto& p) { return write(p); }, part.shape)},
                     {"mass", part.mass},
                     {"position", vector_json(part.position)},
                     {"orientation", quaternion_json(part.orientation)}});
  return {{"type", "compound"}, {"parts", std::move(parts)}};
}

std::vector<Vector3> vertices(Fields& fields) {
  std::vector<Vector3> result;
  fields.each("vertices", [&](const json& row, const std::string& place) {
    const std::vector<double> v = numbers(row, 3, place);
    result.emplace_back(v[0], v[1], v[2]);
  });
  return result;
}

core::Mesh mesh(Fields& fields) {
  core::Mesh result{vertices(fields), {}};
  fields.each("faces", [&](const json& row, const std::string& place) {
    if (!row.is_array() || row.size() != 3) throw MalformedMessage(place + ": expected three vertices");
    std::array<std::int32_t, 3> face;
    for (std::size_t i = 0; i < 3; ++i) {
      const auto count = static_cast<std::int64_t>(result.vertices.size());
      if (!row[i].is_number_integer() || row[i].get<std::int64_t>() < 0 ||
          row[i].get<std::int64_t>() >= count)
        throw MalformedMessage(fmt::format("{}: a vertex is an index below {}", place, count));
      face[i] = row[i].get<std::int32_t>();
    }
    result.faces.push_back(face);
  });
  return result;
}

core::Compound compound(Fields&);

// One row per type word; `Any` is Shape, or Primitive for the parts of a compound.
template <class Any>
Any read(const json& value, const std::string& place) {
  if (value.is_null()) return std::monostate{};
  Fields f(value, place);
  struct Type {
    const char* word;
    Any (*make)(Fields&);
  };
  static constexpr Type types[] = {
      {"sphere", [](Fields& g) -> Any { return core::Sphere{g.number("radius")}; }},
      {"box", [](Fields& g) -> Any { return core::Box{g.vector("half_extents")}; }},
      {"capsule",
       [](Fields& g) -> Any {
         return core::Capsule{g.number("radius"), g.number("length")};
       }},
      {"cylinder",
       [](Fields& g) -> Any {
         return core::Cylinder{g.number("radius"), g.number("length")};
       }},
      {"cone",
       [](Fields& g) -> Any {
         return core::Cone{g.number("radius"), g.number("length")};
       }},
      {"rod", [](Fields& g) -> Any { return core::Rod{g.number("length")}; }},
      {"disc", [](Fields& g) -> Any { return core::Disc{g.number("radius")}; }},
      {"hull", [](Fields& g) -> Any { return core::Hull{vertices(g)}; }},
      {"mesh", [](Fields& g) -> Any { return mesh(g); }},
      {"compound",
       [](Fields& g) -> Any {
         if constexpr (std::is_same_v<Any, core::Shape>) return compound(g);
         g.fail("type", "a compound has no compounds among its parts");
       }},
  };
  const std::string word = f.text("type");
  for (const Type& type : types) {
    if (word != type.word) continue;
    Any shape = type.make(f);
    f.finish();
    return shape;
  }
  f.fail("type", fmt::format("unknown shape '{}'", word));
}

core::Compound compound(Fields& fields) {
  core::Compound result;
  fields.each("parts", [&](const json& row, const std::string& place) {
    Fields f(row, place);
    result.parts.push_back({read<core::Primitive>(f.at("shape"), f.place_of("shape")), f.number("mass"),
                            f.vector("position"), f.quaternion("orientation")});
    f.finish();
  });
  return result;
}

}  // namespace

json vector_json(const Vector3& v) { return {v.x(), v.y(), v.z()}; }
json quaternion_json(const core::Quaternion& q) { return {q.w(), q.x(), q.y(), q.z()}; }

json shape_json(const core::Shape& shape) {
  return std::visit([](const auto& s) { return write(s); }, shape);
}

core::Shape shape_from_json(const json& value, const std::string& place) {
  return read<core::Shape>(value, place);
}

}  // namespace cylon::process
