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

// feature = (vertex or edge of the incident ring) << 16 | (side that cut it) + 1; edges that lie on a side
// that cut before are 0x8000 + that side.
constexpr std::uint32_t feature(std::uint32_t edge, std::uint32_t cut) { return edge << 16U | cut; }

struct Running {  // a corner with the edge that starts at it
  Vector3 x;
  std::uint32_t edge, feature;
};

}  // namespace

void clip(const Couple& couple, bool on_a, int face, Patch& patch) {
  const View a{couple.a, couple, true}, b{couple.b, couple, false};
  const View &reference = on_a ? a : b, &incident = on_a ? b : a;
  const Vector3 n = reference.normal(face);
  const Vector3 n_incident = on_a ? Vector3(couple.turn.transpose() * n) : n;

  std::array<Running, 256> buffers[2];
  int count = 0, now = 0;
  const Ring ring(incident, face_towards(incident, n_incident));
  for (int k = 0; k < ring.count(); ++k) {
    const auto id = static_cast<std::uint32_t>(ring.vertex(k)) & 0x7fffU;
    buffers[0][static_cast<std::size_t>(count++)] = {incident.vertex(ring.vertex(k)), id, feature(id, 0)};
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
    const auto cut = static_cast<std::uint32_t>(side + 1);
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
        out[static_cast<std::size_t>(kept++)] = {x, inside ? 0x8000U + cut : p.edge, feature(p.edge, cut)};
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
