#include "engine/geometry/facetted.h"

#include "engine/geometry/reduce.h"
#include "engine/geometry/segments.h"
#include "engine/geometry/touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

constexpr int polygon_corners = 16;

// Half the angle of a tangent facet: (its angle)^2/2 is rounding, and the angle its tangent.
constexpr Real half_facet = epsilon < Real(1e-10) ? Real(1e-7) : Real(1e-3);

// Angles are from 0 to 2 pi; of one from -2 pi to 4 pi:
Real turned(Real angle) {
  if (angle < 0) return angle + 2 * pi;
  return angle < 2 * pi ? angle : angle - 2 * pi;
}

Real angle_between(Real a, Real b) {
  const Real d = std::abs(a - b);
  return std::min(d, std::abs(d - 2 * pi));
}

// A direction across the axis.
struct Out {
  Real x, z;
};

Out out_at(Real angle) { return {std::cos(angle), std::sin(angle)}; }

// One turned by the angle of the other.  The sum stands apart from the difference: of the two together GCC 12 makes
// vfmaddsub, whatever -ffp-contract says.
[[gnu::noinline]] Real sum_of_products(Real a, Real b, Real c, Real d) { return a * b + c * d; }
Out operator*(const Out& a, const Out& b) {
  return {a.x * b.x - a.z * b.z, sum_of_products(a.x, b.z, a.z, b.x)};
}

// Corners and the middles of sides: k pi/polygon_corners.
using Polygon = std::array<Out, std::size_t{2} * polygon_corners>;
const Polygon& polygon() {
  static const Polygon made = [] {
    Polygon all;
    for (int k = 0; k < 2 * polygon_corners; ++k)
      all[index(k)] = out_at(pi * static_cast<Real>(k) / polygon_corners);
    return all;
  }();
  return made;
}

// Two a round.
constexpr std::size_t most_facets = std::size_t{2} * Facetted::most_rounds,
                      most_corners_of_round = polygon_corners + 4 * most_facets;

// Hulls of prisms, pyramids and their frusta by the number of corners, kept: what bounds what depends on nothing else.
class Prisms {
 public:
  struct Prism {
    Shape shape = Hull();
    bool low_disc = false, high_disc = false;

    Hull& hull() { return std::get<Hull>(shape); }
  };

  Prism& of(int corners, bool low_disc, bool high_disc) {
    Prism& prism = prisms_[index(corners)];
    if (!prism.hull().faces.empty() && prism.low_disc == low_disc && prism.high_disc == high_disc)
      return prism;
    prism.low_disc = low_disc, prism.high_disc = high_disc;
    join(prism.hull(), corners, low_disc, high_disc);
    return prism;
  }

 private:
  // Low corners, then high ones.  Sides first, counter-clockwise from outside: up at k, back down at k + 1.
  static void join(Hull& h, int n, bool low_disc, bool high_disc) {
    const int lows = low_disc ? n : 1, highs = high_disc ? n : 1;
    const auto low = [&](int k) { return low_disc ? k % n : 0; };
    const auto high = [&](int k) { return lows + (high_disc ? k % n : 0); };
    const int low_face = n, high_face = n + low_disc;
    h = Hull();
    h.vertices.resize(index(lows + highs));
    h.faces.resize(index(n + low_disc + high_disc)), h.normals.resize(h.faces.size());
    for (int k = 0; k < n; ++k) {
      std::vector<int>& face = h.faces[index(k)];
      face = {low(k), high(k)};
      if (high_disc) face.push_back(high(k + 1));
      if (low_disc) face.push_back(low(k + 1));
      h.edges.push_back({low(k), high(k), k, (k + n - 1) % n});
      if (low_disc) h.edges.push_back({low(k), low(k + 1), low_face, k});
      if (high_disc) h.edges.push_back({high(k), high(k + 1), k, high_face});
    }
    for (int k = 0; k < n && low_disc; ++k) h.faces[index(low_face)].push_back(low(k));
    for (int k = 0; k < n && high_disc; ++k) h.faces[index(high_face)].push_back(high(n - 1 - k));
    if (low_disc) h.normals[index(low_face)] = -Vector3::UnitY();
    if (high_disc) h.normals[index(high_face)] = Vector3::UnitY();
  }

  std::array<Prism, most_corners_of_round + 1> prisms_;
};

// The polytope of a frustum.
class Round {
 public:
  Round(const Frustum& frustum, Prisms& prisms) : frustum_(frustum), prisms_(prisms) {}

  // With a facet towards a normal (own axes).
  void begin(const Vector3& normal) {
    forget();
    look(normal);
    fill();
  }

  // The facets there are.
  void forget() {
    facets_ = 0;
    begin_at(0);
  }

  // Requires begin().
  const Shape& shape() const { return *shape_; }

  // Facets towards a normal, and towards a point beside the surface (own axes); whether any is new.
  bool look(const Vector3& normal, const Vector3& point) {
    bool any = look(normal);
    const Real part =
        std::clamp((point.y() - frustum_.low) / (frustum_.high - frustum_.low), Real(0), Real(1));
    const Real radius = frustum_.low_radius + part * (frustum_.high_radius - frustum_.low_radius);
    if (std::hypot(point.x(), point.z()) > Real(0.9) * radius) any |= add(std::atan2(point.z(), point.x()));
    if (any) fill();
    return any;
  }

  // The most that the polygon with all its corners is inside the circle.
  Real sagitta() const {
    return (1 - std::cos(pi / polygon_corners)) * std::max(frustum_.low_radius, frustum_.high_radius);
  }
  // max n.x over the frustum, own axes.
  Real reach(const Vector3& n) const {
    const Real across = std::sqrt(n.x() * n.x() + n.z() * n.z());
    return std::max(frustum_.low_radius * across + frustum_.low * n.y(),
                    frustum_.high_radius * across + frustum_.high * n.y());
  }
  const Frustum& frustum() const { return frustum_; }
  Real width() const { return 2 * half_facet * std::max(frustum_.low_radius, frustum_.high_radius); }

 private:
  struct Corner {
    Real angle;
    Out out;         // on the unit circle, or where its tangent facet ends
    int facet;       // the number of the tangent facet that it is an end of, from 1
    Real next;       // the angle of the corner up to which
    Vector3 normal;  // the side from here on has this
  };
  struct Facet {
    Real angle;
    Out out;
  };

  bool look(const Vector3& normal) {
    const Real across = std::hypot(normal.x(), normal.z());
    if (!(across > level_disc)) return false;
    const Real angle = std::atan2(normal.z(), normal.x());
    // Of a disc that lies on something the corners are spread evenly from its lowest point on.
    if (facets_ == 0 && across < std::abs(normal.y())) begin_at(turned(angle));
    return add(angle);
  }

  void begin_at(Real angle) {
    const auto at = [&](int k) { return angle + 2 * pi * static_cast<Real>(k) / polygon_corners; };
    int lowest = 0;
    while (lowest < polygon_corners && at(lowest) < 2 * pi) ++lowest;
    const Out first = out_at(angle);
    const Real height = frustum_.high - frustum_.low, reach = std::cos(pi / polygon_corners);
    const Real rise = reach * (frustum_.low_radius - frustum_.high_radius);
    const Real length = std::sqrt(height * height + rise * rise), level = height / length;
    for (int i = 0; i < polygon_corners; ++i) {
      const int k = (lowest + i) % polygon_corners;
      const Out side = first * polygon()[index(2 * k + 1)];
      corners_[index(i)] = {turned(at(k)),
                            first * polygon()[index(2 * k)],
                            0,
                            turned(at((k + 1) % polygon_corners)),
                            {level * side.x, rise / length, level * side.z}};
    }
    count_ = polygon_corners;
  }

  // Corners of the inscribed polygon, and facets found before, give way.
  bool add(Real angle) {
    angle = turned(angle);
    Real nearest = pi / polygon_corners;
    for (int k = 0; k < facets_; ++k)
      nearest = std::min(nearest, angle_between(angle, found_[index(k)].angle));
    if (nearest < half_facet / 2) return false;
    if (facets_ == static_cast<int>(found_.size())) return false;  // there is room for all
    int kept = 0;
    for (int k = 0; k < count_; ++k) {
      const Corner& corner = corners_[index(k)];
      const Real middle = corner.facet > 0 ? found_[index(corner.facet - 1)].angle : corner.angle;
      if (angle_between(angle, middle) > 4 * half_facet) corners_[index(kept++)] = corner;
    }
    count_ = kept;
    const Out out = out_at(angle);
    found_[index(facets_++)] = {angle, out};
    for (const Real side : {-half_facet, half_facet})
      insert(angle + side, {out.x - side * out.z, out.z + side * out.x}, facets_);
    // Between a facet and a corner that stays where it is the places come nearer by one ratio only, as those of regula
    // falsi do:  so there are corners as far on both sides as the place may still move.
    if (nearest < pi / polygon_corners)
      for (const Real side : {-nearest / 3, nearest / 3}) add_corner(angle + side);
    return true;
  }

  // On the circle, where there is none yet.
  void add_corner(Real angle) {
    for (int k = 0; k < count_; ++k)
      if (angle_between(turned(angle), corners_[index(k)].angle) < 8 * half_facet) return;
    insert(angle, out_at(angle), 0);
  }

  void insert(Real angle, const Out& out, int facet) {
    angle = turned(angle);
    int k = count_++;
    for (; k > 0 && angle < corners_[index(k - 1)].angle; --k) corners_[index(k)] = corners_[index(k - 1)];
    corners_[index(k)] = {angle, out, facet, -1, Vector3()};
  }

  void fill() {
    const int n = count_;
    const bool low_disc = frustum_.low_radius > 0, high_disc = frustum_.high_radius > 0;
    Prisms::Prism& prism = prisms_.of(n, low_disc, high_disc);
    shape_ = &prism.shape;
    Hull& h = prism.hull();
    const int lows = low_disc ? n : 1;
    const Real height = frustum_.high - frustum_.low;
    for (int k = 0; k < n; ++k) {
      Corner& corner = corners_[index(k)];
      const Corner& next = corners_[index(k + 1 < n ? k + 1 : 0)];
      if (corner.next != next.angle)
        corner.next = next.angle, corner.normal = side_normal(corner, next, height);
      const Vector3 out(corner.out.x, 0, corner.out.z);
      h.vertices[index(low_disc ? k : 0)] = frustum_.low_radius * out + frustum_.low * Vector3::UnitY();
      h.vertices[index(lows + (high_disc ? k : 0))] =
          frustum_.high_radius * out + frustum_.high * Vector3::UnitY();
      h.normals[index(k)] = corner.normal;
    }
  }

  Vector3 side_normal(const Corner& from, const Corner& to, Real height) const {
    if (from.facet > 0 && from.facet == to.facet) return slope(found_[index(from.facet - 1)].out, 1, height);
    // Across the chord, which is `reach` from the axis where the circle is 1.
    const Real x = to.out.z - from.out.z, z = from.out.x - to.out.x, length = std::sqrt(x * x + z * z);
    const Out across{x / length, z / length};
    return slope(across, across.x * from.out.x + across.z * from.out.z, height);
  }

  Vector3 slope(const Out& out, Real reach, Real height) const {
    return Vector3(height * out.x, reach * (frustum_.low_radius - frustum_.high_radius), height * out.z)
        .normalized();
  }

  const Frustum& frustum_;
  Prisms& prisms_;
  const Shape* shape_ = nullptr;
  std::array<Corner, most_corners_of_round> corners_;  // ascending, from 0
  int count_ = 0;
  std::array<Facet, most_facets> found_;
  int facets_ = 0;
};

// One of two shapes: a frustum, or another with its core.
class Half {
 public:
  Half(const Shape& shape, Prisms& prisms) {
    if (const auto* frustum = std::get_if<Frustum>(&shape))
      round.emplace(*frustum, prisms);
    else
      core_.emplace(shape);
  }

  // max n.x without the rounding radius, own axes.
  Real reach(const Vector3& n) const {
    return round ? round->reach(n) : n.dot(core_->vertices[core_->support(n)]);
  }
  Real radius() const { return round ? 0 : core_->radius; }

  // use(n, own axes) with what may be the normal out of it towards a point.
  template <class Use>
  void each_normal(const Vector3& point, Use&& use) const {
    if (round) {
      use(Vector3(0, std::copysign(Real(1), point.y()), 0));
      return;
    }
    int best = -1;
    Real most = 0;
    for (int i = 0; i < core_->face_count; ++i) {
      const Real height = core_->normals[i].dot(point - core_->vertices[core_->faces[i][0]]);
      if (best < 0 || height > most) most = height, best = i;
    }
    if (best >= 0) use(core_->normals[best]);
  }

  // The axis of a body of revolution, from its middle to its upper end; of others only the reference point.
  struct Axis {
    Real middle, half;
  };
  Axis axis() const {
    if (round)
      return {(round->frustum().low + round->frustum().high) / 2,
              (round->frustum().high - round->frustum().low) / 2};
    return {0, core_->vertex_count == 2 ? core_->size : 0};
  }

  std::optional<Round> round;

 private:
  std::optional<Core> core_;
};

}  // namespace

Facetted::Facetted(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose, Real far)
    : shapes_{&body, &other} {
  thread_local std::array<Prisms, 2> storage;
  Half a(body, storage[0]), b(other, storage[1]);
  if (!a.round && !b.round) return;
  const Matrix3 turn = pose.rotation.transpose() * other_pose.rotation;
  const Vector3 shift = pose.rotation.transpose() * (other_pose.position - pose.position);
  const Real radii = a.radius() + b.radius();
  // What a plane with the normal n (a's axes) has between the two, exactly.
  const auto between = [&](const Vector3& n) {
    return -a.reach(-n) - b.reach(turn.transpose() * n) - n.dot(shift);
  };

  // The first facets are towards the best of the normals of faces and of the one between the axes: where bodies lie
  // on each other, it is the normal.
  Vector3 normal = Vector3::UnitY();
  Real gap = -std::numeric_limits<Real>::infinity();
  const auto offer = [&](const Vector3& n) {
    if (const Real g = between(n); g > gap) gap = g, normal = n;
  };
  a.each_normal(shift, [&](const Vector3& n) { offer(-n); });
  b.each_normal(turn.transpose() * -shift, [&](const Vector3& n) { offer(turn * n); });
  const Half::Axis axis_a = a.axis(), axis_b = b.axis();
  const Vector3 u = Vector3::UnitY(), w = turn.col(1), p = axis_a.middle * u, q = shift + axis_b.middle * w;
  const SegmentPoints nearest = nearest_on_segments(p, u, axis_a.half, q, w, axis_b.half);
  const Vector3 d = p + nearest.s * u - q - nearest.t * w;
  if (const Real distance = d.norm(); distance > 0) offer(d / distance);
  if (gap - radii > far) {
    is_far_ = true;
    return;
  }
  if (a.round) a.round->begin(-normal), shapes_[0] = &a.round->shape();
  if (b.round) b.round->begin(turn.transpose() * normal), shapes_[1] = &b.round->shape();

  for (const Half* half : {&a, &b})
    if (half->round) same_ = std::max(same_, 4 * half->round->width()), far += half->round->sagitta();
  for (int round = 0;; ++round) {
    const Couple couple(*shapes_[0], pose, *shapes_[1], other_pose);
    const Touch t = cylon::engine::touch(couple, far + radii, touch_ ? &*touch_ : nullptr);
    touch_ = t;
    if (t.gap - radii > far) return;
    const Real off = t.gap - between(t.normal);
    const bool is_exact = off <= half_facet * half_facet / 2 * couple.size;
    if (round == most_rounds - 1) {
      unsettled_ = off;
      return;
    }
    // A facet beside the place might be the one that looks at the other most.
    for (Half* half : {&a, &b})
      if (round == 0 && !is_exact && half->round) half->round->forget();
    bool any = a.round && a.round->look(-t.normal, t.b);
    if (b.round) any |= b.round->look(turn.transpose() * t.normal, turn.transpose() * (t.a - shift));
    if (a.round) shapes_[0] = &a.round->shape();
    if (b.round) shapes_[1] = &b.round->shape();
    if (!any || is_exact) return;
  }
}

}  // namespace cylon::engine
