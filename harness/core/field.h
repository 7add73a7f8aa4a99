// What can be said of one member of an element of a scene, and how the members of an element are visited.
// Knows no element; their tables are in fields.h.
#pragma once

#include "harness/core/range.h"

#include <array>
#include <string_view>
#include <tuple>
#include <type_traits>

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
  bool tunable = false;   ///< The viewer may change it while the scene runs.
  std::string_view meaning = {};
  std::string_view pin = {};  ///< Key of the other end where it is a place of the world.
  std::string_view pin_meaning = {};
  std::array<std::string_view, 4> words = {};  ///< Values of a text; trailing empty ones do not count.
};

/// One member of an element.  An int is the index of a body, which files and workers call by its name.
template <class Owner, class Member>
struct Field {
  using Value = Member;
  constexpr Field(std::string_view k, Member Owner::*m, const About& a) : key(k), member(m), about(a) {}

  std::string_view key;
  Member Owner::*member;
  About about;
};

/// The table of one element: `name`, as in files, and `fields`, in the order of files.
template <class T>
struct Element;

/// Calls visit(field, value) for each member in the order of the table.
template <class T, class Visit>
constexpr void for_each_field(T& element, Visit&& visit) {
  std::apply([&](const auto&... field) { (visit(field, element.*field.member), ...); },
             Element<std::remove_const_t<T>>::fields);
}

/// The words of an enumeration, in its order.
template <class Enum>
struct Words;

}  // namespace cylon::core
