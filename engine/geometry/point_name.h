// What a contact point is called, so that it is found again in the next step.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <initializer_list>

namespace cylon::engine {

/// A place of a pair of cores.  Places that are not the same have one name by chance alone (1 in 2^32), and a place has one
/// name however it was found: what is carried over from step to step by name is then of the same point.
using PointName = std::uint32_t;

namespace point_name {

enum Kind : int { a_vertex, a_side_and_edge, a_corner, b_vertex, b_side_and_edge, b_corner, edges, axis };

inline PointName named(Kind kind, std::initializer_list<int> parts) {
  const auto mixed = [](PointName name, int part) {
    name = (name ^ static_cast<PointName>(part)) * 0x9e3779b1U;
    return name ^ name >> 15U;
  };
  PointName name = mixed(0x811c9dc5U, kind);
  for (const int part : parts) name = mixed(name, part);
  return name;
}

/// The vertices of both cores between which a gap is: a vertex over whatever it is over, or two edges.
inline PointName between(std::array<int, 2> of_a, std::array<int, 2> of_b) {
  if (of_a[0] == of_a[1]) return named(a_vertex, {of_a[0]});
  if (of_b[0] == of_b[1]) return named(b_vertex, {of_b[0]});
  return named(edges, {std::min(of_a[0], of_a[1]), std::max(of_a[0], of_a[1]), std::min(of_b[0], of_b[1]),
                       std::max(of_b[0], of_b[1])});
}

}  // namespace point_name
}  // namespace cylon::engine
