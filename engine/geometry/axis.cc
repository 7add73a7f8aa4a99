#include "engine/geometry/axis.h"

#include "engine/geometry/clip.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace cylon::engine {
namespace {

// The faces of a core against the vertices of the other, in the core's axes.  Of the face through p with the outward
// normal n, and any vertex x of the other,
//   gap = min_x n.(x - p) <= height over x = n.(x - p),
// so one whose height over the vertex `near`, or over the one last found farthest, is less than the widest gap there is
// needs no search for its own farthest vertex.  First comes the face that is highest over `near`.
template <class Ask, class Use>
void ask_faces(const Core& core, const Vector3& near, Real widest, Real slack, Ask&& ask, Use&& use) {
  const auto height = [&](int i, const Vector3& x) {
    return core.normals[i].dot(x - core.vertices[core.faces[i][0]]);
  };
  int first = -1;
  Real most = 0, gap_of_first = 0;
  for (int i = 0; i < core.face_count; ++i)
    if (const Real h = height(i, near); first < 0 || h > most) most = h, first = i;
  Vector3 last = near;
  if (first >= 0) gap_of_first = ask(first, last), widest = std::max(widest, gap_of_first);
  for (int i = 0; i < core.face_count; ++i) {
    if (i == first) {
      use(i, gap_of_first);
      continue;
    }
    if (height(i, last) < widest - slack || height(i, near) < widest - slack) continue;
    Vector3 x;
    const Real gap = ask(i, x);
    if (gap > widest) widest = gap, last = x;
    use(i, gap);
  }
}

void ask_faces(const Couple& c, Axis& best) {
  constexpr Real none = -std::numeric_limits<Real>::infinity();
  const Real slack = 64 * epsilon * c.size;
  const auto to_b = [&](int i) { return Vector3(c.turn.transpose() * (c.a.vertices[i] - c.shift)); };
  ask_faces(
      c.a, c.vertex_b(c.support_b(-c.shift)), none, slack,
      [&](int i, Vector3& x) {
        const Vector3 n = -c.a.normals[i];
        x = c.vertex_b(c.support_b(n));
        return n.dot(c.a.vertices[c.a.faces[i][0]] - x);
      },
      [&](int i, Real gap) {
        if (best.kind == Axis::Kind::none || gap > best.gap)
          best = {gap, -c.a.normals[i], Axis::Kind::face_a, i, -1, {}, false};
      });
  const Real tie = best.kind == Axis::Kind::none ? 0 : 16 * epsilon * c.size;
  ask_faces(
      c.b, to_b(c.support_a(-c.shift)), best.kind == Axis::Kind::none ? none : best.gap, slack,
      [&](int j, Vector3& x) {
        const Vector3 n = c.turn * c.b.normals[j];
        const int i = c.support_a(-n);
        x = to_b(i);
        return n.dot(c.vertex_a(i) - c.vertex_b(c.b.faces[j][0]));
      },
      [&](int j, Real gap) {
        if (best.kind == Axis::Kind::none || gap > best.gap + tie)
          best = {gap, c.turn * c.b.normals[j], Axis::Kind::face_b, -1, j, {}, false};
      });
}

Vector3 deepest_over(const Couple& couple, const Axis& axis, bool& reached) {
  const bool on_a = axis.kind == Axis::Kind::face_a;
  Patch patch;
  clip(couple, on_a, on_a ? axis.a : axis.b, patch);
  Real least = std::numeric_limits<Real>::infinity();
  for (int k = 0; k < patch.count; ++k) least = std::min(least, patch.corners[index(k)].gap);
  const Real same = 64 * epsilon * couple.size;
  reached = least <= axis.gap + same;
  if (!reached)
    return on_a ? couple.vertex_b(couple.support_b(axis.normal))
                : couple.vertex_a(couple.support_a(-axis.normal));
  Vector3 sum = Vector3::Zero();
  int count = 0;
  for (int k = 0; k < patch.count; ++k) {
    const Corner& corner = patch.corners[index(k)];
    if (corner.gap <= least + same) sum += corner.x, ++count;
  }
  return sum / static_cast<Real>(count);
}

// An edge in a's axes: where, along what, and between which faces.
struct Placed {
  Vector3 from, along, left, right;
  int index = 0;
};

struct EdgeTest {
  const Couple& c;
  Axis& best;

  // n = +-(e_a x e_b) is normal to a face of a - b where the arc between the normals beside e_a crosses minus
  // the arc beside e_b:  n.(l x e_a) >= 0, n.(e_a x r) >= 0 say that a lies on the + side of e_a, which with
  // n = sign e_a x e_b comes to  sign e_b.l <= 0 <= sign e_b.r;  likewise for b on the - side of e_b.
  // An arc that only ends on the other belongs to a face, which was asked before.
  void operator()(const Placed& a, const Placed& b) const {
    Real sign = 0;
    if (c.a.face_count > 0) {
      const Real l = b.along.dot(a.left), r = b.along.dot(a.right);
      if (l * r >= 0) return;
      sign = l < 0 ? Real(1) : Real(-1);
    }
    if (c.b.face_count > 0) {
      const Real l = a.along.dot(b.left), r = a.along.dot(b.right);
      if (l * r >= 0 || sign * l > 0) return;
      if (sign == 0) sign = l < 0 ? Real(1) : Real(-1);
    }
    const Vector3 cross = a.along.cross(b.along);
    const Real length = cross.norm();
    if (length == 0) return;
    const Vector3 d = a.from - b.from;
    if (sign == 0) sign = cross.dot(d) < 0 ? Real(-1) : Real(1);
    const Vector3 n = cross * (sign / length);
    const Real tie = best.kind == Axis::Kind::edges ? 0 : 16 * epsilon * c.size;
    const bool first = best.kind == Axis::Kind::none;
    if (!first && !(n.dot(d) > best.gap + tie)) return;
    const Real gap = c.between(n);
    if (first || gap > best.gap + tie) best = {gap, n, Axis::Kind::edges, a.index, b.index, {}, false};
  }
};

// Where some points are.
Bounds around(const std::vector<Placed>& edges) {
  Bounds box{Vector3::Constant(std::numeric_limits<Real>::infinity()),
             Vector3::Constant(-std::numeric_limits<Real>::infinity())};
  for (const Placed& e : edges)
    for (const Vector3& x : {e.from, Vector3(e.from + e.along)})
      box.low = box.low.cwiseMin(x), box.high = box.high.cwiseMax(x);
  return box;
}

bool within(const Bounds& box, const Placed& e, Real reach) {
  const Vector3 to = e.from + e.along;
  return (e.from.cwiseMax(to).array() >= box.low.array() - reach).all() &&
         (e.from.cwiseMin(to).array() <= box.high.array() + reach).all();
}

// Calls use(index, edge) for the edges of a core at which there may be an axis with more than `gap`, which is negative.
// Along an axis n between the outward normals l and r of the faces beside an edge through p, with any point x of the other
// core (own axes), there is no more than
//   n.(x - p) = f l.(x - p) + g r.(x - p),  f, g >= 0, f + g >= 1,
// so no more than the greater of the faces' heights over x where that is negative.
template <class Use>
void edges_over(const Core& core, const Vector3& x, Real gap, Use&& use) {
  thread_local std::vector<char> is_higher;
  is_higher.clear();
  bool any =
      core.face_count <= 2;  // a triangle's two faces are opposite to each other, and a segment has none
  for (int i = 0; i < core.face_count; ++i) {
    is_higher.push_back(core.face_count <= 2 ||
                        core.normals[i].dot(x - core.vertices[core.faces[i][0]]) > gap);
    any |= is_higher.back() != 0;
  }
  for (int i = 0; any && i < core.edge_count; ++i) {
    const Edge& e = core.edges[i];
    if (e[2] < 0 || is_higher[index(e[2])] != 0 || is_higher[index(e[3])] != 0) use(i, e);
  }
}

// Edges that cross at an axis better than the best face are no farther apart than that face's depth (or the
// distance), so along the face's normal n those of a begin before b ends, and both are where some of the other are:
// near contact few are left.
void ask_edges(const Couple& c, Real reach, Axis& best) {
  thread_local std::vector<Placed> edges_a, edges_b;
  edges_a.clear(), edges_b.clear();
  const bool any_face = best.kind != Axis::Kind::none;
  reach = any_face ? std::max(reach, std::abs(best.gap)) : 2 * c.size;
  reach += 16 * epsilon * c.size;

  // Points of both that are as deep as the best face; where they overlap only to rounding, nothing is left out.
  const bool on_a = best.kind == Axis::Kind::face_a;
  Vector3 in_a = c.vertex_a(0), in_b = c.vertex_b(0);
  Real least = -std::numeric_limits<Real>::infinity();
  if (any_face && best.gap < -16 * epsilon * c.size) {
    least = best.gap + 8 * epsilon * c.size;
    (on_a ? in_b : in_a) = best.deepest;
    if (best.reached) (on_a ? in_a : in_b) = best.deepest + (on_a ? best.gap : -best.gap) * best.normal;
  }
  const Vector3 n = any_face ? best.normal : Vector3(Vector3::Zero());
  const Real low = n.dot(c.vertex_a(c.support_a(-n))) - reach,
             high = n.dot(c.vertex_b(c.support_b(n))) + reach;

  edges_over(c.a, in_b, least, [&](int i, const Edge& e) {
    const Vector3 from = c.vertex_a(e[0]), to = c.vertex_a(e[1]);
    if (std::min(n.dot(from), n.dot(to)) > high) return;
    Placed a{from, to - from, Vector3::Zero(), Vector3::Zero(), i};
    if (e[2] >= 0) a.left = c.a.normals[e[2]], a.right = c.a.normals[e[3]];
    edges_a.push_back(a);
  });
  if (edges_a.empty()) return;
  const Bounds box_a = around(edges_a);
  edges_over(c.b, c.turn.transpose() * (in_a - c.shift), least, [&](int j, const Edge& e) {
    const Vector3 from = c.vertex_b(e[0]), to = c.vertex_b(e[1]);
    Placed b{from, to - from, Vector3::Zero(), Vector3::Zero(), j};
    if (std::max(n.dot(from), n.dot(to)) < low || !within(box_a, b, reach)) return;
    if (e[2] >= 0) b.left = c.turn * c.b.normals[e[2]], b.right = c.turn * c.b.normals[e[3]];
    edges_b.push_back(b);
  });
  const Bounds box_b = around(edges_b);
  std::erase_if(edges_a, [&](const Placed& a) { return !within(box_b, a, reach); });
  for (const Placed& b : edges_b)
    for (const Placed& a : edges_a) EdgeTest{c, best}(a, b);
}

}  // namespace

Axis widest_axis(const Couple& couple, Real reach) {
  Axis best;
  ask_faces(couple, best);
  if (best.kind != Axis::Kind::none) best.deepest = deepest_over(couple, best, best.reached);
  if (couple.a.edge_count > 0 && couple.b.edge_count > 0) ask_edges(couple, reach, best);
  return best;
}

std::optional<Axis> axis_of_overlap(const Couple& couple) {
  const Real sure = -16 * epsilon * couple.size;
  Axis best;
  ask_faces(couple, best);
  if (best.kind == Axis::Kind::none || !(best.gap < sure)) return {};
  best.deepest = deepest_over(couple, best, best.reached);
  const bool on_a = best.kind == Axis::Kind::face_a;
  const Core& core = on_a ? couple.a : couple.b;
  const Vector3 x = on_a ? best.deepest : Vector3(couple.turn.transpose() * (best.deepest - couple.shift));
  for (int i = 0; i < core.face_count; ++i)
    if (!(core.normals[i].dot(x - core.vertices[core.faces[i][0]]) < sure)) return {};
  if (couple.a.edge_count > 0 && couple.b.edge_count > 0) ask_edges(couple, 0, best);
  return best;
}

}  // namespace cylon::engine
