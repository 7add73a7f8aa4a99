#include "harness/core/solid.h"

#include "harness/core/polyhedron.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace cylon::core {
namespace {

// ---- One shape by itself ------------------------------------------------------------------------
// moments(s): per mass [m^2], axis of revolution along y (Goldstein, Classical Mechanics, ch. 5; handbooks).
// reach(s): distance of the farthest point from the origin [m].
// extent(s, d): max over the shape of d . x, with d a unit vector [m].

double farthest(const std::vector<Vector3>& points) {
  double reach = 0;
  for (const Vector3& p : points) reach = std::max(reach, p.norm());
  return reach;
}

double farthest_along(const std::vector<Vector3>& points, const Vector3& d) {
  double reach = -std::numeric_limits<double>::infinity();
  for (const Vector3& p : points) reach = std::max(reach, d.dot(p));
  return reach;
}

// Of a unit vector against the axis of revolution.
double radial(const Vector3& d) { return std::hypot(d.x(), d.z()); }

Vector3 moments(const std::monostate&) { return Vector3::Ones(); }
double reach(const std::monostate&) { return 0; }
double extent(const std::monostate&, const Vector3&) { return 0; }

Vector3 moments(const Sphere& s) { return Vector3::Constant(0.4 * s.radius * s.radius); }
double reach(const Sphere& s) { return s.radius; }
double extent(const Sphere& s, const Vector3&) { return s.radius; }

Vector3 moments(const Box& s) {
  const Vector3 h = s.half_extents.cwiseAbs2();
  return Vector3(h.y() + h.z(), h.z() + h.x(), h.x() + h.y()) / 3;
}
double reach(const Box& s) { return s.half_extents.norm(); }
double extent(const Box& s, const Vector3& d) { return s.half_extents.dot(d.cwiseAbs()); }

Vector3 moments(const Cylinder& s) {
  const double r2 = s.radius * s.radius, across = (3 * r2 + s.length * s.length) / 12;
  return {across, r2 / 2, across};
}
double reach(const Cylinder& s) { return std::hypot(s.radius, s.length / 2); }
double extent(const Cylinder& s, const Vector3& d) {
  return s.radius * radial(d) + 0.5 * s.length * std::abs(d.y());
}

// A cylinder of length h between two half spheres, shared by volume; a half sphere's centre lies 3 r/8 off
// its flat face, so about the capsule's centre each has 2/5 r^2 + h^2/4 + 3/8 h r per mass.
Vector3 moments(const Capsule& s) {
  const double r = s.radius, h = s.length;
  const double barrel = h / (h + 4 * r / 3), caps = 1 - barrel;
  const Vector3 middle = moments(Cylinder{r, h});
  const double across = barrel * middle.x() + caps * (0.4 * r * r + h * h / 4 + 3 * h * r / 8);
  return {across, barrel * middle.y() + caps * 0.4 * r * r, across};
}
double reach(const Capsule& s) { return s.radius + s.length / 2; }
double extent(const Capsule& s, const Vector3& d) { return s.radius + 0.5 * s.length * std::abs(d.y()); }

Vector3 moments(const Cone& s) {
  const double r2 = s.radius * s.radius, across = 3 * r2 / 20 + 3 * s.length * s.length / 80;
  return {across, 0.3 * r2, across};
}
double reach(const Cone& s) { return std::max(0.75 * s.length, std::hypot(s.radius, s.length / 4)); }
double extent(const Cone& s, const Vector3& d) {
  return std::max(0.75 * s.length * d.y(), s.radius * radial(d) - 0.25 * s.length * d.y());
}

Vector3 moments(const Rod& s) {
  const double across = s.length * s.length / 12;
  return {across, 0, across};
}
double reach(const Rod& s) { return s.length / 2; }
double extent(const Rod& s, const Vector3& d) { return 0.5 * s.length * std::abs(d.y()); }

Vector3 moments(const Disc& s) {
  const double r2 = s.radius * s.radius;
  return {r2 / 4, r2 / 2, r2 / 4};
}
double reach(const Disc& s) { return s.radius; }
double extent(const Disc& s, const Vector3& d) { return s.radius * radial(d); }

double reach(const Hull& s) { return farthest(s.vertices); }
double extent(const Hull& s, const Vector3& d) { return farthest_along(s.vertices, d); }

double reach(const Mesh& s) { return farthest(s.vertices); }
double extent(const Mesh& s, const Vector3& d) { return farthest_along(s.vertices, d); }

double reach(const Compound& s) {
  double result = 0;
  for (const Part& part : s.parts)
    result = std::max(result,
                      part.position.norm() + std::visit([](const auto& p) { return reach(p); }, part.shape));
  return result;
}
double extent(const Compound& s, const Vector3& d) {
  double result = -std::numeric_limits<double>::infinity();
  for (const Part& part : s.parts) {
    const Vector3 own = part.orientation.conjugate() * d;
    const double along = std::visit([&](const auto& p) { return extent(p, own); }, part.shape);
    result = std::max(result, d.dot(part.position) + along);
  }
  return result;
}

// ---- Mass ---------------------------------------------------------------------------------------

template <class Simple>
MassProperties properties(const Simple& shape, double mass) {
  return {mass, Vector3::Zero(), (mass * moments(shape)).asDiagonal()};
}

MassProperties properties(const Solid& solid, double mass) {
  MassProperties p{mass, solid.centre, mass / solid.volume * solid.inertia};
  p.inertia = Matrix3(p.inertia.selfadjointView<Eigen::Upper>());  // as it is, but for rounding
  return p;
}
MassProperties properties(const Mesh& mesh, double mass) {
  return properties(solid(mesh.vertices, mesh.faces), mass);
}
MassProperties properties(const Hull& hull, double mass) {
  return properties(solid(hull.vertices, convex_hull(hull.vertices)), mass);
}

// Parallel axes: I = sum (R I_k R^T + m_k (|d|^2 1 - d d^T)), d from the common centre to the part's.
MassProperties properties(const Compound& compound, double) {
  MassProperties whole;
  std::vector<MassProperties> parts;
  for (const Part& part : compound.parts) {
    MassProperties p =
        std::visit([&](const auto& shape) { return properties(shape, part.mass); }, part.shape);
    const Matrix3 r = part.orientation.toRotationMatrix();
    p.inertia = r * p.inertia * r.transpose();
    p.centre = part.position + r * p.centre;
    whole.mass += p.mass;
    whole.centre += p.mass * p.centre;
    parts.push_back(p);
  }
  whole.centre /= whole.mass;
  for (const MassProperties& p : parts) {
    const Vector3 d = p.centre - whole.centre;
    whole.inertia += p.inertia + p.mass * (d.squaredNorm() * Matrix3::Identity() - d * d.transpose());
  }
  whole.inertia = (whole.inertia + whole.inertia.transpose()).eval() / 2;  // R I R^T is, but for rounding
  return whole;
}

}  // namespace

MassProperties mass_properties(const Shape& shape, double mass) {
  return std::visit([&](const auto& s) { return properties(s, mass); }, shape);
}

void move(Shape& shape, const Vector3& offset) {
  std::visit(
      [&](auto& s) {
        if constexpr (requires { s.vertices; })
          for (Vector3& vertex : s.vertices) vertex += offset;
        else if constexpr (requires { s.parts; })
          for (Part& part : s.parts) part.position += offset;
        else
          static_assert(
              requires { moments(s); }, "only a shape whose origin is its centre of mass stays");
      },
      shape);
}

double bounding_radius(const Shape& shape) {
  return std::visit([](const auto& s) { return reach(s); }, shape);
}

double support(const Shape& shape, const Vector3& d) {
  return std::visit([&](const auto& s) { return extent(s, d); }, shape);
}

std::optional<std::string> impossible(const Matrix3& inertia) {
  Vector3 m = principal_axes(inertia).moments;
  std::sort(m.begin(), m.end());
  const auto listed = [&] { return fmt::format("principal moments {}, {}, {} kg m^2", m[0], m[1], m[2]); };
  if (!(m[0] >= 0) || !(m[1] > 0)) return listed() + ": they must be > 0";
  if (m[0] + m[1] < m[2] * (1 - 1e-12))
    return fmt::format("{}: no body has them, since {} + {} < {}; the largest must be <= {}", listed(), m[0],
                       m[1], m[2], m[0] + m[1]);
  return std::nullopt;
}

}  // namespace cylon::core
