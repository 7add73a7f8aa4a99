// Keys of a file that follow from the tables of core::Element.
#pragma once

#include "harness/core/fields.h"
#include "harness/scenario/keys.h"

#include <fmt/format.h>

#include <type_traits>

namespace cylon::scenario {

/// What a member looks like in a file.
template <class Value>
constexpr Kind kind_of() {
  using Points = std::vector<core::Vector3>;
  using Triangles = std::vector<std::array<std::int32_t, 3>>;
  constexpr auto is = []<class... Types>(std::type_identity<Types>...) {
    return (std::is_same_v<Value, Types> || ...);
  };
  using std::type_identity;
  if constexpr (is(type_identity<double>{}, type_identity<std::optional<double>>{}))
    return Kind::number;
  else if constexpr (is(type_identity<bool>{}))
    return Kind::boolean;
  else if constexpr (is(type_identity<core::Vector3>{}, type_identity<std::optional<core::Vector3>>{}))
    return Kind::vector;
  else if constexpr (is(type_identity<core::Quaternion>{}))
    return Kind::quaternion;
  else if constexpr (is(type_identity<core::Matrix3>{}))
    return Kind::moments;
  else if constexpr (is(type_identity<std::vector<double>>{}))
    return Kind::numbers;
  else if constexpr (is(type_identity<Points>{}))
    return Kind::points;
  else if constexpr (is(type_identity<Triangles>{}))
    return Kind::triangles;
  else if constexpr (is(type_identity<std::string[2]>{}))
    return Kind::pair;
  else if constexpr (is(type_identity<std::vector<std::string>>{}, type_identity<std::vector<int>>{}))
    return Kind::texts;
  else if constexpr (is(type_identity<core::NamedNumbers>{}))
    return Kind::named;
  else if constexpr (is(type_identity<std::vector<core::Part>>{},
                        type_identity<std::vector<core::JointDisplacement>>{},
                        type_identity<std::vector<core::JointAngle>>{}))
    return Kind::tables;
  else if constexpr (is(type_identity<core::Shape>{}, type_identity<core::Primitive>{}))
    return Kind::table;
  else {
    static_assert(is(type_identity<int>{}, type_identity<std::string>{}, type_identity<core::JointType>{},
                     type_identity<core::Ordinal>{}),
                  "say what a member of this type looks like in a file");
    return Kind::text;
  }
}

/// A value of a new element as a file would state it; empty where a file could not.
template <class Value>
std::string initial_text(const Value& value) {
  if constexpr (std::is_same_v<Value, double> || std::is_same_v<Value, bool>)
    return fmt::format("{}", value);
  else if constexpr (std::is_same_v<Value, core::Vector3>)
    return fmt::format("[{}, {}, {}]", value.x(), value.y(), value.z());
  else if constexpr (std::is_same_v<Value, core::Quaternion>)
    return fmt::format("[{}, {}, {}, {}]", value.w(), value.x(), value.y(), value.z());
  else if constexpr (std::is_same_v<Value, std::string>)
    return value;
  else if constexpr (std::is_enum_v<Value>)
    return std::string(core::Words<Value>::list[static_cast<std::size_t>(value)]);
  else
    return {};
}

/// The keys of an element in the order of its table; tables inside it have no keys yet.
template <class T>
std::vector<Key> keys_of() {
  std::vector<Key> keys;
  const T initial{};
  core::for_each_field(initial, [&]<class Value>(const auto& field, const Value& value) {
    const core::About& about = field.about;
    if constexpr (std::is_same_v<Value, core::BodyState>) {
      for (Key& key : keys_of<core::BodyState>()) keys.push_back(std::move(key));
    } else {
      const bool is_optional = about.later || core::may_be_absent<Value> ||
                               std::is_same_v<Value, std::vector<core::JointDisplacement>> ||
                               std::is_same_v<Value, std::vector<core::JointAngle>> ||
                               std::is_same_v<Value, core::Shape> ||
                               (std::is_same_v<Value, int> && !about.required) || !about.pin.empty();
      Key key{.name = std::string(field.key),
              .kind = kind_of<Value>(),
              .meaning = std::string(about.meaning),
              .unit = std::string(about.unit),
              .absent = std::string(about.absent),
              .required = about.required,
              .worker = is_optional ? "optional" : "always",
              .range = about.range};
      for (const std::string_view word : about.words)
        if (!word.empty()) key.choices.emplace_back(word);
      if constexpr (std::is_enum_v<Value>)
        key.choices.assign(core::Words<Value>::list.begin(), core::Words<Value>::list.end());
      if (!about.pin.empty()) {
        Key pin = key;
        pin.name = about.pin, pin.meaning = about.pin_meaning;
        keys.push_back(std::move(pin));
      }
      if (!key.required && !field.applies && key.absent.empty()) key.absent = initial_text(value);
      keys.push_back(std::move(key));
    }
  });
  return keys;
}

/// The table of an element that needs no other keys; `label` as in the file.
template <class T>
const Spec* spec_of() {
  static const Spec spec{
      .label = fmt::format(std::is_same_v<T, core::Frame> ? "[{}]" : "[[{}]]", core::Element<T>::name),
      .keys = keys_of<T>()};
  return &spec;
}

}  // namespace cylon::scenario
