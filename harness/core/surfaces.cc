#include "harness/core/surfaces.h"

#include "harness/core/collision_filter.h"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>

namespace cylon::core {
namespace {

// A row of the materials as one of its two names sees it: the partner, the row.
using Partners = std::vector<std::pair<std::string, int>>;

// What each name meets, in the order of the partners' names; of several rows for one pair the first counts.
std::map<std::string, Partners> partners(const Scene& scene) {
  std::map<std::string, Partners> result;
  for (std::size_t row = 0; row < scene.materials.size(); ++row) {
    const auto& [a, b] = scene.materials[row].between;
    result[a].emplace_back(b, static_cast<int>(row));
    if (a != b) result[b].emplace_back(a, static_cast<int>(row));
  }
  for (auto& [name, list] : result) {
    std::stable_sort(list.begin(), list.end(),
                     [](const auto& x, const auto& y) { return x.first < y.first; });
    const auto same = [](const auto& x, const auto& y) { return x.first == y.first; };
    list.erase(std::unique(list.begin(), list.end(), same), list.end());
  }
  return result;
}

int find(const Partners& list, const std::string& name) {
  const auto at = std::lower_bound(list.begin(), list.end(), name,
                                   [](const auto& entry, const std::string& n) { return entry.first < n; });
  return at != list.end() && at->first == name ? at->second : -1;
}

// Of two rows the one that stands first; -1 is none.
int first_of(int a, int b) { return a < 0 ? b : b < 0 ? a : std::min(a, b); }

// Partners with numbers in place of rows: equal for names that are of one class.  The row with "*" stays a
// row, because the first of two such rows decides.
using Signature = std::vector<std::tuple<std::string, double, double, int>>;

Signature signature(const Scene& scene, const Partners& list) {
  Signature result;
  for (const auto& [name, row] : list) {
    const Material& m = scene.materials[static_cast<std::size_t>(row)];
    result.emplace_back(name, m.restitution, m.friction, name == "*" ? row : 0);
  }
  return result;
}

}  // namespace

bool collides(const Body& body) {
  return body.collide && !std::holds_alternative<std::monostate>(body.shape);
}

std::vector<std::array<int, 2>> jointed_pairs(const Scene& scene) {
  std::vector<std::array<int, 2>> pairs;
  for (const Joint& joint : scene.joints)
    if (joint.to != world) pairs.push_back({std::min(joint.body, joint.to), std::max(joint.body, joint.to)});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  return pairs;
}

Surfaces surfaces(const Scene& scene) {
  const std::map<std::string, Partners> known = partners(scene);
  static const Partners nobody;
  const auto partners_of = [&](const std::string& name) -> const Partners& {
    const auto found = known.find(name);
    return found == known.end() ? nobody : found->second;
  };
  Surfaces result;
  std::map<Signature, int> classes;
  std::map<std::string, int> seen;           // class of each name that a material mentions
  std::vector<std::string> representatives;  // one name of each class
  const auto class_of = [&](const std::string& name) {
    if (const auto found = seen.find(name); found != seen.end()) return found->second;
    const auto [at, fresh] =
        classes.emplace(signature(scene, partners_of(name)), static_cast<int>(representatives.size()));
    if (fresh) representatives.push_back(name);
    if (known.contains(name)) seen.emplace(name, at->second);
    return at->second;
  };
  for (const Body& body : scene.bodies) result.of_body.push_back(class_of(body.name));
  for (const Plane& plane : scene.planes) result.of_plane.push_back(class_of(plane.name));
  result.count = static_cast<int>(representatives.size());

  const int fallback = find(partners_of("*"), "*");
  const auto row = [&](int k) -> const Material& { return scene.materials[static_cast<std::size_t>(k)]; };
  const auto decide = [&](const std::string& a, const std::string& b) {
    const Partners &of_a = partners_of(a), &of_b = partners_of(b);
    if (const int exact = find(of_a, b); exact >= 0) return std::pair(exact, false);
    const int one = find(of_a, "*"), other = find(of_b, "*");
    if (one < 0 && other < 0) return std::pair(fallback, false);
    const bool disputed =
        one >= 0 && other >= 0 &&
        (row(one).restitution != row(other).restitution || row(one).friction != row(other).friction);
    return std::pair(first_of(one, other), disputed);
  };
  const std::size_t count = representatives.size();
  result.table.resize(count * count), result.disputed.resize(count * count);
  for (std::size_t a = 0; a < count; ++a)
    for (std::size_t b = 0; b <= a; ++b) {
      const auto [material, disputed] = decide(representatives[a], representatives[b]);
      result.table[a * count + b] = result.table[b * count + a] = material;
      result.disputed[a * count + b] = result.disputed[b * count + a] = disputed;
    }
  return result;
}

namespace {

// The first of touching_pairs of whose classes that holds.
template <class Holds>
std::optional<Pair> first_pair(const Scene& scene, const Surfaces& classes, const Holds& holds) {
  const CollisionFilters filters(scene);
  struct Members {
    int moving = 0, all = 0, planes = 0;
  };
  using Kind = std::pair<int, CollisionFilter>;  // what materials and what masks tell apart
  std::map<Kind, Members> kinds;
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    if (!collides(scene.bodies[i])) continue;
    Members& members = kinds[{classes.of_body[i], filters.of_body[i]}];
    ++members.all;
    if (!scene.bodies[i].locked) ++members.moving;
  }
  for (std::size_t i = 0; i < scene.planes.size(); ++i)
    ++kinds[{classes.of_plane[i], filters.of_plane[i]}].planes;
  const auto found_in = [&](const auto& a, const auto& b) {
    const auto& [class_a, filter_a] = a.first;
    const auto& [class_b, filter_b] = b.first;
    if (a.second.moving == 0 || !holds(class_a, class_b) || !may_meet(filter_a, filter_b)) return false;
    return b.second.all > (&a == &b ? 1 : 0) || b.second.planes > 0;
  };
  const bool any = std::any_of(kinds.begin(), kinds.end(), [&](const auto& a) {
    return std::any_of(kinds.begin(), kinds.end(), [&](const auto& b) { return found_in(a, b); });
  });
  if (!any) return std::nullopt;
  std::optional<Pair> found;
  any_touching_pair(scene, [&](const Pair& pair) {
    const int one = classes.of_body[static_cast<std::size_t>(pair.body)];
    const int other = pair.plane >= 0 ? classes.of_plane[static_cast<std::size_t>(pair.plane)]
                                      : classes.of_body[static_cast<std::size_t>(pair.other)];
    if (holds(one, other)) found = pair;
    return found.has_value();
  });
  return found;
}

}  // namespace

std::optional<Pair> pair_without_material(const Scene& scene) {
  const Surfaces classes = surfaces(scene);
  return first_pair(scene, classes, [&](int a, int b) { return classes.material(a, b) < 0; });
}

std::optional<UnclearPair> unclear_pair(const Scene& scene) {
  const Surfaces classes = surfaces(scene);
  for (const bool disputed : {false, true})
    if (const auto pair = first_pair(scene, classes, [&](int a, int b) {
          return disputed ? classes.is_disputed(a, b) : classes.material(a, b) < 0;
        }))
      return UnclearPair{*pair, disputed};
  return std::nullopt;
}

}  // namespace cylon::core
