#include "reference/simulators/in_house/in_house_overlap.h"

#include "engine/geometry/pose.h"
#include "engine/geometry/separation.h"
#include "engine/islands/unions.h"
#include "harness/core/near_pairs.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace cylon::simulators {
namespace {

using engine::Model;
using engine::Real;

constexpr Real allowed = Real(0.1);  // of the least width

std::size_t index(int i) { return static_cast<std::size_t>(i); }

// A surface or a line has none that anything could be deep in.
Real width(const engine::Shape& shape) {
  const Real width = 2 * engine::half_width(shape);
  return width > 0 ? width : std::numeric_limits<Real>::infinity();
}

// Bodies whose bounding balls meet, from a sweep along x; all of them with every plane.
std::vector<core::Pair> pairs_of_any_shapes(const Model& model) {
  struct Interval {
    Real low, high;
    int body;
  };
  std::vector<Interval> intervals;
  std::vector<core::Pair> pairs;
  for (int i = 0; i < static_cast<int>(model.bodies.size()); ++i) {
    if (model.surfaces[index(i)] == engine::no_surface) continue;
    const Real at = model.motions[index(i)].position.x(), reach = bounding_radius(model.shapes[index(i)]);
    intervals.push_back({at - reach, at + reach, i});
    for (int k = 0; k < static_cast<int>(model.planes.size()); ++k) pairs.push_back({.body = i, .plane = k});
  }
  std::sort(intervals.begin(), intervals.end(), [](const Interval& x, const Interval& y) {
    return x.low < y.low || (x.low == y.low && x.body < y.body);
  });
  for (std::size_t i = 0; i < intervals.size(); ++i)
    for (std::size_t j = i + 1; j < intervals.size() && intervals[j].low <= intervals[i].high; ++j)
      pairs.push_back({.body = std::min(intervals[i].body, intervals[j].body),
                       .other = std::max(intervals[i].body, intervals[j].body)});
  return pairs;
}

std::vector<core::Pair> pairs_of(const core::Scene& scene, const Model& model) {
  const auto is_ball = [](const core::Body& body) { return core::ball_radius(body.shape).has_value(); };
  if (!std::all_of(scene.bodies.begin(), scene.bodies.end(), is_ball)) return pairs_of_any_shapes(model);
  return core::near_pairs(scene, core::initial_state(scene));
}

struct DeepOverlap {
  core::Pair pair;
  Real depth = 0, limit = 0;
};

// Of pairs that may touch and of which one moves.
std::vector<DeepOverlap> deep_overlaps(const core::Scene& scene, const Model& model) {
  std::vector<DeepOverlap> all;
  for (const core::Pair& pair : pairs_of(scene, model)) {
    const std::size_t a = index(pair.body);
    const bool plane = pair.plane >= 0;
    if (plane ? !model.may_touch_plane(pair.body, pair.plane) : !model.may_touch(pair.body, pair.other))
      continue;
    if (model.bodies[a].locked && (plane || model.bodies[index(pair.other)].locked)) continue;
    Real thinner = width(model.shapes[a]);
    engine::Separation between;
    if (plane) {
      between = separation(model.shapes[a], pose(model.motions[a]), model.planes[index(pair.plane)]);
    } else {
      const std::size_t b = index(pair.other);
      thinner = std::min(thinner, width(model.shapes[b]));
      const Real reach = bounding_radius(model.shapes[a]) + bounding_radius(model.shapes[b]);
      if ((model.motions[a].position - model.motions[b].position).norm() > reach) continue;
      between = separation(model.shapes[a], pose(model.motions[a]), model.shapes[b], pose(model.motions[b]));
    }
    if (-between.gap > allowed * thinner) all.push_back({pair, -between.gap, allowed * thinner});
  }
  return all;
}

// The first of some pairs, and how many more there are.
engine::Diagnostic told(const std::vector<DeepOverlap>& overlaps, engine::DiagnosticKind kind,
                        const core::Scene& scene) {
  const DeepOverlap& first = overlaps.front();
  const core::Pair& pair = first.pair;
  const bool plane = pair.plane >= 0;
  const std::string& other =
      plane ? scene.planes[index(pair.plane)].name : scene.bodies[index(pair.other)].name;
  engine::Diagnostic told{.kind = kind};
  told.cause = fmt::format("'{}' and '{}'", scene.bodies[index(pair.body)].name, other);
  if (overlaps.size() > 1) told.cause += fmt::format(" (and {} more)", overlaps.size() - 1);
  told.limit = static_cast<double>(first.limit), told.reached = static_cast<double>(first.depth);
  told.island.bodies.push_back(pair.body);
  if (!plane) told.island.bodies.push_back(pair.other);
  told.island.count = told.island.bodies.size();
  return told;
}

}  // namespace

std::vector<engine::Diagnostic> settle_deep_overlaps(const core::Scene& scene, Model& model) {
  engine::islands::Unions trees(model.bodies.size());
  const auto moves = [&](int body) { return body != core::world && !model.bodies[index(body)].locked; };
  for (const core::Joint& joint : scene.joints)
    if (moves(joint.body) && moves(joint.to)) trees.join(index(joint.body), index(joint.to));
  std::vector<DeepOverlap> jointed, free;
  for (const DeepOverlap& overlap : deep_overlaps(scene, model)) {
    const core::Pair& pair = overlap.pair;
    const bool one_tree = pair.plane < 0 && trees.find(index(pair.body)) == trees.find(index(pair.other));
    (one_tree ? jointed : free).push_back(overlap);
  }
  for (const DeepOverlap& overlap : jointed) model.apart.push_back({overlap.pair.body, overlap.pair.other});
  std::ranges::sort(model.apart);
  std::vector<engine::Diagnostic> all;
  if (!free.empty()) all.push_back(told(free, engine::DiagnosticKind::deep_overlap, scene));
  if (!jointed.empty()) all.push_back(told(jointed, engine::DiagnosticKind::jointed_overlap, scene));
  return all;
}

}  // namespace cylon::simulators
