// Which surface meets which with what material, without asking pair by pair: a scene may have 10^5 bodies.
#pragma once

#include "harness/core/scene.h"

#include <array>
#include <optional>
#include <vector>

namespace cylon::core {

/// Whether anything may touch the body.
bool collides(const Body&);

/// Pairs of bodies that a joint ties, the lower index first, in ascending order: neighbours in a mechanism,
/// which do not touch each other.
std::vector<std::array<int, 2>> jointed_pairs(const Scene&);

/// Bodies and planes in classes that no material of the scene tells apart, and one table over the classes.
struct Surfaces {
  std::vector<int> of_body;   ///< One per body: its class.
  std::vector<int> of_plane;  ///< One per plane.
  int count = 0;
  std::vector<int> table;      ///< count x count, symmetric: index into Scene::materials, or -1.
  std::vector<bool> disputed;  ///< Likewise: two patterns that name one of the pair each say other numbers.

  /// What material_of says of any pair of these classes: an index into Scene::materials, or -1 for none.
  int material(int one, int other) const { return table[at(one, other)]; }
  bool is_disputed(int one, int other) const { return disputed[at(one, other)]; }

 private:
  std::size_t at(int one, int other) const {
    return static_cast<std::size_t>(one) * static_cast<std::size_t>(count) + static_cast<std::size_t>(other);
  }
};

/// Two names are of one class when they stand in materials with the same partners and the same numbers; names
/// that no material mentions are one class.  O(bodies + materials + classes^2).
Surfaces surfaces(const Scene&);

/// A pair that may touch and of which the materials do not say how: none is stated for it, or two patterns, of which one
/// names the first and the other the second, say other numbers.
struct UnclearPair {
  Pair pair;
  bool disputed = false;
};

/// The first of touching_pairs for which no material is stated, or nothing.  As unclear_pair().
std::optional<Pair> pair_without_material(const Scene&);

/// The first of touching_pairs that is unclear, or nothing.  O(bodies + planes + classes^2) where there is none.
std::optional<UnclearPair> unclear_pair(const Scene&);

}  // namespace cylon::core
