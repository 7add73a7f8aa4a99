#include "engine/geometry/manifold.h"

#include "engine/geometry/clip.h"
#include "engine/geometry/closed_forms.h"
#include "engine/geometry/pair_table.h"
#include "engine/geometry/reduce.h"
#include "engine/geometry/touch.h"

#include <limits>

namespace cylon::engine {
namespace {

constexpr Real eps = std::numeric_limits<Real>::epsilon();

Manifold none() {
  Manifold result;
  result.normal = Vector3::UnitY();
  result.count = 0;
  return result;
}

Manifold from_separation(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                         Real margin) {
  return one_point(separation(body, pose, other, other_pose), margin);
}

// ---- Polytopes: faces against faces, edges, points -------------------------------------------------------

// The face that looks most along a direction (its own axes), or -1.
int facing(const Core& core, const Vector3& direction) {
  int best = -1;
  Real most = 0;
  for (int i = 0; i < core.face_count; ++i) {
    const Real along = direction.dot(core.normals[i]);
    if (along > most) most = along, best = i;
  }
  return best;
}

// A face as the separating plane.
struct Reference {
  bool on_a = true;
  int face = -1;
  Real gap = -std::numeric_limits<Real>::infinity();
  Vector3 normal;  // from b to a
};

Reference reference_face(const Couple& couple, const Touch& t, Real margin) {
  Reference a, b;
  a.face = facing(couple.a, -t.normal);
  if (a.face >= 0) a.normal = -couple.a.normals[a.face], a.gap = couple.between(a.normal);
  b.on_a = false;
  b.face = facing(couple.b, couple.turn.transpose() * t.normal);
  if (b.face >= 0) b.normal = couple.turn * couple.b.normals[b.face], b.gap = couple.between(b.normal);
  // a is preferred by a little, so that rounding does not change the reference from step to step
  return b.gap > a.gap + Real(0.05) * std::max(margin, Real(0)) + 64 * eps * couple.size ? b : a;
}

std::uint32_t single_feature(const Touch& t) {
  const auto number = [](int i) { return static_cast<std::uint32_t>(i + 1) & 0x7fffU; };
  return 0x80000000U | number(t.feature_a) << 16U | number(t.feature_b);
}

Manifold polytopes(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                   Real margin) {
  const Couple couple(body, pose, other, other_pose);
  const Real radii = couple.a.radius + couple.b.radius;
  const Touch t = touch(couple);
  if (!(t.gap - radii < margin)) return none();

  const auto world = [&](const Vector3& x) { return Vector3(pose.position + pose.rotation * x); };
  const Reference face = reference_face(couple, t, margin);
  const Real slack = Real(0.1) * std::max(margin, Real(0)) + 16 * eps * couple.size;
  if (face.face >= 0 && face.gap >= t.gap - slack) {
    Patch patch;
    clip(couple, face.on_a, face.face, patch);
    Reduction reduction(pose.rotation * face.normal);
    const Vector3 up = face.on_a ? Vector3(-face.normal) : face.normal;  // out of the reference
    const Real below = face.on_a ? couple.b.radius : couple.a.radius;    // of the incident, under its core
    const std::uint32_t flip = face.on_a ? 0U : 0x80000000U;
    for (int k = 0; k < patch.count; ++k) {
      const Corner& corner = patch.corners[static_cast<std::size_t>(k)];
      const Real gap = corner.gap - radii;
      if (gap < margin) reduction.add({world(corner.x - up * (below + gap / 2)), gap, corner.feature ^ flip});
    }
    const Manifold result = reduction.result();
    if (result.count > 0) return result;
  }
  const Vector3 a = t.a - couple.a.radius * t.normal, b = t.b + couple.b.radius * t.normal;
  return one_point({t.gap - radii, pose.rotation * t.normal, world(a), world(b)}, margin, single_feature(t));
}

using Row = Manifold (*)(const Shape&, const Pose&, const Shape&, const Pose&, Real);

template <class A, class B>
Manifold closed(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                Real margin) {
  return closed_manifold(std::get<A>(body), pose, std::get<B>(other), other_pose, margin);
}

// A sphere touches in one point.
template <class S>
constexpr bool one_point_only = std::is_same_v<S, std::monostate> || std::is_same_v<S, Sphere>;

constexpr auto table = pair_table([]<class A, class B>() -> Row {
  if constexpr (one_point_only<A> || one_point_only<B>)
    return from_separation;
  else if constexpr (requires(const A& a, const B& b, const Pose& p) { closed_manifold(a, p, b, p, Real()); })
    return closed<A, B>;
  else
    return polytopes;
});

}  // namespace

Manifold one_point(const Separation& s, Real margin, std::uint32_t feature) {
  if (!(s.gap < margin)) return none();
  Manifold result;
  result.normal = s.normal;
  result.count = 1;
  result.points[0] = {(s.point + s.other_point) / 2, s.gap, feature};
  return result;
}

Manifold manifold(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                  Real margin) {
  return table[body.index()][other.index()](body, pose, other, other_pose, margin);
}

// gap = n.x - offset - r for every vertex of the core.
Manifold manifold(const Shape& body, const Pose& pose, const Plane& plane, Real margin) {
  if (body.index() == 0) return none();
  const Core core(body);
  const Vector3 n = pose.rotation.transpose() * plane.normal;
  const Real height = plane.normal.dot(pose.position) - plane.offset - core.radius;
  Reduction reduction(plane.normal);
  for (int i = 0; i < core.vertex_count; ++i) {
    const Real gap = height + n.dot(core.vertices[i]);
    if (!(gap < margin)) continue;
    const Vector3 x = pose.position + pose.rotation * core.vertices[i];
    reduction.add({x - (core.radius + gap / 2) * plane.normal, gap, static_cast<std::uint32_t>(i)});
  }
  return reduction.result();
}

}  // namespace cylon::engine
