#include "reference/simulators/in_house/in_house_overlap.h"

#include "engine/geometry/pose.h"
#include "engine/geometry/separation.h"
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

}  // namespace

std::optional<engine::Diagnostic> deep_overlap(const core::Scene& scene, const Model& model) {
  for (const core::Pair& pair : pairs_of(scene, model)) {
    const std::size_t a = index(pair.body);
    const bool plane = pair.plane >= 0;
    if (!plane && !model.may_touch(pair.body, pair.other)) continue;
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
    if (!(-between.gap > allowed * thinner)) continue;
    const std::string& other =
        plane ? scene.planes[index(pair.plane)].name : scene.bodies[index(pair.other)].name;
    engine::Diagnostic found{.kind = engine::DiagnosticKind::deep_overlap};
    found.cause = fmt::format("'{}' and '{}'", scene.bodies[a].name, other);
    found.limit = static_cast<double>(allowed * thinner), found.reached = static_cast<double>(-between.gap);
    found.island.bodies.push_back(pair.body);
    if (!plane) found.island.bodies.push_back(pair.other);
    found.island.count = found.island.bodies.size();
    return found;
  }
  return std::nullopt;
}

}  // namespace cylon::simulators
