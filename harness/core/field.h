// What can be said of one member of an element of a scene, and how the members of an element are visited.
// Knows no element; their tables are in fields.h.
#pragma once

#include "harness/core/range.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <vector>

namespace cylon::core {

/// The frame in which a vector is expressed.
enum class Expressed {
  plain,         ///< No vector.
  world_point,   ///< A place: moves with the origin.
  world_vector,  ///< A direction or velocity in world axes.
  world_axial,   ///< World axes; changes sign in a mirror.
  body_axes,     ///< Axes of the body, from its centre of mass.
  other_end      ///< Axes of `to`; a place of the world where `to` is the world.
};

struct About {
  std::string_view unit = {};  ///< Of core::dimension, where `measured`.
  Expressed in = Expressed::plain;
  Range range = {};
  bool required = false;  ///< Files must state it; of a body reference also: it is not the world.
  bool later =
      false;  ///< Workers get it only where it is not what a new element has: older ones do not know it.
  bool tunable = false;  ///< The viewer may change it while the scene runs.
  /// Members of one rank > 0, larger by one factor, give the same phenomenon from another start and keep
  /// joints and contacts closed.  Lower ranks are tried first.
  int start_rank = 0;
  static constexpr int start_ranks = 3;
  std::string_view meaning = {};
  std::string_view absent = {};  ///< What an absent key means, where it is not the value of a new element.
  std::string_view pin = {};     ///< Key of the other end where it is a place of the world.
  std::string_view pin_meaning = {};
  std::array<std::string_view, 4> words = {};  ///< Values of a text; trailing empty ones do not count.
};

/// One member of an element.  An int is the index of a body, and several are those of bodies, which files and workers call
/// by name.
template <class Owner, class Member>
struct Field {
  using Value = Member;
  using When = bool (*)(const Owner&);
  constexpr Field(std::string_view k, Member Owner::*m, const About& a,
                  std::type_identity_t<When> w = nullptr)
      : key(k), member(m), about(a), applies(w) {}

  std::string_view key;
  Member Owner::*member;
  About about;
  When applies;  ///< To which elements the member belongs; null: to all.  Workers get it always.
};

/// The table of one element: `name`, as in files, and `fields`, in the order of files.  One with `later = true` workers get
/// only where the scene has it: older ones do not know it (core/later_parts.h).
template <class T>
struct Element;
template <class T>
inline constexpr bool comes_later = requires {
  Element<T>::later;
};

/// Calls visit(field, value) for each member in the order of the table.
template <class T, class Visit>
constexpr void for_each_field(T& element, Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field, element.*field.member), ...); },
             Element<std::remove_const_t<T>>::fields);
}

/// Names, words, flags and indices: the same in every unit and frame.
template <class Value>
inline constexpr bool is_word =
    std::is_integral_v<Value> || std::is_enum_v<Value> || std::is_same_v<Value, std::string> ||
    std::is_same_v<Value, std::string[2]> || std::is_same_v<Value, std::vector<std::string>> ||
    std::is_same_v<Value, std::vector<int>> ||
    std::is_same_v<Value, std::vector<std::array<std::int32_t, 3>>>;

/// Numbers that the user names, of units that nobody else knows.
using NamedNumbers = std::map<std::string, double>;

/// What workers get only where there is one.
template <class Value>
inline constexpr bool may_be_absent =
    std::is_same_v<Value, std::optional<Eigen::Vector3d>> || std::is_same_v<Value, std::optional<double>> ||
    std::is_same_v<Value, std::vector<double>> || std::is_same_v<Value, std::vector<std::string>>;

/// The words of an enumeration, in its order.
template <class Enum>
struct Words;

}  // namespace cylon::core
