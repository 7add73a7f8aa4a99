#include "engine/geometry/manifold.h"

#include "engine/geometry/clip.h"
#include "engine/geometry/closed_forms.h"
#include "engine/geometry/facetted.h"
#include "engine/geometry/pair_table.h"
#include "engine/geometry/reduce.h"
#include "engine/geometry/touch.h"

#include <limits>

namespace cylon::engine {
namespace {

Manifold no_manifold() {
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

// One of the two is preferred by a little, so that rounding does not change the reference from step to step: the larger,
// whichever is named first.
Reference reference_face(const Couple& couple, const Touch& t, Real margin) {
  Reference a, b;
  a.face = facing(couple.a, -t.normal);
  if (a.face >= 0) a.normal = -couple.a.normals[a.face], a.gap = couple.between(a.normal);
  b.on_a = false;
  b.face = facing(couple.b, couple.turn.transpose() * t.normal);
  if (b.face >= 0) b.normal = couple.turn * couple.b.normals[b.face], b.gap = couple.between(b.normal);
  const Real little = Real(0.05) * std::max(margin, Real(0)) + 64 * epsilon * couple.size;
  if (couple.b.size > couple.a.size) return a.gap > b.gap + little ? a : b;
  return b.gap > a.gap + little ? b : a;
}

// Whether the incident shape has no face that looks at the reference, as a triangle that stands across it: then only its
// nearest corners touch.
bool stands_across(const Couple& couple, const Reference& face) {
  const Core& incident = face.on_a ? couple.b : couple.a;
  const Vector3 n = face.on_a ? Vector3(couple.turn.transpose() * face.normal) : Vector3(-face.normal);
  const auto looks = [&](int i) { return n.dot(incident.normals[i]) > Real(0.1); };
  for (int i = 0; i < incident.face_count; ++i)
    if (looks(i)) return false;
  return incident.face_count > 0;
}

Real deepest(const Manifold& manifold) {
  Real least = std::numeric_limits<Real>::infinity();
  for (int k = 0; k < manifold.count; ++k)
    least = std::min(least, manifold.points[static_cast<std::size_t>(k)].gap);
  return least;
}

using Corners = std::array<ContactPoint, std::tuple_size_v<decltype(Patch::corners)>>;

// Points nearer to each other than `same` are one: their middle where they are as deep, else the deepest.
int without_twins(Corners& points, int count, Real same) {
  for (int i = 0; i < count; ++i)
    for (int k = i + 1; k < count;) {
      ContactPoint &p = points[static_cast<std::size_t>(i)], &q = points[static_cast<std::size_t>(k)];
      if ((p.position - q.position).norm() > same) {
        ++k;
        continue;
      }
      if (std::abs(p.gap - q.gap) <= Real(1e-6) * same)
        p.position = (p.position + q.position) / 2, p.gap = std::min(p.gap, q.gap);
      else if (q.gap < p.gap)
        p = q;
      std::move(points.begin() + k + 1, points.begin() + count--, points.begin() + k);
    }
  return count;
}

// How more points than fit are thinned, and which are one.
struct Thinning {
  const Pose& frame;    // of the shape to which the directions are fixed
  const Frustum* disc;  // that it is, or none
  bool is_body;
  Real same = 0;  // [m]

  Vector3 first(const Vector3& normal) const {
    const Vector3 own = frame.rotation.transpose() * normal;
    if (disc == nullptr) return frame.rotation * skew_direction(own);
    return frame.rotation * down_on_disc(is_body ? own : Vector3(-own));
  }
  // By how much the eight points of a disc are narrower than it: r (1 - cos(pi/8)), a plane's too.
  Real spare() const {
    return disc == nullptr ? Real(0) : Real(0.0762) * std::max(disc->low_radius, disc->high_radius);
  }
};

Manifold polytopes(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                   Real margin, const Thinning& thinning, const std::optional<Touch>& known = {}) {
  const Couple couple(body, pose, other, other_pose);
  const Real radii = couple.a.radius + couple.b.radius;
  const Touch t = known ? *known : touch(couple, margin + radii);
  if (!(t.gap - radii < margin)) return no_manifold();

  const auto world = [&](const Vector3& x) { return Vector3(pose.position + pose.rotation * x); };
  const Reference face = reference_face(couple, t, margin);
  const Real slack = Real(0.1) * std::max(margin, Real(0)) + 16 * epsilon * couple.size;
  if (face.face >= 0 && face.gap >= t.gap - slack) {
    Patch patch;
    clip(couple, face.on_a, face.face, patch);
    const Vector3 up = face.on_a ? Vector3(-face.normal) : face.normal;  // out of the reference
    const Real below = face.on_a ? couple.b.radius : couple.a.radius;    // of the incident, under its core
    const Real most = stands_across(couple, face) ? std::min(margin, t.gap - radii + slack) : margin;
    Corners corners;
    int count = 0;
    for (int k = 0; k < patch.count; ++k) {
      const Corner& corner = patch.corners[static_cast<std::size_t>(k)];
      const Real gap = corner.gap - radii;
      if (gap < most)
        corners[static_cast<std::size_t>(count++)] = {world(corner.x - up * (below + gap / 2)), gap,
                                                      corner.feature};
    }
    if (thinning.same > 0) count = without_twins(corners, count, thinning.same);
    const Vector3 normal = pose.rotation * face.normal;
    Reduction reduction(normal, thinning.first(normal));
    for (int k = 0; k < count; ++k) reduction.add(corners[static_cast<std::size_t>(k)]);
    Manifold result = reduction.result(thinning.spare());
    result.thinned = result.thinned || patch.thinned;
    // Where edges cross beside the face, the deepest place is not over it.
    if (result.count > 0 && deepest(result) <= t.gap - radii + slack) return result;
  }
  const Vector3 a = t.a - couple.a.radius * t.normal, b = t.b + couple.b.radius * t.normal;
  return one_point({t.gap - radii, pose.rotation * t.normal, world(a), world(b)}, margin, t.feature);
}

// Of two polytopes the directions are those of the smaller one, which mostly has the corners.
Manifold flat_polytopes(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                        Real margin) {
  const bool on_body = bounding_radius(body) <= bounding_radius(other);
  return polytopes(body, pose, other, other_pose, margin, {on_body ? pose : other_pose, nullptr, on_body});
}

Manifold round_polytopes(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                         Real margin) {
  const auto *a = std::get_if<Frustum>(&body), *b = std::get_if<Frustum>(&other);
  const bool on_body = b == nullptr || (a != nullptr && bounding_radius(body) <= bounding_radius(other));
  const Facetted facetted(body, pose, other, other_pose, margin);
  if (facetted.is_far()) return no_manifold();
  Manifold result =
      polytopes(facetted.body(), pose, facetted.other(), other_pose, margin,
                {on_body ? pose : other_pose, on_body ? a : b, on_body, facetted.same()}, facetted.touch());
  result.unsettled = facetted.unsettled();
  return result;
}

using ManifoldOf = Manifold (*)(const Shape&, const Pose&, const Shape&, const Pose&, Real);

template <class A, class B>
Manifold closed_manifold(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                         Real margin) {
  return closed_manifold(std::get<A>(body), pose, std::get<B>(other), other_pose, margin);
}

// A sphere touches in one point.
template <class S>
constexpr bool one_point_only = std::is_same_v<S, std::monostate> || std::is_same_v<S, Sphere> ||
                                std::is_same_v<S, Compound>;  // whose points manifolds() finds

constexpr auto manifold_table = pair_table([]<class A, class B>() -> ManifoldOf {
  if constexpr (one_point_only<A> || one_point_only<B>)
    return from_separation;
  else if constexpr (requires(const A& a, const B& b, const Pose& p) { closed_manifold(a, p, b, p, Real()); })
    return closed_manifold<A, B>;
  else if constexpr (std::is_same_v<A, Frustum> || std::is_same_v<B, Frustum>)
    return round_polytopes;
  else
    return flat_polytopes;
});

}  // namespace

Manifold one_point(const Separation& s, Real margin, PointName feature) {
  if (!(s.gap < margin)) return no_manifold();
  Manifold result;
  result.normal = s.normal;
  result.count = 1;
  result.points[0] = {(s.point + s.other_point) / 2, s.gap, feature};
  return result;
}

Manifold manifold(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                  Real margin) {
  return manifold_table[body.index()][other.index()](body, pose, other, other_pose, margin);
}

namespace {

// Eight points of each disc, of which one is the lowest there is:  n across the axis points up.  The point x of a rim
// round c, which stays on the rim while the body turns, sinks by
//   -n.(move + turn x (c - p) + turn' x (x - c)),  turn' the part of the turn across the axis.
// Taken as a point of the body, one ahead of the lowest would brake a body that rolls fast.
void add_discs(const Frustum& s, const Pose& pose, const Plane& plane, Real margin, const Travel* travel,
               const Vector3& origin, Reduction& reduction) {
  const Vector3 n = pose.rotation.transpose() * plane.normal;
  const Vector3 down = down_on_disc(n);
  const Vector3 side = Vector3::UnitY().cross(down);
  const Real height = plane.normal.dot(pose.position) - plane.offset, half = std::sqrt(Real(0.5));
  const std::array<std::array<Real, 2>, 8> circle = {
      {{1, 0}, {half, half}, {0, 1}, {-half, half}, {-1, 0}, {-half, -half}, {0, -1}, {half, -half}}};
  PointName feature = 0;
  for (const auto& [radius, y] : {std::pair(s.low_radius, s.low), std::pair(s.high_radius, s.high)})
    for (std::size_t k = 0; k < (radius > 0 ? circle.size() : 1); ++k, ++feature) {
      const Vector3 out = radius * (circle[k][0] * down + circle[k][1] * side);
      const Vector3 x = out + y * Vector3::UnitY();
      const Real gap = height + n.dot(x);
      if (!(gap < margin)) continue;
      if (k > 0 && travel != nullptr && gap > travel->spare + radius / 256) {
        const Vector3 axis = pose.rotation.col(1), across_axis = travel->turn - travel->turn.dot(axis) * axis;
        const Vector3 way = travel->move + travel->turn.cross(pose.position + y * axis - origin) +
                            across_axis.cross(pose.rotation * out);
        if (gap + plane.normal.dot(way) > travel->spare + radius / 256) continue;
      }
      reduction.add({pose.position + pose.rotation * x - gap / 2 * plane.normal, gap, feature});
    }
}

// gap = n.x - offset - r for every vertex of the core.
void add_vertices(const Shape& body, const Pose& pose, const Plane& plane, Real margin,
                  Reduction& reduction) {
  const Core core(body);
  const Vector3 n = pose.rotation.transpose() * plane.normal;
  const Real height = plane.normal.dot(pose.position) - plane.offset - core.radius;
  for (int i = 0; i < core.vertex_count; ++i) {
    const Real gap = height + n.dot(core.vertices[i]);
    if (!(gap < margin)) continue;
    const Vector3 x = pose.position + pose.rotation * core.vertices[i];
    reduction.add({x - (core.radius + gap / 2) * plane.normal, gap, static_cast<std::uint32_t>(i)});
  }
}

// Of the parts numbered `part` and `other`; those of the first parts keep their numbers.
PointName with_parts(PointName feature, int part, int other) {
  return feature ^
         (static_cast<std::uint32_t>(part) * 0x9e3779b1U + static_cast<std::uint32_t>(other) * 0x85ebca77U);
}

}  // namespace

Manifold manifold(const Shape& body, const Pose& pose, const Plane& plane, Real margin,
                  const Travel* travel) {
  if (body.index() == 0) return no_manifold();
  const auto own = [&](const Pose& at) { return Vector3(at.rotation.transpose() * plane.normal); };
  Reduction reduction(plane.normal, pose.rotation * skew_direction(own(pose)));
  bool thinned = false;
  each_part(body, pose, [&](int part, const Shape& shape, const Pose& at) {
    const auto* frustum = std::get_if<Frustum>(&shape);
    Reduction of_part(plane.normal,
                      at.rotation * (frustum ? down_on_disc(own(at)) : skew_direction(own(at))));
    if (frustum != nullptr)
      add_discs(*frustum, at, plane, margin, travel, pose.position, of_part);
    else
      add_vertices(shape, at, plane, margin, of_part);
    const Manifold found = of_part.result();
    thinned = thinned || found.thinned;
    for (int k = 0; k < found.count; ++k) {
      ContactPoint point = found.points[static_cast<std::size_t>(k)];
      point.feature = with_parts(point.feature, part, 0);
      reduction.add(point);
    }
  });
  Manifold result = reduction.result();
  result.thinned = result.thinned || thinned;
  return result;
}

void manifolds(const Shape& body, const PartBoxes& boxes, const Pose& pose, const Shape& other,
               const PartBoxes& other_boxes, const Pose& other_pose, Real margin,
               std::vector<PartManifold>& found) {
  found.clear();
  const auto* parts = std::get_if<Compound>(&body);
  const auto* other_parts = std::get_if<Compound>(&other);
  if (parts == nullptr && other_parts == nullptr) {
    const Manifold one = manifold(body, pose, other, other_pose, margin);
    if (one.count > 0) found.push_back({0, 0, one});
    return;
  }
  const auto part_of = [](const Compound* all, int i) { return &all->parts[static_cast<std::size_t>(i)]; };
  std::vector<int> near, other_near;
  boxes.near(seen_from(pose, other_pose, other_boxes.all(), margin), near);
  for (const int i : near) {
    other_boxes.near(seen_from(other_pose, pose, boxes.of(i), margin), other_near);
    for (const int k : other_near) {
      const Shape& one = parts == nullptr ? body : part_of(parts, i)->shape;
      const Shape& two = other_parts == nullptr ? other : part_of(other_parts, k)->shape;
      PartManifold m{
          i, k,
          manifold(one, parts == nullptr ? pose : placed(pose, *part_of(parts, i)), two,
                   other_parts == nullptr ? other_pose : placed(other_pose, *part_of(other_parts, k)),
                   margin)};
      for (int p = 0; p < m.manifold.count; ++p) {
        PointName& feature = m.manifold.points[static_cast<std::size_t>(p)].feature;
        feature = with_parts(feature, i, k);
      }
      if (m.manifold.count > 0) found.push_back(m);
    }
  }
}

void join_faces(std::vector<PartManifold>& found, const Pose& frame) {
  if (found.size() < 2) return;
  constexpr Real flush = epsilon < Real(1e-10) ? Real(1e-9) : Real(1e-4);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vector3& normal = found[i].manifold.normal;
    Reduction joined(normal, frame.rotation * skew_direction(frame.rotation.transpose() * normal));
    bool thinned = false;
    Real unsettled = 0;
    const auto add = [&](const Manifold& one) {
      thinned = thinned || one.thinned;
      unsettled = std::max(unsettled, one.unsettled);
      for (int k = 0; k < one.count; ++k) joined.add(one.points[static_cast<std::size_t>(k)]);
    };
    add(found[i].manifold);
    for (std::size_t k = i + 1; k < found.size();) {
      if ((found[k].manifold.normal - found[i].manifold.normal).norm() > flush) {
        ++k;
        continue;
      }
      add(found[k].manifold);
      found.erase(found.begin() + static_cast<std::ptrdiff_t>(k));
    }
    found[i].manifold = joined.result();
    found[i].manifold.thinned = found[i].manifold.thinned || thinned;
    found[i].manifold.unsettled = unsettled;
  }
}

}  // namespace cylon::engine
