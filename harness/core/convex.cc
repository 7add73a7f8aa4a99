#include "harness/core/convex.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace cylon::core {
namespace {

// ---- Cores: a shape is all that lies within `margin` of its core ---------------------------------

double sign_of(double x) { return x < 0 ? -1 : 1; }

// Of a circle of radius r about y.
Vector3 on_circle(double r, const Vector3& d) {
  const double across = std::hypot(d.x(), d.z());
  return across > 0 ? Vector3(r * d.x() / across, 0, r * d.z() / across) : Vector3(Vector3::Zero());
}

double margin(const Primitive& shape) {
  if (const auto* sphere = std::get_if<Sphere>(&shape)) return sphere->radius;
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius;
  return 0;
}

Vector3 farthest_of_core(const std::monostate&, const Vector3&) { return Vector3::Zero(); }
Vector3 farthest_of_core(const Sphere&, const Vector3&) { return Vector3::Zero(); }
Vector3 farthest_of_core(const Box& s, const Vector3& d) {
  return s.half_extents.cwiseProduct(Vector3(sign_of(d.x()), sign_of(d.y()), sign_of(d.z())));
}
Vector3 farthest_of_core(const Capsule& s, const Vector3& d) { return {0, sign_of(d.y()) * s.length / 2, 0}; }
Vector3 farthest_of_core(const Rod& s, const Vector3& d) { return {0, sign_of(d.y()) * s.length / 2, 0}; }
Vector3 farthest_of_core(const Disc& s, const Vector3& d) { return on_circle(s.radius, d); }
Vector3 farthest_of_core(const Cylinder& s, const Vector3& d) {
  return on_circle(s.radius, d) + Vector3(0, sign_of(d.y()) * s.length / 2, 0);
}
Vector3 farthest_of_core(const Cone& s, const Vector3& d) {
  const Vector3 tip(0, 0.75 * s.length, 0), rim = on_circle(s.radius, d) - Vector3(0, 0.25 * s.length, 0);
  return d.dot(tip) > d.dot(rim) ? tip : rim;
}
Vector3 farthest_of(const std::vector<Vector3>& points, const Vector3& d) {
  return *std::max_element(points.begin(), points.end(),
                           [&](const Vector3& a, const Vector3& b) { return d.dot(a) < d.dot(b); });
}
Vector3 farthest_of_core(const Hull& s, const Vector3& d) { return farthest_of(s.vertices, d); }
Vector3 farthest_of_core(const Mesh& s, const Vector3& d) { return farthest_of(s.vertices, d); }

Vector3 farthest_of_core(const Primitive& shape, const Vector3& d) {
  return std::visit([&](const auto& s) { return farthest_of_core(s, d); }, shape);
}

Vector3 in_world(const Placed& body, const Vector3& d) {
  return body.position + body.orientation * farthest_of_core(*body.shape, body.orientation.conjugate() * d);
}

// ---- The difference of the cores ----------------------------------------------------------------

// A point a - b of the difference of two cores, and its a.
struct Corner {
  Vector3 at, of_first;
};

// Farthest along d; the difference is that of the first core and the second.
Corner corner(const Placed& first, const Placed& second, const Vector3& d) {
  const Vector3 a = in_world(first, d);
  return {a - in_world(second, -d), a};
}

// A point of a simplex as a mean of its corners.
struct Mean {
  std::vector<std::pair<Corner, double>> of;
  Vector3 at = Vector3::Zero();
  Vector3 of_first() const {
    Vector3 sum = Vector3::Zero();
    for (const auto& [c, weight] : of) sum += weight * c.of_first;
    return sum;
  }
};

// The point of the affine hull of n + 1 corners that is nearest to the origin; nothing where it does not lie
// between them:  sum e_i w_i = -c_0 in the sense of least squares, e_i = c_i - c_0.
template <int n>
std::optional<Mean> nearest_between(const std::vector<Corner>& corners) {
  Eigen::Matrix<double, 3, n> edges;
  for (int i = 0; i < n; ++i) edges.col(i) = corners[static_cast<std::size_t>(i) + 1].at - corners[0].at;
  const Eigen::ColPivHouseholderQR<Eigen::Matrix<double, 3, n>> qr(edges);
  if (qr.rank() < n) return std::nullopt;
  const Eigen::Matrix<double, n, 1> w = qr.solve(-corners[0].at);
  if (!((w.array() >= 0).all() && w.sum() <= 1)) return std::nullopt;
  Mean mean;
  mean.of.emplace_back(corners[0], 1 - w.sum());
  for (int i = 0; i < n; ++i) mean.of.emplace_back(corners[static_cast<std::size_t>(i) + 1], w[i]);
  for (const auto& [c, weight] : mean.of) mean.at += weight * c.at;
  return mean;
}

std::optional<Mean> nearest_of_hull(const std::vector<Corner>& corners) {
  switch (corners.size()) {
    case 1:
      return Mean{{{corners[0], 1.0}}, corners[0].at};
    case 2:
      return nearest_between<1>(corners);
    case 3:
      return nearest_between<2>(corners);
    default:
      return nearest_between<3>(corners);
  }
}

// The nearest point of a simplex of up to four corners, and the corners that it lies between.
Mean nearest_of_simplex(const std::vector<Corner>& corners) {
  Mean best;
  double least = std::numeric_limits<double>::infinity();
  for (unsigned subset = 1; subset < 1u << corners.size(); ++subset) {
    std::vector<Corner> some;
    for (std::size_t i = 0; i < corners.size(); ++i)
      if (subset >> i & 1u) some.push_back(corners[i]);
    if (const auto mean = nearest_of_hull(some); mean && mean->at.norm() < least)
      best = *mean, least = mean->at.norm();
  }
  return best;
}

double size_of(const Placed& a, const Placed& b) {
  double size = (a.position - b.position).norm();
  for (int k = 0; k < 3; ++k)
    for (const Placed* body : {&a, &b})
      size = std::max(size, farthest_of_core(*body->shape, Vector3::Unit(k)).norm());
  return size;
}

// ---- Outside ------------------------------------------------------------------------------------

// The point of the difference that is nearest to the origin; nothing where the cores touch or overlap.
std::optional<Mean> distance_of_cores(const Placed& a, const Placed& b, double size) {
  constexpr int most = 200;
  constexpr double fine = 1e-13;
  Vector3 start = b.position - a.position;
  if (start.isZero(0)) start = Vector3::UnitX();
  std::vector<Corner> simplex = {corner(a, b, start)};
  Mean now = nearest_of_simplex(simplex);
  for (int i = 0; i < most; ++i) {
    if (!(now.at.norm() > fine * size)) return std::nullopt;
    const Corner next = corner(a, b, -now.at);
    // All of the difference lies beyond the plane through `next` across now.at.
    if (now.at.squaredNorm() - now.at.dot(next.at) <= fine * size * now.at.norm()) return now;
    simplex.clear();
    for (const auto& [c, weight] : now.of)
      if (weight > 0) simplex.push_back(c);
    if (simplex.size() > 3) return std::nullopt;  // the origin is inside
    simplex.push_back(next);
    const Mean closer = nearest_of_simplex(simplex);
    if (!(closer.at.norm() < now.at.norm())) return now;  // rounding: no nearer is to be had
    now = closer;
  }
  return now;
}

// ---- Inside -------------------------------------------------------------------------------------

struct Face {
  std::array<std::size_t, 3> corners{};  // counter-clockwise seen from outside
  Vector3 normal = Vector3::UnitY();     // outwards, unit
  double offset = 0;
};

class Polytope {
 public:
  // From corners of the difference in four directions and more; false where they span no volume.
  bool start(const Placed& a, const Placed& b, double size) {
    thin_ = 1e-12 * size;
    const std::array<Vector3, 4> first = {Vector3(1, 1, 1), Vector3(1, -1, -1), Vector3(-1, 1, -1),
                                          Vector3(-1, -1, 1)};
    std::vector<Corner> found;
    for (const Vector3& d : first) found.push_back(corner(a, b, d.normalized()));
    for (int k = 0; k < 3; ++k)
      for (const double sense : {1.0, -1.0}) found.push_back(corner(a, b, sense * Vector3::Unit(k)));
    std::array<std::size_t, 4> seed{};
    // What is thin has corners that few directions find: those across what is known of it.
    for (int round = 0; !spanning(found, seed); ++round) {
      if (round == 2) {
        corners_ = found;
        return false;
      }
      for (const Vector3& d : {flat_normal_, flat_normal_.cross(long_axis_).eval()})
        for (const double sense : {1.0, -1.0}) found.push_back(corner(a, b, sense * d));
    }
    for (const std::size_t i : seed) corners_.push_back(found[i]);
    const Vector3 e = corners_[1].at - corners_[0].at, f = corners_[2].at - corners_[0].at;
    if (e.cross(f).dot(corners_[3].at - corners_[0].at) > 0) std::swap(corners_[1], corners_[2]);
    for (const auto& face : {std::array<std::size_t, 3>{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}) add(face);
    for (const Corner& c : found) include(c);
    return true;
  }

  // Where start() found no volume: the unit normal of the flat difference, along which it has no width.
  const Vector3& flat_normal() const { return flat_normal_; }

  // Its point nearest to the origin, which lies in it: of all triangles of its corners.
  Mean flat_foot() const {
    Mean best{{{corners_[0], 1.0}}, corners_[0].at};
    for (std::size_t i = 0; i < corners_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) {
          const Mean foot = nearest_of_simplex({corners_[i], corners_[j], corners_[k]});
          if (foot.at.norm() < best.at.norm()) best = foot;
        }
    return best;
  }

  Face& nearest() {
    return *std::min_element(faces_.begin(), faces_.end(),
                             [](const Face& x, const Face& y) { return x.offset < y.offset; });
  }

  // False where the corner lies on the polytope already.
  bool include(const Corner& c) {
    const auto below = [&](const Face& f) { return f.normal.dot(c.at) - f.offset; };
    if (std::none_of(faces_.begin(), faces_.end(), [&](const Face& f) { return below(f) > thin_; }))
      return false;
    // Faces in one plane with the corner go too, so that no new one is made of three corners on a line.
    const auto sees = [&](const Face& f) { return below(f) >= -thin_; };
    std::vector<std::pair<std::size_t, std::size_t>> horizon;  // wound as the faces that go
    for (const Face& f : faces_) {
      if (!sees(f)) continue;
      for (std::size_t i = 0; i < 3; ++i) {
        const std::pair edge(f.corners[i], f.corners[(i + 1) % 3]);
        const auto twin = std::find(horizon.begin(), horizon.end(), std::pair(edge.second, edge.first));
        if (twin == horizon.end())
          horizon.push_back(edge);
        else
          horizon.erase(twin);  // between two faces that go
      }
    }
    // Rounding: it would see all, or what it sees has holes.  A closed polytope of v corners has 2 v - 4
    // faces at most.
    const auto seen = static_cast<std::size_t>(std::count_if(faces_.begin(), faces_.end(), sees));
    if (horizon.empty() || faces_.size() - seen + horizon.size() > 2 * (corners_.size() + 1) - 4)
      return false;
    std::erase_if(faces_, sees);
    corners_.push_back(c);
    for (const auto& [i, j] : horizon) add({i, j, corners_.size() - 1});
    return true;
  }

  // A face that rounding has spoilt is not looked at again.
  void drop(Face& f) { f.offset = std::numeric_limits<double>::infinity(); }

  // The point of a face that is nearest to the origin.
  Mean foot(const Face& f) const {
    return nearest_of_simplex({corners_[f.corners[0]], corners_[f.corners[1]], corners_[f.corners[2]]});
  }

 private:
  // Four of the points whose tetrahedron has a volume, as large as comes.
  bool spanning(const std::vector<Corner>& found, std::array<std::size_t, 4>& seed) {
    const auto farthest = [&](auto measure) {
      std::size_t best = 0;
      for (std::size_t i = 0; i < found.size(); ++i)
        if (measure(found[i].at) > measure(found[best].at)) best = i;
      return std::pair(best, measure(found[best].at));
    };
    const Vector3 p = found[0].at;
    const auto [j, length] = farthest([&](const Vector3& x) { return (x - p).norm(); });
    if (!(length > thin_)) return false;
    const Vector3 e = (found[j].at - p) / length;
    long_axis_ = e, flat_normal_ = e.unitOrthogonal();
    const auto [k, width] = farthest([&](const Vector3& x) { return e.cross(x - p).norm(); });
    if (!(width > thin_)) return false;
    const Vector3 n = e.cross(found[k].at - p).normalized();
    flat_normal_ = n;
    const auto [l, height] = farthest([&](const Vector3& x) { return std::abs(n.dot(x - p)); });
    seed = {0, j, k, l};
    return height > thin_;
  }

  void add(const std::array<std::size_t, 3>& corners) {
    Face f{corners, {}, 0};
    const Vector3 &p = corners_[corners[0]].at, &q = corners_[corners[1]].at, &r = corners_[corners[2]].at;
    const Vector3 area = (q - p).cross(r - p);
    if (!(area.norm() > thin_ * thin_)) {  // three corners on a line bound nothing
      faces_.push_back({corners, Vector3::Zero(), std::numeric_limits<double>::infinity()});
      return;
    }
    f.normal = area.normalized();
    f.offset = f.normal.dot(p);
    faces_.push_back(f);
  }

  std::vector<Corner> corners_;
  std::vector<Face> faces_;
  Vector3 long_axis_ = Vector3::UnitX(), flat_normal_ = Vector3::UnitY();
  double thin_ = 0;
};

// Of overlapping cores: the least way out.  Along any direction the way out is an upper bound of it, and the
// nearest face of the polytope a lower one.
Nearest depth_of_cores(const Placed& a, const Placed& b, double size) {
  constexpr int most = 400;
  constexpr double fine = 1e-12;
  const Vector3 apart = b.position - a.position;
  Nearest best{0, apart.norm() > 0 ? Vector3(apart.normalized()) : Vector3::UnitY(), a.position, a.position};
  Polytope polytope;
  if (!polytope.start(a, b, size)) {  // two thin cores that cross, as of capsules
    const Vector3& n = polytope.flat_normal();
    best.normal = n.dot(apart) < 0 ? Vector3(-n) : n;
    best.on_first = best.on_second = polytope.flat_foot().of_first();
    return best;
  }
  double depth = std::numeric_limits<double>::infinity();
  for (int i = 0; i < most; ++i) {
    Face& face = polytope.nearest();
    if (depth - face.offset <= fine * size) break;
    const Corner beyond = corner(a, b, face.normal);
    const double way_out = face.normal.dot(beyond.at);
    if (way_out < depth) {
      depth = way_out;
      const bool found = way_out - face.offset <= fine * size;
      const Mean foot = found ? polytope.foot(face) : Mean{{{beyond, 1.0}}, beyond.at};
      best = {-std::max(0.0, depth), face.normal, foot.of_first(), {}};
    }
    if (!polytope.include(beyond)) polytope.drop(face);
  }
  best.on_second = best.on_first + best.gap * best.normal;
  return best;
}

}  // namespace

Nearest nearest(const Placed& first, const Placed& second) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Placed* body : {&first, &second})
    if (!body->position.allFinite() || !body->orientation.coeffs().allFinite()) return {.gap = nan};
  const double size = size_of(first, second);
  const double a = margin(*first.shape), b = margin(*second.shape);
  Nearest result;
  if (const auto apart = distance_of_cores(first, second, size)) {
    const double distance = apart->at.norm();
    result.gap = distance;
    result.normal = -apart->at / distance;
    result.on_first = apart->of_first();
    result.on_second = result.on_first + distance * result.normal;
  } else {
    result = depth_of_cores(first, second, size);
  }
  result.gap -= a + b;
  result.on_first += a * result.normal;
  result.on_second -= b * result.normal;
  return result;
}

std::vector<Part> convex_parts(const Shape& shape) {
  std::vector<Part> parts;
  const auto add = [&](const Primitive& primitive, const Part& place) {
    const auto* mesh = std::get_if<Mesh>(&primitive);
    Part part = place;
    if (mesh == nullptr) {
      part.shape = primitive;
      if (!std::holds_alternative<std::monostate>(primitive)) parts.push_back(part);
      return;
    }
    for (const auto& face : mesh->faces) {
      Hull triangle;
      for (const int k : face) triangle.vertices.push_back(mesh->vertices[static_cast<std::size_t>(k)]);
      part.shape = triangle;
      parts.push_back(part);
    }
  };
  std::visit(
      [&](const auto& s) {
        if constexpr (std::is_same_v<std::decay_t<decltype(s)>, Compound>)
          for (const Part& part : s.parts) add(part.shape, part);
        else
          add(s, Part());
      },
      shape);
  return parts;
}

Vector3 farthest_point(const Shape& shape, const Vector3& d) {
  const auto of_primitive = [](const Primitive& s, const Vector3& along) {
    return Vector3(farthest_of_core(s, along) + margin(s) * along.normalized());
  };
  if (const auto* compound = std::get_if<Compound>(&shape)) {
    Vector3 best = Vector3::Zero();
    double most = -std::numeric_limits<double>::infinity();
    for (const Part& part : compound->parts) {
      const Vector3 at =
          part.position + part.orientation * of_primitive(part.shape, part.orientation.conjugate() * d);
      if (d.dot(at) > most) best = at, most = d.dot(at);
    }
    return best;
  }
  return std::visit(
      [&](const auto& s) {
        using S = std::decay_t<decltype(s)>;
        if constexpr (std::is_same_v<S, Compound>)
          return Vector3(Vector3::Zero());  // above
        else
          return of_primitive(Primitive(s), d);
      },
      shape);
}

}  // namespace cylon::core
