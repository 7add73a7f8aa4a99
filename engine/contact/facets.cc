#include "engine/contact/facets.h"

#include "engine/geometry/core.h"
#include "engine/geometry/segments.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {

namespace {

// A point nearer than this part of the size to a vertex or an edge is on it: more than the margin within which
// surfaces touch.
constexpr Real same = (is_double ? 16384 : 256) * epsilon;
// A point that has left its facet by this part of the size is on another one: so far that this is seen.
constexpr Real slack = 64 * same;
// Edges with a smaller sine between them count as parallel, and normals that differ by more are different.
constexpr Real least_sine = is_double ? Real(1e-6) : Real(1e-3);

// The face with this outward normal, or -1.
int face_across(const Core& core, const Vector3& outward) {
  for (int i = 0; i < core.face_count; ++i)
    if ((core.normals[i] - outward).squaredNorm() < least_sine * least_sine) return i;
  return -1;
}

Facet edge_of(const Core& core, int k) {
  Facet facet;
  facet.kind = Facet::Kind::edge;
  const Vector3 &from = core.vertices[core.edges[k][0]], &to = core.vertices[core.edges[k][1]];
  facet.at = (from + to) / 2;
  facet.half = (to - from).norm() / 2;
  facet.along = (to - from) / (2 * facet.half);
  return facet;
}

// Of a core: a segment's edge where it has one, else its vertex.
Facet whole(const Core& core) {
  if (core.edge_count > 0) return edge_of(core, 0);
  return {Facet::Kind::vertex, core.vertices[0]};
}

Facet facet_at(const Core& core, const Vector3& x, const Vector3& outward) {
  const Real tolerance = same * core.size;
  Facet facet{Facet::Kind::face, x};
  for (int i = 0; i < core.vertex_count && facet.kind == Facet::Kind::face; ++i)
    if ((core.vertices[i] - x).norm() <= tolerance) facet = {Facet::Kind::vertex, core.vertices[i]};
  for (int k = 0; k < core.edge_count && facet.kind == Facet::Kind::face; ++k) {
    const Facet edge = edge_of(core, k);
    const Real s = std::clamp(edge.along.dot(x - edge.at), -edge.half, edge.half);
    if ((edge.at + s * edge.along - x).norm() <= tolerance) facet = edge;
  }
  if (facet.kind == Facet::Kind::face && core.face_count == 0) facet = whole(core);
  facet.face = face_across(core, outward);
  return facet;
}

// How far x is inside a face, body axes; without bound where there is none.
Real room_on_face(const Core& core, int face, const Vector3& x) {
  Real room = std::numeric_limits<Real>::infinity();
  if (face < 0) return room;
  const std::vector<int>& ring = core.faces[face];
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vector3& from = core.vertices[ring[i]];
    const Vector3 side = core.vertices[ring[(i + 1) % ring.size()]] - from;
    room = std::min(room, core.normals[face].cross(side).dot(x - from) / side.norm());
  }
  return room + slack * core.size;
}

// How far the way d out of an edge or a vertex, body axes, is from a way out of a facet beside it: over a face
// where it goes into that, beside another edge where it goes along it.
Real room_beside(const Core& core, const Facet& facet, const Vector3& d) {
  Real beyond = -std::numeric_limits<Real>::infinity();
  for (int k = 0; k < core.edge_count; ++k) {
    const Facet edge = edge_of(core, k);
    const Vector3 to_end = facet.at - edge.at;
    if (facet.kind == Facet::Kind::edge && to_end.isZero(0)) {
      for (const int face : {core.edges[k][2], core.edges[k][3]}) {
        if (face < 0) continue;
        const Vector3 inward = core.normals[face].cross(edge.along) * (face == core.edges[k][2] ? 1 : -1);
        beyond = std::max(beyond, inward.dot(d));
      }
    } else if (facet.kind == Facet::Kind::vertex && core.face_count > 0) {
      for (const int end : {0, 1})
        if (core.vertices[core.edges[k][static_cast<std::size_t>(end)]] == facet.at)
          beyond = std::max(beyond, (end == 0 ? 1 : -1) * edge.along.dot(d));
    }
  }
  return slack * core.size - beyond;
}

// The nearest_points points of two cores by their facets, and how the normal turns.
struct NearestPoints {
  Vector3 a, b, n, turning;
  Real s = 0;             // n.(a - b)
  bool a_slides = false;  // along its edge
  bool b_slides = false;
};

struct Carried {
  const Body& body;
  const Motion& motion;
  Matrix3 turn = motion.orientation.toRotationMatrix();
  Vector3 w = spin_of(body, motion);

  Vector3 place(const Vector3& x) const { return motion.position + turn * x; }
  Vector3 velocity_at(const Vector3& x) const {
    return velocity(body, motion) + w.cross(x - motion.position);
  }
};

// n' = (I - n n) sign (e_a x e_b)'/|e_a x e_b|,  n = sign e_a x e_b/|e_a x e_b|.
Vector3 turning_of_edges(const Vector3& e_a, const Vector3& w_a, const Vector3& e_b, const Vector3& w_b,
                         const Vector3& n) {
  const Vector3 c = e_a.cross(e_b);
  const Vector3 rate = w_a.cross(e_a).cross(e_b) + e_a.cross(w_b.cross(e_b));
  return (rate - n.dot(rate) * n) / c.dot(n);
}

NearestPoints on_edges(const FacetPair& p, const Carried& a, const Carried& b) {
  const Vector3 e_a = a.turn * p.body.along, e_b = b.turn * p.other.along;
  const Vector3 from_a = a.place(p.body.at), d = from_a - b.place(p.other.at);
  NearestPoints near;
  const Vector3 c = e_a.cross(e_b);
  near.n = c.normalized() * (c.dot(a.turn * p.normal) < 0 ? -1 : 1);
  near.turning = turning_of_edges(e_a, a.w, e_b, b.w, near.n);
  near.s = near.n.dot(d);
  const Vector3 across = e_b.cross(near.n);
  near.a = from_a - d.dot(across) / e_a.dot(across) * e_a;
  near.b = near.a - near.s * near.n;
  near.a_slides = near.b_slides = true;
  return near;
}

NearestPoints on_round(const FacetPair& p, const Carried& a, const Carried& b) {
  const Vector3 e_a = a.turn * p.body.along, e_b = b.turn * p.other.along;
  const Vector3 from_a = a.place(p.body.at), from_b = b.place(p.other.at);
  const SegmentPoints where = nearest_on_segments(from_a, e_a, p.body.half, from_b, e_b, p.other.half);
  NearestPoints near;
  near.a_slides = std::abs(where.s) < p.body.half, near.b_slides = std::abs(where.t) < p.other.half;
  near.a = from_a + where.s * e_a, near.b = from_b + where.t * e_b;
  const Vector3 d = near.a - near.b;
  near.s = d.norm();
  near.n = near.s > 0 ? Vector3(d / near.s) : Vector3(a.turn * p.normal);
  if (near.a_slides && near.b_slides && e_a.cross(e_b).norm() > least_sine) {
    near.turning = turning_of_edges(e_a, a.w, e_b, b.w, near.n);
    return near;
  }
  if (near.a_slides && near.b_slides) near.b_slides = false;
  const Vector3& w = near.a_slides ? a.w : b.w;
  Vector3 seen = a.velocity_at(near.a) - b.velocity_at(near.b) - w.cross(d);
  if (near.a_slides) seen -= e_a.dot(seen) * e_a;
  if (near.b_slides) seen -= e_b.dot(seen) * e_b;
  seen -= near.n.dot(seen) * near.n;
  near.turning = w.cross(near.n);
  if (near.s > 0) near.turning += seen / near.s;
  return near;
}

NearestPoints nearest_points(const FacetPair& p, const Carried& a, const Carried& b) {
  if (p.law == FacetPair::Law::edges) return on_edges(p, a, b);
  if (p.law == FacetPair::Law::round) return on_round(p, a, b);
  const Vector3 x_a = a.place(p.body.at), x_b = b.place(p.other.at);
  NearestPoints near;
  if (p.law == FacetPair::Law::face_of_other) {
    near.n = b.turn * p.other_normal;
    near.turning = b.w.cross(near.n);
    near.s = near.n.dot(x_a - x_b);
    near.a = x_a, near.b = x_a - near.s * near.n;
  } else if (p.law == FacetPair::Law::face_of_body) {
    near.n = a.turn * p.normal;
    near.turning = a.w.cross(near.n);
    near.s = near.n.dot(x_a - x_b);
    near.b = x_b, near.a = x_b + near.s * near.n;
  } else {
    near.n = (a.turn * p.normal + b.turn * p.other_normal).normalized();
    near.turning = (a.w + b.w).cross(near.n) / 2;
    near.s = near.n.dot(x_a - x_b);
    const Vector3 middle = (x_a + x_b) / 2;
    near.a = middle + near.s / 2 * near.n, near.b = middle - near.s / 2 * near.n;
  }
  return near;
}

}  // namespace

FacetPair facets_at(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose,
                    const Vector3& x, const Vector3& n, Real gap) {
  using Kind = Facet::Kind;
  using Law = FacetPair::Law;
  const Core a(body), b(other);
  FacetPair p;
  p.normal = pose.rotation.transpose() * n;
  p.other_normal = other_pose.rotation.transpose() * n;
  const Vector3 x_a = pose.rotation.transpose() * (x + (gap / 2 + a.radius) * n - pose.position);
  const Vector3 x_b = other_pose.rotation.transpose() * (x - (gap / 2 + b.radius) * n - other_pose.position);
  p.body = facet_at(a, x_a, -p.normal);
  p.other = facet_at(b, x_b, p.other_normal);
  if (p.body.kind == Kind::face && p.other.kind != Kind::face) {
    p.law = Law::face_of_body;
  } else if (p.other.kind == Kind::face && p.body.kind != Kind::face) {
    p.law = Law::face_of_other;
  } else if (p.body.kind == Kind::face || a.radius + b.radius == 0) {
    const Vector3 e_a = pose.rotation * p.body.along, e_b = other_pose.rotation * p.other.along;
    const Real along = e_a.cross(e_b).dot(n), sine = e_a.cross(e_b).norm();
    const bool edges = p.body.kind == Kind::edge && p.other.kind == Kind::edge;
    if (edges && sine > least_sine && std::abs(along) > (1 - least_sine * least_sine) * sine)
      p.law = Law::edges;
    else if (p.body.kind == Kind::vertex && p.other.kind == Kind::edge && p.other.face >= 0)
      p.law = Law::face_of_other;
    else if (p.other.kind == Kind::vertex && p.body.kind == Kind::edge && p.body.face >= 0)
      p.law = Law::face_of_body;
    else
      p.law = Law::flush;
  } else {
    p.law = Law::round;
    if (a.face_count == 0) p.body = whole(a);
    if (b.face_count == 0) p.other = whole(b);
  }
  // The normal of a face is that of the core, and what is above it a point.
  const auto settle = [](Facet& below, const Core& core, const Vector3& at_below, Vector3& normal, Real sign,
                         Facet& above, const Vector3& at_above) {
    if (below.face >= 0) normal = sign * core.normals[below.face];
    below.at = at_below;
    if (above.kind != Kind::vertex) above.at = at_above;
  };
  if (p.law == Law::face_of_other) settle(p.other, b, x_b, p.other_normal, 1, p.body, x_a);
  if (p.law == Law::face_of_body) settle(p.body, a, x_a, p.normal, -1, p.other, x_b);
  if (p.law == Law::flush) p.body.at = x_a, p.other.at = x_b;
  return p;
}

void place_touch(const FacetPair& p, const Body& body, const Motion& motion, Real radius, const Body& other,
                 const Motion& other_motion, Real other_radius, TouchPoint& touch) {
  const Carried a{body, motion}, b{other, other_motion};
  const NearestPoints near = nearest_points(p, a, b);
  touch.normal = near.n;
  touch.turning = near.turning;
  touch.gap = near.s - radius - other_radius;
  touch.position = near.b + (other_radius + touch.gap / 2) * near.n;
  const Vector3 v_a = a.velocity_at(near.a), v_b = b.velocity_at(near.b);
  const auto bend = [&](const Carried& c, const Vector3& x) {
    return near.n.dot(c.w.cross(c.w.cross(x - c.motion.position)));
  };
  touch.curvature = bend(a, near.a) - bend(b, near.b) + 2 * near.turning.dot(v_a - v_b) -
                    near.s * near.turning.squaredNorm();
  // The point goes with what does not slide along its facet; where two edges cross, along both:
  //   c_a' = v_a + l e_a,  l = (s n' - v_a + v_b).(e_b x n)/(e_a.(e_b x n)).
  const Vector3 with_a = v_a - radius * near.turning, with_b = v_b + other_radius * near.turning;
  if (p.law == FacetPair::Law::flush) {
    touch.path = (with_a + with_b) / 2;
  } else if (near.a_slides && near.b_slides) {
    const Vector3 e_a = a.turn * p.body.along, across = (b.turn * p.other.along).cross(near.n);
    const Real l = (near.s * near.turning - v_a + v_b).dot(across) / e_a.dot(across);
    touch.path = with_a + l * e_a;
  } else {
    const bool with_other = p.law == FacetPair::Law::face_of_body || near.a_slides;
    touch.path = with_other ? with_b : with_a;
  }
}

bool only_facets_touch(const FacetPair& p, const Shape& body, const Shape& other, const Motion& start,
                       const Motion& end, const Motion& other_start, const Motion& other_end,
                       const Turning& bounds, Real span) {
  using Law = FacetPair::Law;
  if (p.law == Law::flush) return false;
  const Core a(body), b(other);
  const Body still = make_body(1, Matrix3::Identity(), true);  // only places are asked for
  struct End {
    Carried a, b;
    NearestPoints near;
  };
  const auto at = [&](const Motion& m, const Motion& o) -> End {
    const Carried first{still, m}, second{still, o};
    return {first, second, nearest_points(p, first, second)};
  };
  const End first = at(start, other_start), last = at(end, other_end);
  // |n'|: that of the body with the face; two edges: 1/sin of the angle between them times that of both; round:
  // the relative speed over the distance of the cores besides.
  const Real both = bounds.body + bounds.other;
  const auto sine = [&](const End& e) {
    return (e.a.turn * p.body.along).cross(e.b.turn * p.other.along).norm();
  };
  const bool edges = p.body.half > 0 && p.other.half > 0;
  Real turning = p.law == Law::face_of_other ? bounds.other : bounds.body;
  if (p.law == Law::edges || p.law == Law::round) {
    turning = both;
    const Real least = std::min(sine(first), sine(last)) - both * span;
    if (edges && !(least > least_sine)) return false;
    if (edges) turning = both / least;
    if (p.law == Law::round) turning += both + bounds.speed / (a.radius + b.radius);
  }
  const auto clear = [&](const Core& core, const Facet& facet, Real spin, const auto& turn, Real side) {
    for (int i = 0; i < core.vertex_count; ++i) {
      const Vector3 way = core.vertices[i] - facet.at;
      const bool own = facet.kind == Facet::Kind::edge
                           ? (way - facet.along.dot(way) * facet.along).norm() <= same * core.size
                           : way.norm() <= same * core.size;
      if (own) continue;
      const Real f = side * first.near.n.dot(turn(first) * way), g = side * last.near.n.dot(turn(last) * way);
      if (!(f + g > way.norm() * (spin + turning) * span)) return false;
    }
    return true;
  };
  return (p.law == Law::face_of_body ||
          clear(
              a, p.body, bounds.body, [](const End& e) { return e.a.turn; }, 1)) &&
         (p.law == Law::face_of_other ||
          clear(
              b, p.other, bounds.other, [](const End& e) { return e.b.turn; }, -1));
}

Real room_on(const FacetPair& p, const Shape& body, const Pose& pose, const Shape& other,
             const Pose& other_pose) {
  using Law = FacetPair::Law;
  const Core a(body), b(other);
  const auto in_body = [&](const Vector3& x) -> Vector3 {
    return pose.rotation.transpose() * (x - pose.position);
  };
  const auto in_other = [&](const Vector3& x) -> Vector3 {
    return other_pose.rotation.transpose() * (x - other_pose.position);
  };
  const Vector3 x_a = pose.position + pose.rotation * p.body.at;
  const Vector3 x_b = other_pose.position + other_pose.rotation * p.other.at;
  const auto on_body = [&] { return room_on_face(a, p.body.face, in_body(x_b)); };
  const auto on_other = [&] { return room_on_face(b, p.other.face, in_other(x_a)); };
  if (p.law == Law::face_of_other) return on_other();
  if (p.law == Law::face_of_body) return on_body();
  if (p.law == Law::flush) return std::min(on_body(), on_other());
  const Vector3 e_a = pose.rotation * p.body.along, e_b = other_pose.rotation * p.other.along;
  if (p.law == Law::edges) {
    const Vector3 n = e_a.cross(e_b), d = x_a - x_b;
    const Real s = -d.dot(e_b.cross(n)) / e_a.dot(e_b.cross(n)),
               t = d.dot(e_a.cross(n)) / e_b.dot(e_a.cross(n));
    return std::min(p.body.half + slack * a.size - std::abs(s), p.other.half + slack * b.size - std::abs(t));
  }
  const SegmentPoints where = nearest_on_segments(x_a, e_a, p.body.half, x_b, e_b, p.other.half);
  const Vector3 d = x_a + where.s * e_a - x_b - where.t * e_b;
  return std::min(room_beside(a, p.body, -(pose.rotation.transpose() * d)),
                  room_beside(b, p.other, other_pose.rotation.transpose() * d));
}

}  // namespace cylon::engine
