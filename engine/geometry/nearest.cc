#include "engine/geometry/nearest.h"

#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::engine {
namespace {

struct Vertex {
  Vector3 w;         // of the difference a - b
  int a = 0, b = 0;  // of which vertices
  Real weight = 0;   // barycentric, in the simplex
};

// Up to four vertices; v is its point nearest to the origin, of which all weights are positive.
struct Simplex {
  std::array<Vertex, 4> vertex;
  int count = 0;
  Vector3 v;
  bool contains_origin = false;
};

Simplex point(const Vertex& p) {
  Simplex s;
  s.count = 1;
  s.vertex[0] = p;
  s.vertex[0].weight = 1;
  s.v = p.w;
  return s;
}

Simplex segment(const Vertex& p, const Vertex& q) {
  const Vector3 d = q.w - p.w;
  const Real t = -p.w.dot(d), u = q.w.dot(d);
  if (!(t > 0)) return point(p);
  if (!(u > 0)) return point(q);
  Simplex s;
  s.count = 2;
  s.vertex[0] = p, s.vertex[1] = q;
  s.vertex[0].weight = u / (t + u), s.vertex[1].weight = t / (t + u);
  s.v = s.vertex[0].weight * p.w + s.vertex[1].weight * q.w;
  return s;
}

const Simplex& nearer(const Simplex& s, const Simplex& t) {
  return s.v.squaredNorm() <= t.v.squaredNorm() ? s : t;
}

// With u along the longest edge and w across it in the plane (orthogonalised twice), the origin's foot is
// v = x - u (u.x) - w (w.x) of any corner x; inside where it is on the inner side of all three edges, in the
// coordinates (u.x, w.x).  A normal by the cross product of the edges would be worthless for a triangle like
// a needle, which edges that are nearly parallel make; of this one only the turn about u is.  The weights of
// a needle are poor along it, where one step of refinement restores them.
Simplex triangle(Vertex p, Vertex q, Vertex r) {
  const Real a = (q.w - p.w).squaredNorm(), b = (r.w - q.w).squaredNorm(), c = (p.w - r.w).squaredNorm();
  if (b > a && b >= c) {
    std::swap(p, q), std::swap(q, r);  // q r p
  } else if (c > a) {
    std::swap(p, r), std::swap(q, r);  // r p q
  }
  const Vector3 pq = q.w - p.w;
  const Real length = pq.norm();
  const Vector3 u = pq / length;
  Vector3 w = r.w - p.w;
  for (int pass = 0; pass < 2; ++pass) w = (w - u * u.dot(w)).normalized();
  const auto cross = [&](const Vertex& x, const Vertex& y) {
    return u.dot(x.w) * w.dot(y.w) - w.dot(x.w) * u.dot(y.w);
  };
  const Real wp = cross(q, r), wq = cross(r, p), wr = cross(p, q), sum = wp + wq + wr;
  if (wp * sum > 0 && wq * sum > 0 && wr * sum > 0) {  // false where the three are on a line: NaN
    Simplex s;
    s.count = 3;
    s.v = p.w - u * u.dot(p.w);
    s.v -= w * w.dot(s.v);
    s.v -= u * u.dot(s.v);
    const Real excess = u.dot(wp / sum * p.w + wq / sum * q.w + wr / sum * r.w) / length;
    p.weight = wp / sum + excess, q.weight = wq / sum - excess, r.weight = wr / sum;
    s.vertex[0] = p, s.vertex[1] = q, s.vertex[2] = r;
    return s;
  }
  return nearer(nearer(segment(p, q), segment(q, r)), segment(r, p));
}

Simplex tetrahedron(const std::array<Vertex, 4>& x, Real size) {
  Simplex best;
  bool outside = false;
  for (std::size_t k = 0; k < 4; ++k) {
    const Vertex &p = x[k], &q = x[(k + 1) % 4], &r = x[(k + 2) % 4], &opposite = x[(k + 3) % 4];
    const Vector3 n = (q.w - p.w).cross(r.w - p.w);
    const Real origin = -n.dot(p.w), height = n.dot(opposite.w - p.w);
    const bool flat = std::abs(height) <= 16 * epsilon * size * n.norm();
    if (!flat && origin * height > 0) continue;
    const Simplex s = triangle(p, q, r);
    if (!outside || s.v.squaredNorm() < best.v.squaredNorm()) best = s;
    outside = true;
  }
  if (outside) return best;
  best.contains_origin = true;
  return best;
}

}  // namespace

Nearest nearest(const Couple& couple, Real far, const Vector3& start) {
  const auto vertex = [&](const Vector3& direction) {
    Vertex x;
    x.a = couple.support_a(direction), x.b = couple.support_b(-direction);
    x.w = couple.vertex_a(x.a) - couple.vertex_b(x.b);
    return x;
  };

  Simplex s = point(vertex(start));
  const Real rounding = 4 * epsilon * couple.size;
  bool is_far = false;
  // Each step takes a simplex nearer than the last, so none comes twice and the steps end by themselves; where that takes
  // more than these, the plane between the points that were found is not clear of both shapes, which touch() sees: it
  // asks the axes then.
  const int most_steps = 64 + couple.a.vertex_count + couple.b.vertex_count;
  for (int step = 0; step < most_steps; ++step) {
    if (s.v.squaredNorm() <= rounding * rounding) return {};
    const Vertex next = vertex(-s.v);
    const Real between = next.w.dot(s.v);
    if (between > 0 && between * between > far * far * s.v.squaredNorm()) {
      is_far = true;
      break;
    }
    bool known = false;
    for (int k = 0; k < s.count; ++k) {
      const Vertex& old = s.vertex[static_cast<std::size_t>(k)];
      known = known || (old.a == next.a && old.b == next.b);
    }
    if (known || between >= s.v.squaredNorm()) break;
    const auto& x = s.vertex;
    const Simplex wider = s.count == 1   ? segment(x[0], next)
                          : s.count == 2 ? triangle(x[0], x[1], next)
                                         : tetrahedron({x[0], x[1], x[2], next}, couple.size);
    if (wider.contains_origin) return {};
    if (!(wider.v.squaredNorm() < s.v.squaredNorm())) break;
    s = wider;
  }

  Nearest result;
  result.a.setZero(), result.b.setZero();
  std::array<int, 2> of_a{s.vertex[0].a, s.vertex[0].a}, of_b{s.vertex[0].b, s.vertex[0].b};
  for (int k = 0; k < s.count; ++k) {
    const Vertex& x = s.vertex[static_cast<std::size_t>(k)];
    result.a += x.weight * couple.vertex_a(x.a);
    result.b += x.weight * couple.vertex_b(x.b);
    if (x.a != of_a[0]) of_a[1] = x.a;
    if (x.b != of_b[0]) of_b[1] = x.b;
  }
  result.feature = point_name::between(of_a, of_b);
  result.distance = s.v.norm();
  result.normal = s.v.normalized();
  result.is_far = is_far;
  return result;
}

}  // namespace cylon::engine
