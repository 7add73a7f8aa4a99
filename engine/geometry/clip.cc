#include "engine/geometry/clip.h"

#include <limits>

namespace cylon::engine {
namespace {

// A cut adds at most one corner: 120 + 120 fit.  Of a face with more every second one counts, or third …, which
// the patch tells.
constexpr int most_corners = 120;

// A core in a's axes.
struct View {
  const Core& core;
  const Couple& couple;
  bool is_a;

  Vector3 vertex(int i) const { return is_a ? couple.vertex_a(i) : couple.vertex_b(i); }
  Vector3 normal(int face) const {
    return is_a ? core.normals[face] : Vector3(couple.turn * core.normals[face]);
  }
};

// The corners of a face, or of a face-less core itself.
struct Ring {
  const View& view;
  const std::vector<int>* face;
  int size, step;

  Ring(const View& v, int index)
      : view(v),
        face(index >= 0 ? &v.core.faces[index] : nullptr),
        size(face != nullptr ? static_cast<int>(face->size()) : v.core.vertex_count),
        step((size + most_corners - 1) / most_corners) {}

  int count() const { return (size + step - 1) / step; }
  int vertex(int k) const {
    const int at = k * step;
    return face != nullptr ? (*face)[static_cast<std::size_t>(at)] : at;
  }
};

int face_towards(const View& view, const Vector3& direction) {
  int best = -1;
  Real least = 2;
  for (int i = 0; i < view.core.face_count; ++i) {
    const Real along = direction.dot(view.core.normals[i]);
    if (along < least) least = along, best = i;
  }
  return best;
}

struct Running {  // a corner with the edge that starts at it
  Vector3 x;
  int edge;  // its first vertex, or -1 - the side on which it lies
  PointName feature;
};

}  // namespace

void clip(const Couple& couple, bool on_a, int face, Patch& patch) {
  const View a{couple.a, couple, true}, b{couple.b, couple, false};
  const View &reference = on_a ? a : b, &incident = on_a ? b : a;
  const Vector3 n = reference.normal(face);
  const Vector3 n_incident = on_a ? Vector3(couple.turn.transpose() * n) : n;

  std::array<Running, 256> buffers[2];
  int count = 0, now = 0;
  const int below = face_towards(incident, n_incident);
  const Ring ring(incident, below);
  // A side cuts an edge, which its face numbers, or meets a side that cut before: a corner of the reference.
  const std::array<point_name::Kind, 3> of_incident =
      on_a ? std::array{point_name::b_vertex, point_name::b_side_and_edge, point_name::a_corner}
           : std::array{point_name::a_vertex, point_name::a_side_and_edge, point_name::b_corner};
  const auto name = [&](int edge, int side) {
    return edge < 0 ? point_name::named(of_incident[2], {face, -1 - edge, side})
                    : point_name::named(of_incident[1], {face, below, edge, side});
  };
  for (int k = 0; k < ring.count(); ++k) {
    const int id = ring.vertex(k);
    buffers[0][static_cast<std::size_t>(count++)] = {incident.vertex(id), id,
                                                     point_name::named(of_incident[0], {id})};
  }
  const bool closed = count > 2;

  constexpr Real eps = epsilon;
  const Ring sides(reference, face);
  const Vector3 origin = reference.vertex(sides.vertex(0));
  Vector3 from = origin;
  for (int side = 0; side < sides.count() && count > 0; ++side) {
    const Vector3 to = reference.vertex(sides.vertex((side + 1) % sides.count()));
    const Vector3 inward = n.cross(to - from);
    const Real tolerance = 16 * eps * couple.size * inward.norm();
    const auto& in = buffers[now];
    auto& out = buffers[1 - now];
    int kept = 0;
    const auto height = [&](int k) { return inward.dot(in[static_cast<std::size_t>(k)].x - from); };
    Real h = height(0);
    for (int k = 0; k < count; ++k) {
      const Running& p = in[static_cast<std::size_t>(k)];
      const int next = k + 1 < count ? k + 1 : 0;
      const Running& q = in[static_cast<std::size_t>(next)];
      const Real h_next = height(next);
      const bool inside = h >= -tolerance, next_inside = h_next >= -tolerance;
      if (inside) out[static_cast<std::size_t>(kept++)] = p;
      const bool crosses = inside != next_inside && (inside ? h : h_next) > tolerance;
      if (crosses && (closed || next != 0)) {
        const Vector3 x = p.x + (q.x - p.x) * (h / (h - h_next));
        out[static_cast<std::size_t>(kept++)] = {x, inside ? -1 - side : p.edge, name(p.edge, side)};
      }
      h = h_next;
    }
    count = kept, now = 1 - now, from = to;
  }

  patch.count = count;
  patch.thinned = ring.step > 1 || sides.step > 1;
  for (int k = 0; k < count; ++k) {
    const Running& p = buffers[now][static_cast<std::size_t>(k)];
    patch.corners[static_cast<std::size_t>(k)] = {p.x, n.dot(p.x - origin), p.feature};
  }
}

}  // namespace cylon::engine
