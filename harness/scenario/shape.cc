// shape = { type = … } -> core::Shape.
#include "harness/scenario/draft.h"
#include "harness/scenario/mesh.h"

#include <fmt/format.h>

#include <cmath>
#include <functional>
#include <map>
#include <stdexcept>

namespace cylon::scenario {
namespace {

std::vector<core::Vector3> points(const Table& table) {
  std::vector<core::Vector3> result;
  for (const auto& row : table.rows("vertices")) result.emplace_back(row[0], row[1], row[2]);
  return result;
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
    result.vertices = points(table);
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
  const double scale = table.number("scale", 1);
  for (core::Vector3& vertex : result.vertices) vertex *= scale;
  return result;
}

core::Primitive primitive(const Table& t, Draft& draft) {
  using Make = std::function<core::Primitive(const Table&, Draft&)>;
  const auto radius = [](const Table& s) { return s.number("radius"); };
  const auto length = [](const Table& s) { return s.number("length"); };
  static const std::map<std::string, Make> rows = {
      {"sphere", [=](const Table& s, Draft&) { return core::Sphere{radius(s)}; }},
      {"box", [=](const Table& s, Draft&) { return core::Box{s.vector("half_extents")}; }},
      {"capsule",
       [=](const Table& s, Draft&) {
         return core::Capsule{radius(s), length(s)};
       }},
      {"cylinder",
       [=](const Table& s, Draft&) {
         return core::Cylinder{radius(s), length(s)};
       }},
      {"cone",
       [=](const Table& s, Draft&) {
         return core::Cone{radius(s), length(s)};
       }},
      {"rod", [=](const Table& s, Draft&) { return core::Rod{length(s)}; }},
      {"disc", [=](const Table& s, Draft&) { return core::Disc{radius(s)}; }},
      {"hull", [=](const Table& s, Draft&) { return core::Hull{points(s)}; }},
      {"mesh", [=](const Table& s, Draft& d) { return mesh(s, d); }},
  };
  return rows.at(t.text("type"))(t, draft);
}

}  // namespace

core::Shape read_shape(const Table& table, Draft& draft) {
  if (table.text("type") != "compound")
    return std::visit([](auto&& shape) { return core::Shape(shape); }, primitive(table, draft));
  core::Compound compound;
  for (const Table& part : table.tables("parts", "a part of a compound"))
    compound.parts.push_back({primitive(part, draft), part.number("mass"), part.vector("position"),
                              read_orientation(part, "orientation")});
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
