#include "reference/simulators/siconos/siconos_scene.h"

namespace cylon::simulators {
namespace {

using core::Scene;

std::size_t at(int i) { return static_cast<std::size_t>(i); }
double radius(const core::Body& body) { return std::get<core::Sphere>(body.shape).radius; }

siconos_border::Body border_body(const core::Body& body) {
  const core::BodyState& start = body.initial;
  const core::Quaternion& q = start.orientation;
  siconos_border::Body one;
  one.mass = body.mass;
  for (int r = 0; r < 3; ++r)
    for (int c = 0; c < 3; ++c) one.inertia[at(3 * r + c)] = body.inertia(r, c);
  one.start = {to_siconos(start.position),
               {q.w(), q.x(), q.y(), q.z()},
               to_siconos(start.velocity),
               to_siconos(q.conjugate() * start.angular_velocity)};
  return one;
}

}  // namespace

SiconosScene siconos_scene(const Scene& scene) {
  SiconosScene all;
  for (const core::Body& body : scene.bodies) {
    all.index.push_back(body.locked ? -1 : static_cast<int>(all.bodies.size()));
    if (!body.locked) all.bodies.push_back(border_body(body));
  }
  for (core::Pair pair : core::touching_pairs(scene)) {
    if (scene.bodies[at(pair.body)].locked) std::swap(pair.body, pair.other);
    const core::Material material = *core::material_of(scene, pair);
    siconos_border::Contact contact;
    contact.body = all.index[at(pair.body)];
    contact.radius = radius(scene.bodies[at(pair.body)]);
    contact.restitution = material.restitution, contact.friction = material.friction;
    if (pair.plane >= 0) {
      const core::Plane& plane = scene.planes[at(pair.plane)];
      contact.place = to_siconos(plane.normal), contact.measure = plane.offset;
    } else {
      const core::Body& other = scene.bodies[at(pair.other)];
      contact.partner =
          other.locked ? siconos_border::Partner::still_sphere : siconos_border::Partner::moving_sphere;
      contact.other = all.index[at(pair.other)];
      contact.place = to_siconos(other.initial.position), contact.measure = radius(other);
    }
    all.contacts.push_back(contact);
    all.pairs.push_back(pair);
  }
  return all;
}

}  // namespace cylon::simulators
