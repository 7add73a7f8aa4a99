// Elements of a scene as JSON objects, both ways, by their tables of fields.  Bodies are called by name.
#pragma once

#include "harness/core/fields.h"
#include "harness/process/json_fields.h"
#include "harness/process/vector_json.h"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <unordered_map>

namespace cylon::process {

// ---- To JSON ------------------------------------------------------------------------------------

class ElementWriter {
 public:
  using Json = nlohmann::json;
  explicit ElementWriter(const core::Scene& scene) : scene_(scene) {}

  /// An object with every member.  Absent are: a body that is the world, an optional value, a list of names and
  /// a shape that are not there.  Throws std::invalid_argument where a body is the world and must not be.
  template <class T>
  Json operator()(const T& element) const {
    Json row = Json::object();
    add(row, element);
    return row;
  }

 private:
  template <class T>
  void add(Json& row, const T& element) const {
    core::for_each_field(element, [&](const auto& field, const auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      if constexpr (std::is_same_v<Value, core::BodyState>) {
        add(row, value);
      } else if constexpr (std::is_same_v<Value, int>) {
        if (value != core::world)
          row[core::key_of(element, field)] = scene_.bodies.at(static_cast<std::size_t>(value)).name;
        else if (field.about.required)
          throw std::invalid_argument(
              fmt::format("{}: '{}' must be a body", core::Element<T>::name, field.key));
      } else if constexpr (requires { value.has_value(); }) {
        if (value) row[field.key] = json(*value);
      } else if constexpr (core::may_be_absent<Value> ||
                           std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                           std::is_same_v<Value, std::vector<core::JointAngle>>) {
        if (!value.empty()) row[field.key] = json(value);
      } else if constexpr (std::is_same_v<Value, core::Shape>) {
        if (!std::holds_alternative<std::monostate>(value)) row[field.key] = json(value);
      } else {
        if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, std::string> ||
                      std::is_same_v<Value, core::Vector3>)
          if (field.about.later && is_new(value, T{}.*field.member)) return;
        row[core::key_of(element, field)] = json(value);
      }
    });
  }

  // To the bit: -0 is not 0.
  static bool is_new(double value, double initial) {
    return value == initial && std::signbit(value) == std::signbit(initial);
  }
  static bool is_new(const core::Vector3& value, const core::Vector3& initial) {
    return is_new(value.x(), initial.x()) && is_new(value.y(), initial.y()) && is_new(value.z(), initial.z());
  }
  static bool is_new(const std::string& value, const std::string& initial) { return value == initial; }

  Json json(double value) const { return value; }
  Json json(bool value) const { return value; }
  Json json(const std::string& value) const { return value; }
  Json json(const std::string (&pair)[2]) const { return {pair[0], pair[1]}; }
  Json json(const core::Vector3& v) const { return vector_json(v); }
  Json json(const core::Quaternion& q) const { return quaternion_json(q); }
  Json json(const core::Matrix3& m) const {
    Json rows = Json::array();
    for (int row = 0; row < 3; ++row)
      for (int column = 0; column < 3; ++column) rows.push_back(m(row, column));
    return rows;
  }
  template <class Enum>
  requires std::is_enum_v<Enum> Json json(Enum value)
  const { return core::Words<Enum>::list[static_cast<std::size_t>(value)]; }
  Json json(const std::array<std::int32_t, 3>& face) const { return face; }
  Json json(const std::vector<int>& bodies) const {
    Json names = Json::array();
    for (const int body : bodies) names.push_back(scene_.bodies.at(static_cast<std::size_t>(body)).name);
    return names;
  }
  Json json(const core::NamedNumbers& numbers) const { return numbers; }
  Json json(const core::Part& part) const { return (*this)(part); }
  Json json(const core::JointDisplacement& coordinate) const { return (*this)(coordinate); }
  Json json(const core::JointAngle& coordinate) const { return (*this)(coordinate); }
  template <class T>
  Json json(const std::vector<T>& values) const {
    Json rows = Json::array();
    for (const T& value : values) rows.push_back(json(value));
    return rows;
  }
  template <class... Kind>
  Json json(const std::variant<std::monostate, Kind...>& any) const {
    return std::visit(
        [&]<class Shape>(const Shape& shape) -> Json {
          if constexpr (std::is_same_v<Shape, std::monostate>) {
            return nullptr;
          } else {
            Json row = {{"type", core::Element<Shape>::name}};
            add(row, shape);
            return row;
          }
        },
        any);
  }

  const core::Scene& scene_;
};

// ---- From JSON ----------------------------------------------------------------------------------

/// Position of a text among the words; throws MalformedMessage.
template <std::size_t N>
std::size_t word(Fields& fields, const char* key, const std::array<std::string_view, N>& words) {
  const std::string text = fields.text(key);
  for (std::size_t i = 0; i < N; ++i)
    if (text == words[i]) return i;
  fields.fail(key, fmt::format("unknown value '{}'", text));
}

class ElementReader {
 public:
  /// Bodies by name; throws MalformedMessage where the name is taken.
  void name_body(Fields& fields, const std::string& name) {
    if (!index_.emplace(name, static_cast<int>(index_.size())).second)
      fields.fail("name", fmt::format("two bodies are named '{}'", name));
  }

  /// Every member of the element.  Throws MalformedMessage with the key.
  template <class T>
  void operator()(Fields& fields, T& element) const {
    core::for_each_field(element, [&](const auto& field, auto& value) {
      using Value = std::remove_cvref_t<decltype(value)>;
      const char* key = core::key_of(element, field).data();
      if constexpr (std::is_same_v<Value, core::BodyState>) {
        (*this)(fields, value);
      } else if constexpr (std::is_same_v<Value, int>) {
        if (field.about.required || fields.find(key))
          value = index(fields, key);
        else
          value = core::world;
      } else if constexpr (std::is_same_v<Value, core::Shape>) {
        if (const nlohmann::json* shape = fields.find(key))
          value = read_shape<core::Shape>(*shape, fields.place_of(key));
      } else if constexpr (std::is_same_v<Value, std::optional<core::Vector3>>) {
        if (fields.find(key)) value = fields.vector(key);
      } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
        if (fields.find(key)) value = fields.number(key);
      } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
        if (fields.find(key)) value = fields.numbers(key);
      } else if constexpr (std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                           std::is_same_v<Value, std::vector<core::JointAngle>>) {
        if (fields.find(key)) read_elements(fields, key, value);
      } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
        if (fields.find(key)) read_names(fields, key, value);
      } else if constexpr (std::is_same_v<Value, std::vector<std::array<std::int32_t, 3>>>) {
        read_faces(fields, key, element, value);
      } else {
        if (field.about.later && !fields.find(key)) return;
        read(fields, key, value);
      }
    });
  }

 private:
  int index(Fields& fields, const char* key) const { return index(fields, key, fields.text(key)); }
  int index(Fields& fields, const char* key, const std::string& name) const {
    const auto found = index_.find(name);
    if (found == index_.end()) fields.fail(key, fmt::format("no body is named '{}'", name));
    return found->second;
  }

  void read(Fields& f, const char* key, double& value) const { value = f.number(key); }
  void read(Fields& f, const char* key, bool& value) const { value = f.flag(key); }
  void read(Fields& f, const char* key, std::string& value) const { value = f.text(key); }
  void read(Fields& f, const char* key, core::Vector3& value) const { value = f.vector(key); }
  void read(Fields& f, const char* key, core::Quaternion& value) const { value = f.quaternion(key); }
  void read(Fields& f, const char* key, core::Matrix3& value) const {
    const std::vector<double> rows = f.numbers(key, 9);
    for (int i = 0; i < 9; ++i) value(i / 3, i % 3) = rows[static_cast<std::size_t>(i)];
  }
  template <class Enum>
  requires std::is_enum_v<Enum>
  void read(Fields& f, const char* key, Enum& value) const {
    value = static_cast<Enum>(word(f, key, core::Words<Enum>::list));
  }
  void read(Fields& f, const char* key, std::string (&pair)[2]) const {
    const nlohmann::json& names = f.at(key);
    if (!names.is_array() || names.size() != 2 || !names[0].is_string() || !names[1].is_string())
      f.fail(key, "expected two names");
    for (std::size_t i = 0; i < 2; ++i) pair[i] = names[i].get<std::string>();
  }
  void read(Fields& f, const char* key, std::vector<int>& bodies) const {
    std::vector<std::string> names;
    read_names(f, key, names);
    for (const std::string& name : names) bodies.push_back(index(f, key, name));
  }
  void read(Fields& f, const char* key, core::NamedNumbers& values) const {
    const nlohmann::json& object = f.at(key);
    if (!object.is_object()) f.fail(key, "expected an object");
    for (const auto& [name, value] : object.items()) {
      if (!value.is_number()) f.fail(fmt::format("{}.{}", key, name), "expected a number");
      values[name] = value.get<double>();
    }
  }
  void read(Fields& f, const char* key, core::Primitive& value) const {
    value = read_shape<core::Primitive>(f.at(key), f.place_of(key));
  }
  void read(Fields& f, const char* key, std::vector<core::Vector3>& values) const {
    f.each(key, [&](const nlohmann::json& row, const std::string& place) {
      const std::vector<double> v = numbers(row, 3, place);
      values.emplace_back(v[0], v[1], v[2]);
    });
  }
  void read(Fields& f, const char* key, std::vector<core::Part>& parts) const {
    read_elements(f, key, parts);
  }
  template <class T>
  void read_elements(Fields& f, const char* key, std::vector<T>& elements) const {
    f.each(key, [&](const nlohmann::json& row, const std::string& place) {
      Fields fields(row, place);
      (*this)(fields, elements.emplace_back());
      fields.finish();
    });
  }
  static void read_names(Fields& f, const char* key, std::vector<std::string>& names) {
    f.each(key, [&](const nlohmann::json& name, const std::string& place) {
      if (!name.is_string()) throw MalformedMessage(place + ": expected a name");
      names.push_back(name.get<std::string>());
    });
    if (names.empty()) f.fail(key, "expected one name at least");
  }
  template <class Mesh>
  static void read_faces(Fields&, const char* key, const Mesh&,
                         std::vector<std::array<std::int32_t, 3>>& faces);

  // {"type": "sphere", …}; null is no shape.
  template <class Any>
  Any read_shape(const nlohmann::json& value, const std::string& place) const {
    if (value.is_null()) return std::monostate{};
    Fields fields(value, place);
    const std::string type = fields.text("type");
    Any result;
    core::for_each_shape<Any>([&]<class Kind>() {
      if (type != core::Element<Kind>::name) return;
      Kind shape;
      (*this)(fields, shape);
      result = std::move(shape);
    });
    if (std::holds_alternative<std::monostate>(result)) {
      if (type == core::Element<core::Compound>::name)
        fields.fail("type", "a compound has no compounds among its parts");
      fields.fail("type", fmt::format("unknown shape '{}'", type));
    }
    fields.finish();
    return result;
  }

  std::unordered_map<std::string, int> index_;
};

template <class Mesh>
void ElementReader::read_faces(Fields& fields, const char* key, const Mesh& mesh,
                               std::vector<std::array<std::int32_t, 3>>& faces) {
  const auto count = static_cast<std::int64_t>(mesh.vertices.size());
  fields.each(key, [&](const nlohmann::json& row, const std::string& place) {
    if (!row.is_array() || row.size() != 3) throw MalformedMessage(place + ": expected three vertices");
    std::array<std::int32_t, 3>& face = faces.emplace_back();
    for (std::size_t i = 0; i < 3; ++i) {
      if (!row[i].is_number_integer() || row[i].get<std::int64_t>() < 0 ||
          row[i].get<std::int64_t>() >= count)
        throw MalformedMessage(fmt::format("{}: a vertex is an index below {}", place, count));
      face[i] = row[i].get<std::int32_t>();
    }
  });
}

}  // namespace cylon::process
