#include "reference/applied/immersion.h"

#include "harness/core/overloaded.h"
#include "harness/core/solid.h"
#include "reference/applied/parts.h"

#include <algorithm>
#include <array>
#include <limits>
#include <numbers>
#include <stdexcept>

namespace cylon::applied {
namespace {

using core::Vector3;

// A volume and its first moment.
struct Sum {
  double volume = 0;
  Vector3 moment = Vector3::Zero();

  void add(double v, const Vector3& centroid) { volume += v, moment += v * centroid; }
};

// A cap of depth d:  V = pi d^2 (3r - d)/3,  its centroid (3/4) (2r - d)^2/(3r - d) below the centre.
void add_cap(Sum& sum, double r, const Vector3& centre, double height) {
  const double d = std::clamp(height - centre.y() + r, 0.0, 2 * r);
  const double lower = 0.75 * (2 * r - d) * (2 * r - d) / (3 * r - d);
  sum.add(std::numbers::pi * d * d * (3 * r - d) / 3, centre - lower * Vector3::UnitY());
}

// The corners of a triangle's part with y <= height, in their sense; at most four.
struct Kept {
  std::array<Vector3, 4> corner;
  std::size_t count = 0;

  Kept(const std::array<Vector3, 3>& triangle, double height) {
    for (std::size_t i = 0; i < 3; ++i) {
      const Vector3 &a = triangle[i], &b = triangle[(i + 1) % 3];
      const double above_a = a.y() - height, above_b = b.y() - height;
      if (above_a <= 0) corner[count++] = a;
      if ((above_a < 0 && above_b > 0) || (above_a > 0 && above_b < 0))
        corner[count++] = a + above_a / (above_a - above_b) * (b - a);
    }
  }
};

// Gauss: signed tetrahedra between a point of the water's surface and the faces below it fill the volume; the
// face that the cut opens lies in the surface, so its tetrahedra are flat.
//   V = (a x b).c/6,  centroid (apex + a + b + c)/4,  corners from the apex
void add_tetrahedra(Sum& sum, const Vector3& apex, const Kept& kept) {
  for (std::size_t i = 2; i < kept.count; ++i) {
    const Vector3 a = kept.corner[0] - apex, b = kept.corner[i - 1] - apex, c = kept.corner[i] - apex;
    sum.add(a.cross(b).dot(c) / 6, apex + (a + b + c) / 4);
  }
}

// Corner i has the upper side along axis k where bit k of i is set.
const std::vector<core::Triangle> box_faces = {{0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5},
                                               {0, 1, 5}, {0, 5, 4}, {2, 6, 7}, {2, 7, 3},
                                               {0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}};

std::vector<Vector3> corners(const core::Box& box) {
  std::vector<Vector3> result;
  for (int i = 0; i < 8; ++i)
    result.emplace_back(
        box.half_extents.cwiseProduct(Vector3(i & 1 ? 1 : -1, i & 2 ? 1 : -1, i & 4 ? 1 : -1)));
  return result;
}

// A solid's surface that has no volume within, in words, or nothing.
template <class Make>
std::optional<std::string> complaint(const Make& make) try {
  make();
  return std::nullopt;
} catch (const std::invalid_argument& e) {
  return e.what();
}

std::optional<std::string> unmapped_part(const core::Primitive& shape) {
  using Reason = std::optional<std::string>;
  return std::visit(
      core::Overloaded{
          [](const core::Rod&) -> Reason { return "a rod has no volume"; },
          [](const core::Disc&) -> Reason { return "a disc has no volume"; },
          [](const core::Hull& s) { return complaint([&] { core::convex_hull(s.vertices); }); },
          [](const core::Mesh& s) { return complaint([&] { core::solid(s.vertices, s.faces); }); },
          [](const auto&) -> Reason { return std::nullopt; }},
      shape);
}

}  // namespace

std::optional<std::string> Immersion::unmapped(const core::Shape& shape) {
  for (const core::Part& part : parts_of(shape))
    if (auto reason = unmapped_part(part.shape)) return reason;
  return std::nullopt;
}

Immersion::Immersion(const core::Shape& shape) {
  const auto none = [](const auto&) {};
  for (const core::Part& part : parts_of(shape)) {
    const auto add = [&](std::vector<Vector3> vertices, std::vector<core::Triangle> triangles) {
      for (Vector3& v : vertices) v = part.position + part.orientation * v;
      parts_.emplace_back(Faces{std::move(vertices), std::move(triangles)});
    };
    const auto about = [&](const auto& s) {
      parts_.emplace_back(Round{revolved(s), part.position, part.orientation * Vector3::UnitY()});
    };
    std::visit(
        core::Overloaded{[&](const core::Capsule& s) { about(s); },
                         [&](const core::Cylinder& s) { about(s); }, [&](const core::Cone& s) { about(s); },
                         [&](const core::Sphere& s) {
                           parts_.emplace_back(Ball{s.radius, part.position});
                         },
                         [&](const core::Box& s) { add(corners(s), box_faces); },
                         [&](const core::Hull& s) { add(s.vertices, core::convex_hull(s.vertices)); },
                         [&](const core::Mesh& s) { add(s.vertices, s.faces); }, none},
        part.shape);
  }
  whole_ = below(2 * core::bounding_radius(shape), Vector3::Zero(), core::Quaternion::Identity()).volume;
}

// Seen from the body's place, where roundings are the least.
Submerged Immersion::below(double height, const Vector3& position,
                           const core::Quaternion& orientation) const {
  Sum sum;
  const double surface = height - position.y();
  const Vector3 apex(0, surface, 0);
  const auto ball = [&](const Ball& b) { add_cap(sum, b.radius, orientation * b.centre, surface); };
  const auto faces = [&](const Faces& f) {
    for (const core::Triangle& t : f.triangles) {
      const auto corner = [&](std::size_t k) -> Vector3 {
        return orientation * f.vertices[static_cast<std::size_t>(t[k])];
      };
      add_tetrahedra(sum, apex, Kept({corner(0), corner(1), corner(2)}, surface));
    }
  };
  const auto round = [&](const Round& r) {
    const Vector3 centre = orientation * r.centre, axis = orientation * r.axis;
    for (const Revolved& piece : r.pieces) {
      const RevolvedBelow part = applied::below(piece, axis, surface - centre.y());
      sum.volume += part.volume, sum.moment += part.moment + part.volume * centre;
    }
  };
  for (const auto& part : parts_) std::visit(core::Overloaded{ball, faces, round}, part);
  if (!(sum.volume > 0)) return {};
  return {sum.volume, position + sum.moment / sum.volume};
}

}  // namespace cylon::applied
