#include "engine/islands/islands.h"

#include "engine/geometry/pose.h"
#include "engine/islands/unions.h"

#include <algorithm>
#include <type_traits>

namespace cylon::engine::islands {

namespace {

bool has_surface(const Model& model, int body) {
  return !model.surfaces.empty() && model.surfaces[index(body)] != no_surface &&
         !std::holds_alternative<std::monostate>(model.shapes[index(body)]);
}

void sort_unique(std::vector<int>& list) {
  std::sort(list.begin(), list.end());
  list.erase(std::unique(list.begin(), list.end()), list.end());
}

// What two lists per cluster give together, ascending.
template <class List>
std::vector<int> gathered(const std::vector<Cluster>& clusters, const std::vector<std::size_t>& which,
                          List list) {
  std::vector<int> all;
  for (const std::size_t c : which) {
    const std::vector<int>& one = list(clusters[c]);
    all.insert(all.end(), one.begin(), one.end());
  }
  sort_unique(all);
  return all;
}

template <class T>
std::vector<T> picked(const std::vector<T>& whole, const std::vector<int>& which) {
  std::vector<T> part;
  if (whole.empty()) return part;
  part.reserve(which.size());
  for (const int i : which) part.push_back(whole[index(i)]);
  return part;
}

// Only the surfaces that are left, in their order, and their materials.
void number_surfaces(const Model& whole, Model& part) {
  std::vector<int> used = part.plane_surfaces;
  for (const int s : part.surfaces)
    if (s != no_surface) used.push_back(s);
  sort_unique(used);
  const auto place = [&](int s) {
    if (s == no_surface) return no_surface;
    return static_cast<int>(std::lower_bound(used.begin(), used.end(), s) - used.begin());
  };
  for (int& s : part.surfaces) s = place(s);
  for (int& s : part.plane_surfaces) s = place(s);
  for (const int a : used)
    for (const int b : used) part.materials.push_back(whole.material(a, b));
  part.surface_count = static_cast<int>(used.size());
}

}  // namespace

bool overlap(const Range& a, const Range& b) {
  const Real reach = a.ball.radius + a.shape + b.ball.radius + b.shape;
  return (a.ball.centre - b.ball.centre).squaredNorm() <= reach * reach;
}

Interactions::Interactions(const Model& model, Time dt)
    : model_(model),
      span_(static_cast<Time>(ahead) * dt),
      clusters_(find_clusters(model)),
      bounds_(find_bounds(model)),
      touching_(clusters_.size()) {
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i)
    if (model.bodies[index(i)].locked && has_surface(model, i)) obstacles_.push_back(i);
  std::size_t bodies = 0;
  for (std::size_t c = 0; c < clusters_.size(); ++c) {
    for (const int body : clusters_[c].bodies)
      if (has_surface(model, body)) touching_[c].push_back(body);
    if (!touching_[c].empty()) open_.push_back(c);
    bodies += touching_[c].size();
  }
  may_meet_ = open_.size() > 1 && bodies <= most_watched;
}

Range Interactions::range(int body, const Body& now, const Motion& motion, Real acceleration,
                          Real part) const {
  const Real t = part * static_cast<Real>(span_), shape = bounding_radius(model_.shapes[index(body)]);
  const Real g = model_.gravity_of(index(body)).norm();
  const Real travel = std::max(t * (velocity(now, motion).norm() + t / 2 * (g + acceleration)), shape);
  const std::optional<Ball>& bound = bounds_[index(body)];
  if (bound && bound->radius <= travel) return {*bound, shape, true};
  return {{motion.position, travel}, shape, false};
}

bool Interactions::may_meet(std::size_t a, std::size_t b, const std::vector<Range>& ranges) const {
  for (const int i : touching_[a])
    for (const int k : touching_[b])
      if (model_.may_touch(i, k) && overlap(ranges[index(i)], ranges[index(k)])) return true;
  return false;
}

std::vector<std::vector<std::size_t>> Interactions::groups(const std::vector<Range>& ranges,
                                                           const std::vector<std::size_t>& clusters) const {
  Unions unions(clusters.size());
  std::vector<std::size_t> open;  // that may touch others
  for (std::size_t i = 0; i < clusters.size(); ++i)
    if (!touching_[clusters[i]].empty()) open.push_back(i);
  for (std::size_t i = 0; i < open.size(); ++i) {
    if (!may_meet_) unions.join(open.front(), open[i]);
    for (std::size_t k = i + 1; may_meet_ && k < open.size(); ++k)
      if (unions.find(open[i]) != unions.find(open[k]) &&
          may_meet(clusters[open[i]], clusters[open[k]], ranges))
        unions.join(open[i], open[k]);
  }
  std::vector<std::vector<std::size_t>> groups;
  std::vector<std::size_t> group_of(clusters.size());
  for (std::size_t i = 0; i < clusters.size(); ++i) {
    const std::size_t first = unions.find(i);
    if (first == i) groups.emplace_back();
    group_of[i] = first == i ? groups.size() - 1 : group_of[first];
    groups[group_of[i]].push_back(clusters[i]);
  }
  return groups;
}

bool Interactions::reaches_plane(int body, int k) const {
  if (!model_.may_touch_plane(body, k)) return false;
  const std::optional<Ball>& bound = bounds_[index(body)];
  if (!bound) return true;
  const Plane& plane = model_.planes[index(k)];
  return plane.normal.dot(bound->centre) - plane.offset <=
         bound->radius + bounding_radius(model_.shapes[index(body)]);
}

bool Interactions::reaches(int body, int locked) const {
  if (!model_.may_touch(body, locked)) return false;
  const std::optional<Ball>& bound = bounds_[index(body)];
  if (!bound) return true;
  const Real reach = bound->radius + bounding_radius(model_.shapes[index(body)]) +
                     bounding_radius(model_.shapes[index(locked)]);
  return (bound->centre - model_.motions[index(locked)].position).norm() <= reach;
}

bool Interactions::may_touch(int a, int b) const {
  if (!model_.may_touch(a, b)) return false;
  const std::optional<Ball>&one = bounds_[index(a)], &other = bounds_[index(b)];
  if (!one || !other) return true;
  return overlap({*one, bounding_radius(model_.shapes[index(a)]), true},
                 {*other, bounding_radius(model_.shapes[index(b)]), true});
}

bool Interactions::flies(std::size_t which) const {
  const Cluster& cluster = clusters_[which];
  const int body = cluster.bodies.front();
  if (cluster.bodies.size() > 1 || !cluster.joints.empty() || model_.frame ||
      model_.bodies[index(body)].mass_rate != 0)
    return false;
  if (!std::all_of(cluster.forces.begin(), cluster.forces.end(),
                   [](const auto& list) { return list.empty(); }))
    return false;
  return touching_[which].empty() || (model_.planes.empty() && obstacles_.empty());
}

Part Interactions::flight(const std::vector<std::size_t>& which, const std::vector<Motion>& motions) const {
  Part part;
  for (const std::size_t c : which) part.bodies.push_back(clusters_[c].bodies.front());
  part.model.bodies = picked(model_.bodies, part.bodies);
  part.model.motions = picked(motions, part.bodies);
  part.model.shapes.resize(part.bodies.size());
  part.model.surfaces.assign(part.bodies.size(), no_surface);
  part.model.forces.gravity = model_.forces.gravity;
  return part;
}

Part Interactions::part(const std::vector<std::size_t>& which, const std::vector<Motion>& motions) const {
  const auto listed = [&](auto list) { return gathered(clusters_, which, list); };
  Part part;
  const std::vector<int> moving = listed([](const Cluster& c) -> auto& { return c.bodies; });
  const std::vector<int> holders = listed([](const Cluster& c) -> auto& { return c.holders; });

  // What touches and is touched in this part.
  std::vector<int> open, touched;
  for (const int body : moving)
    if (has_surface(model_, body)) open.push_back(body);
  const auto any_open = [&](auto reached) { return std::any_of(open.begin(), open.end(), reached); };
  for (std::size_t p = 0; p < model_.planes.size(); ++p)
    if (any_open([&](int body) { return reaches_plane(body, static_cast<int>(p)); }))
      part.planes.push_back(static_cast<int>(p));
  for (const int locked : obstacles_)
    if (any_open([&](int body) { return reaches(body, locked); })) touched.push_back(locked);
  part.bodies = moving;
  part.bodies.insert(part.bodies.end(), holders.begin(), holders.end());
  part.bodies.insert(part.bodies.end(), touched.begin(), touched.end());
  const std::vector<int> obstacles = touched;
  for (const int body : open) {
    const auto any_of = [](const std::vector<int>& list, auto what) {
      return std::any_of(list.begin(), list.end(), what);
    };
    if (any_of(part.planes, [&](int p) { return reaches_plane(body, p); }) ||
        any_of(obstacles, [&](int locked) { return reaches(body, locked); }) ||
        any_of(open, [&](int other) { return other != body && may_touch(body, other); }))
      touched.push_back(body);
  }
  sort_unique(part.bodies);
  sort_unique(touched);

  Model& model = part.model;
  const Numbering numbering(part.bodies);
  model.bodies = picked(model_.bodies, part.bodies);
  model.motions = picked(motions, part.bodies);
  model.shapes = picked(model_.shapes, part.bodies);
  model.surfaces = picked(model_.surfaces, part.bodies);
  for (std::size_t i = 0; i < model.surfaces.size(); ++i)
    if (!std::binary_search(touched.begin(), touched.end(), part.bodies[i])) model.surfaces[i] = no_surface;
  model.planes = picked(model_.planes, part.planes);
  model.plane_surfaces = picked(model_.plane_surfaces, part.planes);
  number_surfaces(model_, model);
  if (!touched.empty() && !model_.filters.empty()) {
    model.filters = picked(model_.filters, part.bodies);
    model.plane_filters = picked(model_.plane_filters, part.planes);
  }
  const auto here = [&](int body) {
    return std::binary_search(part.bodies.begin(), part.bodies.end(), body) &&
           std::binary_search(touched.begin(), touched.end(), body);
  };
  for (const BodyPair& pair : model_.apart)
    if (here(pair[0]) && here(pair[1])) model.apart.push_back({numbering(pair[0]), numbering(pair[1])});
  model.impacts = model_.impacts;
  model.frame = model_.frame;
  model.reduce_joints = model_.reduce_joints;

  model.joints = picked(model_.joints, listed([](const Cluster& c) -> auto& { return c.joints; }));
  for (Joint& joint : model.joints) joint.body = numbering(joint.body), joint.to = numbering(joint.to);
  model.forces.gravity = model_.forces.gravity;
  std::size_t kind = 0;
  const auto add = [&](auto list) {
    const std::vector<int> places = listed([&](const Cluster& c) -> auto& { return c.forces[kind]; });
    model.forces.*list = picked(model_.forces.*list, places);
    if constexpr (std::is_same_v<decltype(list), decltype(&Forces::coordinate_laws)>) part.laws = places;
    for (auto& force : model.forces.*list) force.renumber(numbering);
    ++kind;
  };
  std::apply([&](auto... list) { (add(list), ...); }, force_lists);
  return part;
}

}  // namespace cylon::engine::islands
