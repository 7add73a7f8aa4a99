// How much one scenario may ask of its reader.  A file of 16 MB can name work without end; each limit here is
// some ten times what the largest useful scene needs, and keeps reading below seconds and a gigabyte.
#pragma once

#include "reference/certified/truth.h"

#include <cstddef>
#include <cstdint>

namespace cylon::scenario::budget {

inline constexpr std::size_t bodies = 1'000'000;
inline constexpr std::size_t name = 200;           ///< Of a body [bytes].
inline constexpr std::size_t points = 5'000'000;   ///< Of hulls and meshes, of all bodies together.
inline constexpr std::size_t points_of_part = 10;  ///< What a part of a compound counts for.
inline constexpr double hull_work = 4e8;           ///< Sum of the squares of the points of all hulls.
inline constexpr std::size_t gaps = 50'000'000;    ///< Points times planes, looked at for overlaps.
// A plane of a million spheres looks at more than 16 million.
inline constexpr std::size_t neighbours = 18'000'000;   ///< Spheres and blocks of a grid.
inline constexpr std::size_t material_pairs = 100'000;  ///< Pairs that materials list.
inline constexpr std::size_t material_names = 4'000;    ///< Bodies and planes that materials name.
inline constexpr std::size_t claims = 1'000;
inline constexpr std::size_t bodies_of_truth = 2'000;  ///< Of a scene that an exact solution serves.
inline constexpr double truth_work = 80 * certified::work_per_second;  ///< Of all certified truths.
inline constexpr double soon = 2 * certified::work_per_second;  ///< Of those that are solved to validate.
inline constexpr std::size_t data_events = 20'000;              ///< Of recorded data.
inline constexpr std::size_t data_states = 2'000'000;  ///< Times of recorded data, times bodies of the scene.
inline constexpr std::size_t truth_entries = 2'000'000;  ///< Events and times of the truths of all claims.
inline constexpr std::size_t truth_looks = 1'000'000;    ///< States of bodies, searched for events of truths.
inline constexpr std::uintmax_t files = 128u << 20;      ///< Read by one scenario [bytes].

}  // namespace cylon::scenario::budget
