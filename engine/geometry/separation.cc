#include "engine/geometry/separation.h"

#include "engine/geometry/closed_forms.h"
#include "engine/geometry/facetted.h"
#include "engine/geometry/pair_table.h"
#include "engine/geometry/touch.h"

#include <limits>

namespace cylon::engine {
namespace {

using SeparationOf = Separation (*)(const Shape&, const Pose&, const Shape&, const Pose&);

Separation nothing(const Shape&, const Pose& pose, const Shape&, const Pose& other) {
  return {std::numeric_limits<Real>::infinity(), Vector3::UnitY(), pose.position, other.position};
}

Separation from_touch(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                      const std::optional<Touch>& known) {
  const Couple couple(body, pose, other, other_pose);
  const Touch t = known ? *known : touch(couple);
  const Vector3 a = t.a - couple.a.radius * t.normal, b = t.b + couple.b.radius * t.normal;
  return {t.gap - couple.a.radius - couple.b.radius, pose.rotation * t.normal,
          pose.position + pose.rotation * a, pose.position + pose.rotation * b};
}

Separation general(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  return from_touch(body, pose, other, other_pose, {});
}

template <SeparationOf row>
Separation swapped(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  const Separation s = row(other, other_pose, body, pose);
  return {s.gap, -s.normal, s.other_point, s.point};
}

template <class A, class B>
Separation closed_separation(const Shape& body, const Pose& pose, const Shape& other,
                             const Pose& other_pose) {
  return closed_form(std::get<A>(body), pose, std::get<B>(other), other_pose);
}

template <class A, class B>
concept HasClosedForm = requires(const A& a, const B& b, const Pose& pose) {
  closed_form(a, pose, b, pose);
};

Separation general_round(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  const Facetted facetted(body, pose, other, other_pose);
  return from_touch(facetted.body(), pose, facetted.other(), other_pose, facetted.touch());
}

// The least of all pairs of parts.
Separation of_parts(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  Separation least = nothing(body, pose, other, other_pose);
  each_part(body, pose, [&](int, const Shape& part, const Pose& at) {
    each_part(other, other_pose, [&](int, const Shape& other_part, const Pose& other_at) {
      const Separation s = separation(part, at, other_part, other_at);
      if (s.gap < least.gap) least = s;
    });
  });
  return least;
}

template <class A, class B, class S>
constexpr bool either = std::is_same_v<A, S> || std::is_same_v<B, S>;

constexpr auto separation_table = pair_table([]<class A, class B>() -> SeparationOf {
  if constexpr (std::is_same_v<A, std::monostate> || std::is_same_v<B, std::monostate>)
    return nothing;
  else if constexpr (either<A, B, Compound>)
    return of_parts;
  else if constexpr (HasClosedForm<A, B>)
    return closed_separation<A, B>;
  else if constexpr (HasClosedForm<B, A>)
    return swapped<closed_separation<B, A>>;
  else if constexpr (either<A, B, Frustum>)
    return index_of<A>() <= index_of<B>() ? general_round : swapped<general_round>;
  else
    return index_of<A>() <= index_of<B>() ? general : swapped<general>;
});

}  // namespace

Separation separation(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose) {
  return separation_table[body.index()][other.index()](body, pose, other, other_pose);
}

// gap = min_x n.x - offset, over the shape.
Separation separation(const Shape& body, const Pose& pose, const Plane& plane) {
  if (body.index() == 0) return nothing(body, pose, body, pose);
  const Vector3 n = pose.rotation.transpose() * plane.normal;
  const Vector3 lowest = pose.rotation * farthest(body, -n);
  const Real gap = plane.normal.dot(pose.position) - plane.offset + plane.normal.dot(lowest);
  const Vector3 point = pose.position + lowest;
  return {gap, plane.normal, point, point - gap * plane.normal};
}

}  // namespace cylon::engine
