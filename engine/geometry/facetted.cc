#include "engine/geometry/facetted.h"

#include "engine/geometry/reduce.h"
#include "engine/geometry/touch.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::engine {
namespace {

constexpr int polygon_corners = 16;

// Half the angle of a tangent facet: (its angle)^2/2 is rounding, and the angle its tangent.
constexpr Real half_facet = epsilon < Real(1e-10) ? Real(1e-7) : Real(1e-3);

// Of angles from -2 pi to 2 pi.
Real angle_between(Real a, Real b) {
  const Real d = std::abs(a - b), turned = std::abs(d - 2 * pi);
  return std::min({d, turned, std::abs(d - 4 * pi)});
}

// A direction across the axis.
struct Out {
  Real x = 1, z = 0;
};

Out out_at(Real angle) { return {std::cos(angle), std::sin(angle)}; }

const std::array<Out, polygon_corners>& polygon() {
  static const std::array<Out, polygon_corners> corners = [] {
    std::array<Out, polygon_corners> made;
    for (int k = 0; k < polygon_corners; ++k)
      made[index(k)] = out_at(2 * pi * static_cast<Real>(k) / polygon_corners);
    return made;
  }();
  return corners;
}

// Two a round.
constexpr std::size_t most_facets = std::size_t{2} * Facetted::most_rounds,
                      most_corners_of_round = polygon_corners + 2 * most_facets;

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
  Round(const Frustum& frustum, Prisms& prisms) : frustum_(frustum), prisms_(prisms) {
    begin_at(0);
    fill();
  }

  const Shape& shape() const { return *shape_; }

  // Facets towards a normal, and towards a point beside the surface (own axes); whether any is new.
  bool look(const Vector3& normal, const Vector3& point) {
    moved_ = 0;
    const Real across = std::hypot(normal.x(), normal.z()), angle = std::atan2(normal.z(), normal.x());
    const bool has_lowest = across > level_disc;
    // Of a disc that lies on something the corners are spread evenly from its lowest point on.
    if (has_lowest && facets_ == 0 && across < std::abs(normal.y())) begin_at(angle);
    bool any = has_lowest && add(angle);
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
  // How deep a polygon is inside the circle that has its nearest facet by the last move aside.
  Real last_miss() const {
    return (1 - std::cos(moved_)) * std::max(frustum_.low_radius, frustum_.high_radius);
  }
  Real width() const { return 2 * half_facet * std::max(frustum_.low_radius, frustum_.high_radius); }

 private:
  struct Corner {
    Real angle = 0;  // from -pi to 2 pi
    Out out;         // on the unit circle, or where its tangent facet ends
    int facet = 0;   // the number of the tangent facet that it is an end of, from 1
  };
  struct Facet {
    Real angle = 0;
    Out out;
  };

  void begin_at(Real angle) {
    const auto at = [&](int k) {
      const Real a = angle + 2 * pi * static_cast<Real>(k) / polygon_corners;
      return a > pi ? a - 2 * pi : a;
    };
    int lowest = 0;
    for (int k = 1; k < polygon_corners; ++k)
      if (turned(at(k)) < turned(at(lowest))) lowest = k;
    const Out first = out_at(angle);
    count_ = polygon_corners;
    for (int i = 0; i < polygon_corners; ++i) {
      const int k = (lowest + i) % polygon_corners;
      const Out& turn = polygon()[index(k)];
      corners_[index(i)] = {
          at(k), {first.x * turn.x - first.z * turn.z, first.x * turn.z + first.z * turn.x}, 0};
    }
  }

  // Corners of the inscribed polygon, and facets found before, give way.
  bool add(Real angle) {
    Real nearest = pi / polygon_corners;
    for (int k = 0; k < facets_; ++k)
      nearest = std::min(nearest, angle_between(angle, found_[index(k)].angle));
    if (nearest < half_facet / 2) return false;
    if (facets_ == static_cast<int>(found_.size())) return false;  // there is room for all
    moved_ = std::max(moved_, nearest);
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
      insert({angle + side, {out.x - side * out.z, out.z + side * out.x}, facets_});
    return true;
  }

  static Real turned(Real angle) { return angle < 0 ? angle + 2 * pi : angle; }

  void insert(const Corner& corner) {
    int k = count_++;
    for (; k > 0 && turned(corner.angle) < turned(corners_[index(k - 1)].angle); --k)
      corners_[index(k)] = corners_[index(k - 1)];
    corners_[index(k)] = corner;
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
      const Corner& corner = corners_[index(k)];
      const Vector3 out(corner.out.x, 0, corner.out.z);
      h.vertices[index(low_disc ? k : 0)] = frustum_.low_radius * out + frustum_.low * Vector3::UnitY();
      h.vertices[index(lows + (high_disc ? k : 0))] =
          frustum_.high_radius * out + frustum_.high * Vector3::UnitY();
      h.normals[index(k)] = side_normal(corner, corners_[index(k + 1 < n ? k + 1 : 0)], height);
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
  std::array<Facet, most_facets> found_{};
  int facets_ = 0;
  Real moved_ = 0;  // in the last look(), from the nearest facet there was
};

}  // namespace

Facetted::Facetted(const Shape& body, const Pose& pose, const Shape& other, const Pose& other_pose, Real far)
    : shapes_{&body, &other} {
  thread_local std::array<Prisms, 2> storage;
  std::optional<Round> a, b;
  if (const auto* frustum = std::get_if<Frustum>(&body))
    a.emplace(*frustum, storage[0]), shapes_[0] = &a->shape();
  if (const auto* frustum = std::get_if<Frustum>(&other))
    b.emplace(*frustum, storage[1]), shapes_[1] = &b->shape();
  if (!a && !b) return;
  for (const auto* round : {&a, &b})
    if (*round) same_ = std::max(same_, 4 * (*round)->width()), far += (*round)->sagitta();
  for (int round = 0; round < Facetted::most_rounds; ++round) {
    const Couple couple(*shapes_[0], pose, *shapes_[1], other_pose);
    const Real radii = couple.a.radius + couple.b.radius;
    const Touch t = cylon::engine::touch(couple, far + radii);
    touch_ = t;
    if (t.gap - radii > far) return;
    bool any = a && a->look(-t.normal, t.b);
    if (b) any |= b->look(couple.turn.transpose() * t.normal, couple.turn.transpose() * (t.a - couple.shift));
    if (!any) return;
    if (a) shapes_[0] = &a->shape();
    if (b) shapes_[1] = &b->shape();
  }
  touch_.reset();  // there is a facet more
  for (const auto* round : {&a, &b})
    if (*round) unsettled_ = std::max(unsettled_, (*round)->last_miss());
}

}  // namespace cylon::engine
