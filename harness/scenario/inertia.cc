#include "harness/scenario/inertia.h"

#include "harness/scenario/polyhedron.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace cylon::scenario {
namespace {

using core::Matrix3;
using core::Vector3;

// Moments per mass [m^2], axis of revolution along y (Goldstein, Classical Mechanics, ch. 5; handbooks).
Vector3 moments(const core::Sphere& s) { return Vector3::Constant(0.4 * s.radius * s.radius); }

Vector3 moments(const core::Box& s) {
  const Vector3 h = s.half_extents.cwiseAbs2();
  return Vector3(h.y() + h.z(), h.z() + h.x(), h.x() + h.y()) / 3;
}

Vector3 moments(const core::Cylinder& s) {
  const double r2 = s.radius * s.radius, across = (3 * r2 + s.length * s.length) / 12;
  return {across, r2 / 2, across};
}

// A cylinder of length h between two half spheres, shared by volume; a half sphere's centre lies 3 r/8 off
// its flat face, so about the capsule's centre each has 2/5 r^2 + h^2/4 + 3/8 h r per mass.
Vector3 moments(const core::Capsule& s) {
  const double r = s.radius, h = s.length;
  const double barrel = h / (h + 4 * r / 3), caps = 1 - barrel;
  const Vector3 middle = moments(core::Cylinder{r, h});
  const double across = barrel * middle.x() + caps * (0.4 * r * r + h * h / 4 + 3 * h * r / 8);
  return {across, barrel * middle.y() + caps * 0.4 * r * r, across};
}

Vector3 moments(const core::Cone& s) {
  const double r2 = s.radius * s.radius, across = 3 * r2 / 20 + 3 * s.length * s.length / 80;
  return {across, 0.3 * r2, across};
}

Vector3 moments(const core::Rod& s) {
  const double across = s.length * s.length / 12;
  return {across, 0, across};
}

Vector3 moments(const core::Disc& s) {
  const double r2 = s.radius * s.radius;
  return {r2 / 4, r2 / 2, r2 / 4};
}

Vector3 moments(const std::monostate&) { return Vector3::Ones(); }

template <class Simple>
MassProperties properties(const Simple& shape, double mass) {
  return {mass, Vector3::Zero(), (mass * moments(shape)).asDiagonal()};
}

MassProperties properties(const Solid& solid, double mass) {
  return {mass, solid.centre, mass / solid.volume * solid.inertia};
}
MassProperties properties(const core::Mesh& mesh, double mass) {
  return properties(solid(mesh.vertices, mesh.faces), mass);
}
MassProperties properties(const core::Hull& hull, double mass) {
  return properties(solid(hull.vertices, convex_hull(hull.vertices)), mass);
}

// Parallel axes: I = sum (R I_k R^T + m_k (|d|^2 1 - d d^T)), d from the common centre to the part's.
MassProperties properties(const core::Compound& compound, double) {
  MassProperties whole;
  std::vector<MassProperties> parts;
  for (const core::Part& part : compound.parts) {
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

double farthest(const std::vector<Vector3>& points) {
  double reach = 0;
  for (const Vector3& p : points) reach = std::max(reach, p.norm());
  return reach;
}

double reach(const std::monostate&) { return 0; }
double reach(const core::Sphere& s) { return s.radius; }
double reach(const core::Box& s) { return s.half_extents.norm(); }
double reach(const core::Capsule& s) { return s.radius + s.length / 2; }
double reach(const core::Cylinder& s) { return std::hypot(s.radius, s.length / 2); }
double reach(const core::Cone& s) { return std::max(0.75 * s.length, std::hypot(s.radius, s.length / 4)); }
double reach(const core::Rod& s) { return s.length / 2; }
double reach(const core::Disc& s) { return s.radius; }
double reach(const core::Hull& s) { return farthest(s.vertices); }
double reach(const core::Mesh& s) { return farthest(s.vertices); }
double reach(const core::Compound& s) {
  double result = 0;
  for (const core::Part& part : s.parts)
    result = std::max(result,
                      part.position.norm() + std::visit([](const auto& p) { return reach(p); }, part.shape));
  return result;
}

}  // namespace

MassProperties mass_properties(const core::Shape& shape, double mass) {
  return std::visit([&](const auto& s) { return properties(s, mass); }, shape);
}

void move(core::Shape& shape, const Vector3& offset) {
  if (auto* hull = std::get_if<core::Hull>(&shape))
    for (Vector3& vertex : hull->vertices) vertex += offset;
  if (auto* mesh = std::get_if<core::Mesh>(&shape))
    for (Vector3& vertex : mesh->vertices) vertex += offset;
  if (auto* compound = std::get_if<core::Compound>(&shape))
    for (core::Part& part : compound->parts) part.position += offset;
}

double bounding_radius(const core::Shape& shape) {
  return std::visit([](const auto& s) { return reach(s); }, shape);
}

std::optional<std::string> impossible(const Matrix3& inertia) {
  Vector3 m = core::principal_axes(inertia).moments;
  std::sort(m.begin(), m.end());
  const auto listed = [&] { return fmt::format("principal moments {}, {}, {} kg m^2", m[0], m[1], m[2]); };
  if (!(m[0] >= 0) || !(m[1] > 0)) return listed() + ": they must be > 0";
  if (m[0] + m[1] < m[2] * (1 - 1e-12))
    return fmt::format("{}: no body has them, since {} + {} < {}; the largest must be <= {}", listed(), m[0],
                       m[1], m[2], m[0] + m[1]);
  return std::nullopt;
}

}  // namespace cylon::scenario
