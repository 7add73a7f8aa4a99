#include "engine/geometry/touch.h"

#include "engine/geometry/nearest.h"
#include "engine/geometry/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

constexpr Real near = epsilon < Real(1e-10) ? Real(1.5e-8) : Real(3.5e-4);  // sqrt(epsilon)

void place_on_edges(const Couple& couple, int edge_a, int edge_b, Touch& result) {
  const Edge &e = couple.a.edges[edge_a], &f = couple.b.edges[edge_b];
  const Vector3 p = couple.vertex_a(e[0]), q = couple.vertex_b(f[0]);
  Vector3 u = couple.vertex_a(e[1]) - p, w = couple.vertex_b(f[1]) - q;
  const Real a = u.norm() / 2, b = w.norm() / 2;
  const Vector3 middle_a = p + u / 2, middle_b = q + w / 2;
  u /= 2 * a, w /= 2 * b;
  const SegmentPoints where = nearest_on_segments(middle_a, u, a, middle_b, w, b);
  result.a = middle_a + where.s * u;
  result.b = middle_b + where.t * w;
  result.feature = point_name::between({e[0], e[1]}, {f[0], f[1]});
}

// The nearest of all pairs of edges, ends included, where it is nearer than `known`.  Slow and without a way
// to fail: for needles.
void ask_all_edges(const Couple& couple, Touch& known) {
  for (int i = 0; i < couple.a.edge_count; ++i)
    for (int j = 0; j < couple.b.edge_count; ++j) {
      Touch pair;
      place_on_edges(couple, i, j, pair);
      const Vector3 d = pair.a - pair.b;
      pair.gap = d.norm();
      if (!(pair.gap < known.gap) || pair.gap == 0) continue;
      pair.normal = d / pair.gap;
      known = pair;
    }
}

Touch from_axis(const Couple& couple, const Axis& axis) {
  Touch result{axis.gap, axis.normal, Vector3::Zero(), Vector3::Zero(),
               point_name::named(point_name::axis, {axis.a, axis.b})};
  if (axis.kind == Axis::Kind::face_a) {
    result.b = axis.deepest, result.reached = axis.reached;
    result.a = result.b + axis.gap * axis.normal;
  } else if (axis.kind == Axis::Kind::face_b) {
    result.a = axis.deepest, result.reached = axis.reached;
    result.b = result.a - axis.gap * axis.normal;
  } else {
    place_on_edges(couple, axis.a, axis.b, result);
    result.reached = (result.a - result.b).norm() <= std::abs(axis.gap) + 64 * epsilon * couple.size;
  }
  return result;
}

// Of two without a rounding radius, which are mostly apart where they have one: no plane across the line between the
// reference points is between them.
bool may_overlap(const Couple& couple) {
  if (couple.a.radius + couple.b.radius > 0) return false;
  const Vector3& d = couple.shift;
  return d.dot(couple.vertex_a(couple.support_a(d)) - couple.vertex_b(couple.support_b(-d))) > 0;
}

}  // namespace

// Apart by more than the square root of rounding, nearest() has the normal to that square root at worst (a
// corner against a corner) and to rounding where a face or two edges decide.  Nearer than that the axes
// decide, and wherever the plane between the nearest points is not clear of both by their distance: simplices
// like needles, of nearly parallel edges, can stop it early.  An axis is a lower bound; where points of both
// shapes are that far apart along it, it is the distance.  Where none are (corners and edges against
// corners), it is nearest()'s.
Touch touch(const Couple& couple, Real far, const Touch* before) {
  const Real rounding = epsilon * couple.size;
  if (before != nullptr ? before->gap < 0 : may_overlap(couple))
    if (const std::optional<Axis> axis = axis_of_overlap(couple)) return from_axis(couple, *axis);
  const Nearest apart = nearest(couple, far, before != nullptr ? -before->normal : couple.shift);
  const Touch between{apart.distance, apart.normal, apart.a, apart.b, apart.feature};
  if (apart.is_far) return between;
  const bool close = !(apart.distance > near * couple.size);
  if (close || couple.between(apart.normal) < apart.distance - 8 * rounding) {
    const Axis axis = widest_axis(couple, apart.distance + 16 * rounding);
    const Touch found = from_axis(couple, axis);
    if (found.reached || apart.distance == 0 || axis.gap >= apart.distance - 16 * rounding) return found;
    Touch least = between;
    ask_all_edges(couple, least);
    return least;
  }
  return between;
}

}  // namespace cylon::engine
