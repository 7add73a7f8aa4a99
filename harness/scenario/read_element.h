// The members of an element from its table in a file, by the tables of core::Element.
#pragma once

#include "harness/core/fields.h"
#include "harness/scenario/draft.h"

#include <string>
#include <type_traits>
#include <vector>

namespace cylon::scenario {

/// Points of hulls and meshes.
inline std::vector<core::Vector3> read_points(const Table& table, std::string_view key) {
  std::vector<core::Vector3> points;
  for (const std::vector<double>& row : table.rows(key)) points.emplace_back(row[0], row[1], row[2]);
  return points;
}

template <class T>
T read_element(const Table& table, const Draft& draft);

/// All tables of one kind inside another.
template <class T>
std::vector<T> read_elements(const Table& table, const Draft& draft) {
  std::vector<T> elements;
  for (const Table& inside : table.tables(core::Element<T>::name))
    elements.push_back(read_element<T>(inside, draft));
  return elements;
}

/// The element with the members that the file states, others as a new T has them.  Beside this are read: an
/// inertia, a shape, the parts of a compound and the faces of a mesh, of which other keys decide too.
template <class T>
T read_element(const Table& table, const Draft& draft) {
  T element;
  core::for_each_field(element, [&](const auto& field, auto& value) {
    using Value = std::remove_cvref_t<decltype(value)>;
    const std::string_view key = core::key_of(element, field);
    if constexpr (std::is_same_v<Value, double>) {
      value = table.number(key, value);
    } else if constexpr (std::is_same_v<Value, bool>) {
      value = table.boolean(key, value);
    } else if constexpr (std::is_same_v<Value, std::string>) {
      value = table.text(key, value);
    } else if constexpr (std::is_same_v<Value, int>) {
      value = field.about.required || table.has(key) ? draft.body(table, key) : core::world;
    } else if constexpr (std::is_same_v<Value, std::vector<int>>) {
      for (const std::string& name : table.texts(key)) value.push_back(draft.body(table, key, name));
    } else if constexpr (std::is_same_v<Value, core::NamedNumbers>) {
      if (const auto inside = table.table(key))
        for (auto&& [name, number] : inside->raw())
          value[std::string(name.str())] = inside->number(name.str());
    } else if constexpr (std::is_same_v<Value, core::Vector3>) {
      value = table.vector(key, value);
    } else if constexpr (std::is_same_v<Value, std::optional<core::Vector3>>) {
      if (table.has(key)) value = table.vector(key);
    } else if constexpr (std::is_same_v<Value, std::optional<double>>) {
      if (table.has(key)) value = table.number(key);
    } else if constexpr (std::is_same_v<Value, std::vector<double>>) {
      value = table.numbers(key);
    } else if constexpr (std::is_same_v<Value, std::vector<core::JointDisplacement>>) {
      value = read_elements<core::JointDisplacement>(table, draft);
    } else if constexpr (std::is_same_v<Value, std::vector<core::JointAngle>>) {
      value = read_elements<core::JointAngle>(table, draft);
    } else if constexpr (std::is_same_v<Value, core::Quaternion>) {
      value = read_orientation(table, key);
    } else if constexpr (std::is_same_v<Value, core::BodyState>) {
      value = read_element<core::BodyState>(table, draft);
    } else if constexpr (std::is_same_v<Value, std::vector<core::Vector3>>) {
      if (table.has(key)) value = read_points(table, key);
    } else if constexpr (std::is_same_v<Value, std::string[2]>) {
      const std::vector<std::string> pair = table.texts(key);
      value[0] = pair[0], value[1] = pair[1];
    } else if constexpr (std::is_same_v<Value, std::vector<std::string>>) {
      value = table.texts(key);
    } else if constexpr (std::is_enum_v<Value>) {
      const auto& words = core::Words<Value>::list;
      value = table.choice(key, {words.begin(), words.end()}, value);
    } else {
      static_assert(std::is_same_v<Value, core::Matrix3> || std::is_same_v<Value, core::Shape> ||
                        std::is_same_v<Value, core::Primitive> ||
                        std::is_same_v<Value, std::vector<core::Part>> ||
                        std::is_same_v<Value, std::vector<std::array<std::int32_t, 3>>>,
                    "say how a member of this type is read");
    }
  });
  return element;
}

}  // namespace cylon::scenario
