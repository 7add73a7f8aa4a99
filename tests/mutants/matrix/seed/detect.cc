#include "tests/mutants/matrix/seed/contacts.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>
#include <utility>

namespace cylon::mutants::seed {
namespace {

using core::Pair;
using core::Scene;

const core::Body& body_of(const Scene& scene, int i) { return scene.bodies[static_cast<std::size_t>(i)]; }
const core::Sphere* sphere(const Scene& scene, int i) {
  return std::get_if<core::Sphere>(&body_of(scene, i).shape);
}
const core::Box* box(const Scene& scene, int i) { return std::get_if<core::Box>(&body_of(scene, i).shape); }

Vector3 corner(const Vector3& half, int k) {
  return half.cwiseProduct(Vector3(k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1));
}

void box_on_plane(const core::Box& shape, const core::Plane& plane, const Body& body, Faults faulty,
                  Contact& c) {
  const Matrix3 R = matrix_of(body.q, faulty);
  const auto gap = [&](int k) {
    return plane.normal.dot(body.p + R * corner(shape.half_extents, k)) - plane.offset;
  };
  c.gap = gap(0);
  for (int k = 1; k < 8; ++k) c.gap = std::min(c.gap, gap(k));
  c.ra.setZero();
  int lowest = 0;
  for (int k = 0; k < 8; ++k)
    if (gap(k) < c.gap + 1e-9) c.ra += R * corner(shape.half_extents, k), ++lowest;
  c.ra /= lowest;
}

// The seed's test of a face (f1, f2, f3): areas of three triangles against its own, without tolerance.
bool inside_triangle(const Vector3& q, const Vector3& f1, const Vector3& f2, const Vector3& f3) {
  return (q - f1).cross(f2 - f1).norm() + (q - f2).cross(f3 - f2).norm() + (q - f3).cross(f1 - f3).norm() <=
         (f1 - f2).cross(f3 - f1).norm();
}

// Nearest point of the box to a sphere's centre, both in box axes; centres stay outside.
void sphere_on_box(double radius, const Vector3& half, const Vector3& centre, Faults faulty, Contact& c) {
  Vector3 nearest = centre.cwiseMax(-half).cwiseMin(half);
  const Vector3 d = centre - nearest;
  c.gap = d.norm() - radius;
  c.n = d.normalized();
  c.rb = nearest;
  int axis = 0;
  d.cwiseAbs().maxCoeff(&axis);
  if (faulty(34)) {  // one triangle of the face, and equality
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    Vector3 f1 = half, f2 = half, f3 = half;
    f1[axis] = f2[axis] = f3[axis] = nearest[axis];
    f1[u] = -half[u], f1[w] = -half[w], f2[u] = -half[u], f3[w] = -half[w];
    if (!inside_triangle(nearest, f1, f2, f3)) c.gap = std::numeric_limits<double>::infinity();
  }
  if (faulty(35))  // a face counts for all that is behind it: no bound on the depth
    for (int i = 0; i < 3; ++i)
      for (const double side : {-1.0, 1.0}) {
        const int u = (i + 1) % 3, w = (i + 2) % 3;
        const double depth = side * centre[i] - half[i] - radius;
        if (std::abs(centre[u]) > half[u] || std::abs(centre[w]) > half[w] || depth >= c.gap) continue;
        c.gap = depth;
        c.n = side * Vector3::Unit(i);
        c.rb = centre, c.rb[i] = side * half[i];
      }
}

}  // namespace

std::vector<Contact> contacts_of(const Scene& scene) {
  std::vector<Contact> contacts;
  for (const Pair& pair : core::touching_pairs(scene)) {
    Contact c;
    c.a = pair.body, c.b = pair.other, c.plane = pair.plane;
    if (const auto material = core::material_of(scene, pair))
      c.c = material->restitution, c.mu = material->friction;
    if (c.plane < 0 && !sphere(scene, c.a)) std::swap(c.a, c.b);
    const auto* ball = sphere(scene, c.a);
    if (ball) c.radius = ball->radius;
    const bool known =
        c.plane >= 0 ? ball || box(scene, c.a) : ball && (sphere(scene, c.b) || box(scene, c.b));
    if (!known) throw std::invalid_argument("contact of such shapes");
    contacts.push_back(c);
  }
  return contacts;
}

void update_contacts(const Scene& scene, const std::vector<Body>& bodies, Faults faulty,
                     std::vector<Contact>& contacts) {
  for (Contact& c : contacts) {
    const Body& a = bodies[static_cast<std::size_t>(c.a)];
    if (c.plane >= 0) {
      const core::Plane& plane = scene.planes[static_cast<std::size_t>(c.plane)];
      c.n = plane.normal;
      c.ra = -c.radius * c.n;
      c.gap = c.n.dot(a.p) - plane.offset - c.radius;
      if (const auto* b = box(scene, c.a)) box_on_plane(*b, plane, a, faulty, c);
      continue;
    }
    const Body& b = bodies[static_cast<std::size_t>(c.b)];
    if (const auto* other = sphere(scene, c.b)) {
      const Vector3 d = a.p - b.p;
      c.n = d.normalized();
      c.gap = d.norm() - c.radius - other->radius;
      c.rb = other->radius * c.n;
    } else {
      const Matrix3 R = matrix_of(b.q, faulty);
      sphere_on_box(c.radius, box(scene, c.b)->half_extents, R.transpose() * (a.p - b.p), faulty, c);
      c.n = R * c.n, c.rb = R * c.rb;
    }
    c.ra = -c.radius * c.n;
  }
}

std::optional<std::string> missing_contact(const Scene& scene) try {
  if (!scene.joints.empty()) return "joints";
  std::vector<Contact> contacts = contacts_of(scene);
  std::vector<Body> bodies;
  for (const core::Body& body : scene.bodies) bodies.push_back(make_body(body, {}));
  update_contacts(scene, bodies, {}, contacts);
  for (const Contact& contact : contacts)
    if (contact.gap < 1e-6 && contact.radius == 0) return "a box that rests";
  return std::nullopt;
} catch (const std::invalid_argument& error) {
  return error.what();
}

}  // namespace cylon::mutants::seed
