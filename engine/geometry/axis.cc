#include "engine/geometry/axis.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

void ask_faces(const Couple& c, Axis& best) {
  for (int i = 0; i < c.a.face_count; ++i) {
    const Vector3 n = -c.a.normals[i];
    const Real gap = n.dot(c.a.vertices[c.a.faces[i][0]] - c.vertex_b(c.support_b(n)));
    if (best.kind == Axis::Kind::none || gap > best.gap) best = {gap, n, Axis::Kind::face_a, i, -1};
  }
  const Real tie = best.kind == Axis::Kind::none ? 0 : 16 * epsilon * c.size;
  for (int j = 0; j < c.b.face_count; ++j) {
    const Vector3 n = c.turn * c.b.normals[j];
    const Real gap = n.dot(c.vertex_a(c.support_a(-n)) - c.vertex_b(c.b.faces[j][0]));
    if (best.kind == Axis::Kind::none || gap > best.gap + tie) best = {gap, n, Axis::Kind::face_b, -1, j};
  }
}

// Where all the vertices of a core are, in a's axes.
template <class At>
Bounds around(int count, At&& at) {
  Bounds box{at(0), at(0)};
  for (int i = 1; i < count; ++i) {
    box.low = box.low.cwiseMin(at(i));
    box.high = box.high.cwiseMax(at(i));
  }
  return box;
}

bool within(const Bounds& box, const Vector3& p, const Vector3& q, Real reach) {
  return (p.cwiseMax(q).array() >= box.low.array() - reach).all() &&
         (p.cwiseMin(q).array() <= box.high.array() + reach).all();
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
    if (first || gap > best.gap + tie) best = {gap, n, Axis::Kind::edges, a.index, b.index};
  }
};

// Edges that cross at an axis better than the best face are no farther apart than that face's depth (or the
// distance), so near contact few are left.  In batches on the stack, whatever the number of edges.
void ask_edges(const Couple& c, Real reach, Axis& best) {
  const auto at_a = [&](int i) { return c.vertex_a(i); };
  const auto at_b = [&](int i) { return c.vertex_b(i); };
  if (best.kind != Axis::Kind::none)
    reach = std::max(reach, std::abs(best.gap));
  else
    reach = 2 * c.size;
  reach += 16 * epsilon * c.size;
  const Bounds box_a = around(c.a.vertex_count, at_a), box_b = around(c.b.vertex_count, at_b);

  std::array<Placed, 64> batch;
  int count = 0;
  const auto ask_batch = [&] {
    for (int j = 0; j < c.b.edge_count; ++j) {
      const Edge& e = c.b.edges[j];
      const Vector3 from = at_b(e[0]), to = at_b(e[1]);
      if (!within(box_a, from, to, reach)) continue;
      Placed b{from, to - from, Vector3::Zero(), Vector3::Zero(), j};
      if (e[2] >= 0) b.left = c.turn * c.b.normals[e[2]], b.right = c.turn * c.b.normals[e[3]];
      for (int k = 0; k < count; ++k) EdgeTest{c, best}(batch[static_cast<std::size_t>(k)], b);
    }
    count = 0;
  };
  for (int i = 0; i < c.a.edge_count; ++i) {
    const Edge& e = c.a.edges[i];
    const Vector3 from = at_a(e[0]), to = at_a(e[1]);
    if (!within(box_b, from, to, reach)) continue;
    Placed& a = batch[static_cast<std::size_t>(count++)];
    a = {from, to - from, Vector3::Zero(), Vector3::Zero(), i};
    if (e[2] >= 0) a.left = c.a.normals[e[2]], a.right = c.a.normals[e[3]];
    if (count == static_cast<int>(batch.size())) ask_batch();
  }
  if (count > 0) ask_batch();
}

}  // namespace

Axis widest_axis(const Couple& couple, Real reach) {
  Axis best;
  ask_faces(couple, best);
  if (couple.a.edge_count > 0 && couple.b.edge_count > 0) ask_edges(couple, reach, best);
  return best;
}

}  // namespace cylon::engine
