// All that the engine knows of one shape by itself: a new shape is an overload in each of these visitors.
// Two shapes are then apart by the general algorithms, or by a form of their own in closed_forms.h.
#include "engine/geometry/core.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

constexpr Real infinity = std::numeric_limits<Real>::infinity();

struct Radius {
  Real operator()(std::monostate) const { return 0; }
  Real operator()(const Sphere& sphere) const { return sphere.radius; }
  Real operator()(const Box& box) const { return box.half_extents.norm(); }
  Real operator()(const Capsule& capsule) const { return capsule.half_length + capsule.radius; }
  Real operator()(const Hull& hull) const {
    Real most = 0;
    for (const Vector3& vertex : hull.vertices) most = std::max(most, vertex.squaredNorm());
    return std::sqrt(most);
  }
  Real operator()(const Frustum& s) const {
    return std::max(std::hypot(s.low_radius, s.low), std::hypot(s.high_radius, s.high));
  }
  Real operator()(const Compound& compound) const {
    Real most = 0;
    for (const ShapePart& part : compound.parts)
      most = std::max(most, part.position.norm() + std::visit(*this, part.shape));
    return most;
  }
};

struct HalfWidth {
  Real operator()(std::monostate) const { return 0; }
  Real operator()(const Sphere& sphere) const { return sphere.radius; }
  Real operator()(const Box& box) const { return box.half_extents.minCoeff(); }
  Real operator()(const Capsule& capsule) const { return capsule.radius; }
  Real operator()(const Hull& hull) const { return hull.half_width; }
  // Across the discs, across the axis, and across the side, whose outward normal is (h, r_low - r_high)/s.
  Real operator()(const Frustum& s) const {
    const Real h = s.high - s.low, slope = s.low_radius - s.high_radius;
    const auto behind = [&](Real r, Real y) { return r * h - slope * y; };
    const Real side = s.low_radius * h + slope * s.low +
                      std::max(behind(s.low_radius, s.low), behind(s.high_radius, s.high));
    return std::min({h / 2, std::max(s.low_radius, s.high_radius), side / (2 * std::hypot(h, slope))});
  }
  Real operator()(const Compound& compound) const {
    Real least = 0;
    for (const ShapePart& part : compound.parts) {
      const Real half = std::visit(*this, part.shape);
      if (half > 0) least = least > 0 ? std::min(least, half) : half;
    }
    return least;
  }
};

struct Farthest {
  const Vector3& d;

  Vector3 operator()(const Frustum& s) const {
    const Real across = std::hypot(d.x(), d.z());
    const Vector3 out = across > 0 ? Vector3(d.x() / across, 0, d.z() / across) : Vector3(Vector3::UnitX());
    const bool high = s.high_radius * across + s.high * d.y() > s.low_radius * across + s.low * d.y();
    return high ? Vector3(s.high_radius * out + s.high * Vector3::UnitY())
                : Vector3(s.low_radius * out + s.low * Vector3::UnitY());
  }
  Vector3 operator()(const Compound& compound) const {
    Vector3 best = Vector3::Zero();
    Real most = -infinity;
    for (const ShapePart& part : compound.parts) {
      const Vector3 own = part.rotation.transpose() * d;
      const Vector3 x = part.position + part.rotation * farthest(part.shape, own);
      if (d.dot(x) > most) best = x, most = d.dot(x);
    }
    return best;
  }
};

struct Extent {
  const Pose& pose;

  Bounds about(const Vector3& reach) const { return {pose.position - reach, pose.position + reach}; }
  Bounds operator()(std::monostate) const {
    return {Vector3::Constant(infinity), Vector3::Constant(-infinity)};
  }
  Bounds operator()(const Sphere& sphere) const { return about(Vector3::Constant(sphere.radius)); }
  Bounds operator()(const Box& box) const { return about(pose.rotation.cwiseAbs() * box.half_extents); }
  Bounds operator()(const Capsule& capsule) const {
    return about(pose.rotation.col(1).cwiseAbs() * capsule.half_length + Vector3::Constant(capsule.radius));
  }
  Bounds operator()(const Hull& hull) const {
    Bounds box = (*this)(std::monostate{});
    for (const Vector3& vertex : hull.vertices) {
      const Vector3 x = pose.rotation * vertex;
      box.low = box.low.cwiseMin(x);
      box.high = box.high.cwiseMax(x);
    }
    return {box.low + pose.position, box.high + pose.position};
  }
  Bounds operator()(const Frustum& s) const {
    Bounds box;
    for (int k = 0; k < 3; ++k) {
      const Vector3 d = pose.rotation.row(k);
      box.low[k] = d.dot(Farthest{-d}(s)), box.high[k] = d.dot(Farthest{d}(s));
    }
    return {box.low + pose.position, box.high + pose.position};
  }
  Bounds operator()(const Compound& compound) const {
    Bounds box = (*this)(std::monostate{});
    for (const ShapePart& part : compound.parts) {
      const Bounds one = bounds(part.shape, placed(pose, part));
      box.low = box.low.cwiseMin(one.low), box.high = box.high.cwiseMax(one.high);
    }
    return box;
  }
};

struct Rounded {
  using Result = std::optional<RoundedBox>;
  Result operator()(std::monostate) const { return std::nullopt; }
  Result operator()(const Sphere& sphere) const { return RoundedBox{Vector3::Zero(), sphere.radius}; }
  Result operator()(const Box& box) const { return RoundedBox{box.half_extents, 0}; }
  Result operator()(const Capsule& capsule) const {
    return RoundedBox{{0, capsule.half_length, 0}, capsule.radius};
  }
  template <class Other>
  Result operator()(const Other&) const {
    return std::nullopt;
  }
};

// Corner i of a box: its bit k says on which side it is along axis k.
const std::vector<std::vector<int>> box_faces = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4},
                                                 {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};
const std::array<Vector3, 6> box_normals = {-Vector3::UnitX(), Vector3::UnitX(),  -Vector3::UnitY(),
                                            Vector3::UnitY(),  -Vector3::UnitZ(), Vector3::UnitZ()};
constexpr std::array<Edge, 12> box_edges = {{{0, 1, 2, 4},
                                             {0, 2, 4, 0},
                                             {0, 4, 0, 2},
                                             {1, 3, 1, 4},
                                             {1, 5, 2, 1},
                                             {2, 3, 4, 3},
                                             {2, 6, 3, 0},
                                             {3, 7, 1, 3},
                                             {4, 5, 5, 2},
                                             {4, 6, 0, 5},
                                             {5, 7, 5, 1},
                                             {6, 7, 3, 5}}};
constexpr Edge segment_edge = {0, 1, -1, -1};

// Fills a core, whose vertices are in `own` or in the shape.
struct Polytope {
  Core& core;
  std::array<Vector3, 8>& own;

  void point(Real radius) const {
    own[0].setZero();
    core.vertex_count = 1;
    core.radius = radius;
  }
  void operator()(std::monostate) const { point(0); }
  void operator()(const Sphere& sphere) const { point(sphere.radius); }
  void operator()(const Box& box) const {
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 3; ++k)
        own[static_cast<std::size_t>(i)][k] = (i >> k & 1) != 0 ? box.half_extents[k] : -box.half_extents[k];
    core.vertex_count = 8;
    core.edges = box_edges.data(), core.edge_count = 12;
    core.normals = box_normals.data(), core.faces = box_faces.data(), core.face_count = 6;
    core.size = box.half_extents.norm();
  }
  void operator()(const Capsule& capsule) const {
    own[0] = {0, -capsule.half_length, 0};
    own[1] = {0, capsule.half_length, 0};
    core.vertex_count = 2;
    core.edges = &segment_edge, core.edge_count = 1;
    core.radius = capsule.radius, core.size = capsule.half_length;
  }
  void operator()(const Hull& hull) const {
    assert(hull.normals.size() == hull.faces.size() && !hull.edges.empty() && "not of make_hull");
    core.vertices = hull.vertices.data(), core.vertex_count = static_cast<int>(hull.vertices.size());
    core.edges = hull.edges.data(), core.edge_count = static_cast<int>(hull.edges.size());
    core.normals = hull.normals.data(), core.faces = hull.faces.data();
    core.face_count = static_cast<int>(hull.faces.size());
    core.size = Radius{}(hull);
  }
  // No polytopes: engine/geometry/facetted.h, and the parts one by one.
  void operator()(const Frustum&) const { assert(false && "a frustum has no core"); }
  void operator()(const Compound&) const { assert(false && "a compound has no core"); }
};

}  // namespace

Real bounding_radius(const Shape& shape) { return std::visit(Radius{}, shape); }

Real half_width(const Shape& shape) { return std::visit(HalfWidth{}, shape); }

Vector3 farthest(const Shape& shape, const Vector3& direction) {
  if (const auto* frustum = std::get_if<Frustum>(&shape)) return Farthest{direction}(*frustum);
  if (const auto* compound = std::get_if<Compound>(&shape)) return Farthest{direction}(*compound);
  const Core core(shape);
  return core.vertices[core.support(direction)] + core.radius * direction.normalized();
}

bool is_round(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape))
    return std::any_of(compound->parts.begin(), compound->parts.end(),
                       [](const ShapePart& part) { return is_round(part.shape); });
  return std::holds_alternative<Sphere>(shape) || std::holds_alternative<Capsule>(shape) ||
         std::holds_alternative<Frustum>(shape);
}

Bounds bounds(const Shape& shape, const Pose& pose) { return std::visit(Extent{pose}, shape); }

std::optional<RoundedBox> rounded_box(const Shape& shape) { return std::visit(Rounded{}, shape); }

Core::Core(const Shape& shape) {
  vertices = own_.data();
  std::visit(Polytope{*this, own_}, shape);
}

}  // namespace cylon::engine
