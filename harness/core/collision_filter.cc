#include "harness/core/collision_filter.h"

#include "harness/core/surfaces.h"

#include <algorithm>
#include <set>
#include <stdexcept>

namespace cylon::core {
namespace {

using Names = std::vector<std::string>;

// The bit of a name, or none.
std::uint32_t bit(const Names& names, const std::string& name) {
  const auto at = std::ranges::find(names, name);
  return at == names.end() ? 0 : std::uint32_t{1} << (at - names.begin());
}

std::uint32_t bits(const Names& known, const Names& of) {
  std::uint32_t all = 0;
  for (const std::string& name : of) all |= bit(known, name);
  return all;
}

template <class Thing>
CollisionFilter filter(const Names& known, const Thing& thing) {
  CollisionFilter result;
  if (!thing.collision_groups.empty()) result.groups = bits(known, thing.collision_groups);
  if (!thing.collision_mask.empty()) result.mask = bits(known, thing.collision_mask);
  return result;
}

template <class Thing>
bool states(const Thing& thing) {
  return !thing.collision_groups.empty() || !thing.collision_mask.empty();
}

void add(Names& known, const Names& groups) {
  for (const std::string& name : groups) {
    if (std::ranges::find(known, name) != known.end()) continue;
    if (known.size() == most_groups)
      throw std::invalid_argument("a scene has at most " + std::to_string(most_groups) +
                                  " collision groups, 'default' among them; '" + name + "' is one more");
    known.push_back(name);
  }
}

}  // namespace

CollisionFilters::CollisionFilters(const Scene& scene) : names{std::string(default_group)} {
  of_body.resize(scene.bodies.size()), of_plane.resize(scene.planes.size());
  for (const Body& body : scene.bodies) {
    if (!collides(body) || !states(body)) continue;
    stated = true;
    add(names, body.collision_groups);
  }
  for (const Plane& plane : scene.planes) {
    stated = stated || states(plane);
    add(names, plane.collision_groups);
  }
  if (!stated) return;
  for (std::size_t i = 0; i < of_body.size(); ++i)
    if (collides(scene.bodies[i])) of_body[i] = filter(names, scene.bodies[i]);
  for (std::size_t i = 0; i < of_plane.size(); ++i) of_plane[i] = filter(names, scene.planes[i]);
  std::set<CollisionFilter> different(of_plane.begin(), of_plane.end());
  different.insert(of_body.begin(), of_body.end());
  if (different.size() > most_filters)
    throw std::invalid_argument("a scene has at most " + std::to_string(most_filters) +
                                " different pairs of collision groups and mask; this one has " +
                                std::to_string(different.size()));
}

bool states_filters(const Scene& scene) {
  return std::ranges::any_of(scene.bodies, states<Body>) || std::ranges::any_of(scene.planes, states<Plane>);
}

ContactRules::ContactRules(const Scene& scene) : jointed_(jointed_pairs(scene)), filters_(scene) {
  for (const Body& body : scene.bodies) locked_.push_back(body.locked);
}

bool ContactRules::bodies(int a, int b) const {
  const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
  return !(locked_[i] && locked_[j]) && may_meet(filters_.of_body[i], filters_.of_body[j]) &&
         !std::binary_search(jointed_.begin(), jointed_.end(), std::array{std::min(a, b), std::max(a, b)});
}

bool ContactRules::body_and_plane(int body, int plane) const {
  const auto i = static_cast<std::size_t>(body);
  return !locked_[i] && may_meet(filters_.of_body[i], filters_.of_plane[static_cast<std::size_t>(plane)]);
}

}  // namespace cylon::core
