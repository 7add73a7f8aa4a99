#include "engine/forces.h"
#include "engine/geometry/pose.h"
#include "engine/round_below.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <type_traits>
#include <utility>

namespace cylon::engine {

namespace {

// A cap of depth d of a sphere:  V = pi d^2 (3r - d)/3,  centroid (3/4) (2r - d)^2/(3r - d) below the centre.
Submerged below(const Sphere& sphere, const Vector3& position, const Matrix3&, Real height) {
  const Real r = sphere.radius, d = std::clamp(height - (position.y() - r), Real(0), 2 * r);
  Submerged result{pi * d * d * (3 * r - d) / 3, 4 * pi / 3 * r * r * r, position};
  if (d > 0) result.centroid.y() -= Real(0.75) * (2 * r - d) * (2 * r - d) / (3 * r - d);
  return result;
}

// Sums signed tetrahedra from a point of the surface to the faces.  The face that the cut opens lies in the
// surface with that point, so it adds nothing and need not be known.
class Cut {
 public:
  explicit Cut(const Vector3& apex) : apex_(apex) {}

  // One plane polygon, counter-clockwise seen from outside, of which only what lies below the surface counts.
  template <class Vertex>
  void face(std::size_t n, Vertex&& vertex) {
    Vector3 first = Vector3::Zero();
    Vector3 previous = Vector3::Zero();
    int kept = 0;
    const auto keep = [&](const Vector3& p) {
      if (kept == 0)
        first = p;
      else if (kept >= 2)
        tetrahedron(first, previous, p);
      previous = p;
      ++kept;
    };
    for (std::size_t i = 0; i < n; ++i) {
      const Vector3 a = vertex(i), b = vertex((i + 1) % n);
      const Real a_height = a.y() - apex_.y(), b_height = b.y() - apex_.y();
      if (a_height <= 0) keep(a);
      if ((a_height < 0 && b_height > 0) || (a_height > 0 && b_height < 0)) {
        keep(a + a_height / (a_height - b_height) * (b - a));
      }
    }
  }

  Submerged result(Real whole) const {
    return {volume_, whole, volume_ > 0 ? Vector3(apex_ + moment_ / volume_) : apex_};
  }

 private:
  //  V = (a x b).c/6,  centroid (a + b + c)/4, corners from the apex
  void tetrahedron(const Vector3& p, const Vector3& q, const Vector3& s) {
    const Vector3 a = p - apex_, b = q - apex_, c = s - apex_;
    const Real v = a.cross(b).dot(c) / 6;
    volume_ += v;
    moment_ += v / 4 * (a + b + c);
  }

  Vector3 apex_;
  Real volume_ = 0;
  Vector3 moment_ = Vector3::Zero();
};

constexpr std::array<std::array<int, 4>, 6> quads = {
    {{1, 3, 7, 5}, {0, 4, 6, 2}, {2, 6, 7, 3}, {0, 1, 5, 4}, {4, 5, 7, 6}, {0, 2, 3, 1}}};

Submerged below(const Box& box, const Vector3& position, const Matrix3& rotation, Real height) {
  const Vector3& h = box.half_extents;
  Cut cut(Vector3(position.x(), height, position.z()));
  for (const auto& face : quads) {
    cut.face(4, [&](std::size_t i) -> Vector3 {
      const int corner = face[i];  // bit k: the upper side along axis k
      const Vector3 local((corner & 1) ? h.x() : -h.x(), (corner & 2) ? h.y() : -h.y(),
                          (corner & 4) ? h.z() : -h.z());
      return position + rotation * local;
    });
  }
  return cut.result(8 * h.prod());
}

Submerged below(const Hull& hull, const Vector3& position, const Matrix3& rotation, Real height) {
  const auto corner = [&](const std::vector<int>& face, std::size_t i) -> Vector3 {
    return position + rotation * hull.vertices[static_cast<std::size_t>(face[i])];
  };
  Cut cut(Vector3(position.x(), height, position.z()));
  Real highest = position.y();
  for (const auto& face : hull.faces) {
    for (std::size_t i = 0; i < face.size(); ++i) highest = std::max(highest, corner(face, i).y());
  }
  Cut whole(Vector3(position.x(), highest, position.z()));
  for (const auto& face : hull.faces) {
    cut.face(face.size(), [&](std::size_t i) { return corner(face, i); });
    whole.face(face.size(), [&](std::size_t i) { return corner(face, i); });
  }
  return cut.result(whole.result(0).volume);
}

// Bodies of revolution about their y.
template <class S>
requires requires(const S& s) { round_below(s, Vector3(), Real()); }
Submerged below(const S& shape, const Vector3& position, const Matrix3& rotation, Real height) {
  const RoundBelow part = round_below(shape, rotation.col(1), height - position.y());
  Submerged result{part.volume, whole_volume(shape), position};
  if (part.volume > 0) result.centroid += part.moment / part.volume;
  return result;
}

// The sum over the parts:  centroid = sum V_k c_k / sum V_k.
Submerged below(const Compound& compound, const Vector3& position, const Matrix3& rotation, Real height) {
  Submerged all{0, 0, position};
  Vector3 moment = Vector3::Zero();
  for (const ShapePart& part : compound.parts) {
    const Pose at = placed({position, rotation}, part);
    const Submerged one = submerged(part.shape, at.position, at.rotation, height);
    all.volume += one.volume, all.whole += one.whole;
    moment += one.volume * one.centroid;
  }
  if (all.volume > 0) all.centroid = moment / all.volume;
  return all;
}

}  // namespace

Real Water::surface(Time time, const Vector3& point) const {
  const Real t = static_cast<Real>(time);
  if (mode == WaterMode::volume) return level + wave * std::sin(point.x() - speed * t);
  constexpr Real origin = 5, cell = Real(0.25);
  const auto index = [&](Real x) { return std::clamp(std::trunc((x + origin) / cell), Real(0), Real(40)); };
  const Real i = index(point.x()), j = index(point.z());
  return level + wave / 2 * std::sin(speed * t + i) + wave / 2 * std::sin(i * j / 2);
}

Submerged submerged(const Shape& shape, const Vector3& position, const Matrix3& rotation, Real height) {
  return std::visit(
      [&](const auto& s) -> Submerged {
        if constexpr (requires { below(s, position, rotation, height); })
          return below(s, position, rotation, height);
        return {0, 0, position};
      },
      shape);
}

bool displaces(const Shape& shape) {
  if (const auto* compound = std::get_if<Compound>(&shape))
    return std::all_of(compound->parts.begin(), compound->parts.end(),
                       [](const ShapePart& part) { return displaces(part.shape); });
  if (const auto* capsule = std::get_if<Capsule>(&shape)) return capsule->radius > 0;  // else a rod
  return std::visit(
      []<class S>(const S& s) {
        return std::is_same_v<S, std::monostate> || requires { below(s, Vector3(), Matrix3(), Real()); };
      },
      shape);
}

std::optional<Ends> Water::ends() const { return std::nullopt; }

void Water::renumber(const Numbering& part) {
  const auto pick = [&](auto& list) {
    if (list.empty()) return;
    auto whole = std::exchange(list, {});
    for (const int body : part.bodies()) list.push_back(whole[static_cast<std::size_t>(body)]);
  };
  pick(shapes), pick(inside);
}

}  // namespace cylon::engine
